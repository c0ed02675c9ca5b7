import { Clock } from './model/clock';
import { parseTable } from './model/csv';
import { chunkReader, DataError, readBundle } from './model/decode';
import { loadRun, type LoadedRun } from './model/run';
import { Store } from './model/store';
import { buildApi } from './page/api';
import { beside } from './page/beside';
import { buildComparison } from './page/comparison';
import { buildDetails } from './page/details';
import { buildEnsemble, buildMembers } from './page/ensemble';
import { make } from './dom';
import { buildHead } from './page/head';
import { buildKeys } from './page/keys';
import { savePicture } from './page/save';
import './page/style.css';
import { buildSummary } from './page/summary';
import { buildTimeline, keepTime } from './page/timeline';
import { buildToolbar } from './page/toolbar';
import './page/views.css';
import { buildPlots, plots } from './plots/plots';
import {
  choicesFor,
  commonPeriod,
  initialSettings,
  type Choices,
  type Settings,
} from './scene/settings';
import { createRenderer, Stage } from './scene/stage';

const MOST_VIEWS = 3; // of an ensemble's members

/** Puts the page together, or says why it cannot. */
async function main(page: HTMLElement): Promise<void> {
  try {
    await build(page);
  } catch (error) {
    const known = error instanceof DataError;
    const text = known ? error.message : `This page cannot be shown: ${String(error)}`;
    page.replaceChildren(message(text));
    if (!known) throw error;
  }
}

async function build(page: HTMLElement): Promise<void> {
  page.replaceChildren(make('p', 'loading', 'Reading the run …'));
  const bundle = readBundle(document);
  const read = chunkReader(document);
  const runs = await Promise.all(bundle.runs.map((index) => loadRun(index, read)));
  const clock = new Clock(timesOf(runs));
  const choices = choicesFor(runs);
  const settings = new Store(initialSettings(choices));
  const seen = bundle.ensemble ? runs.slice(0, MOST_VIEWS) : runs;
  const stage = stageFor(seen, clock, settings);
  const headed = bundle.ensemble ? [] : bundle.runs;
  document.title = `${bundle.runs.map(({ name }) => name).join(', ')} – Washtub`;
  page.replaceChildren(
    make('header', 'head', ...headed.map(buildHead)),
    section('comparison', bundle.ensemble && buildEnsemble(bundle.ensemble)),
    section('comparison', bundle.comparison && buildComparison(bundle.comparison, bundle.runs)),
    beside(
      make('section', 'views', ...viewsOf(seen, stage)),
      buildControls(runs, clock, settings, choices, stage),
      section('plots', buildPlots(runs, clock, bundle.ensemble)),
    ),
    section('summary', buildSummary(bundle.runs)),
    section('members', bundle.ensemble && buildMembers(bundle.runs)),
    section('details', buildDetails(bundle.runs, bundle.program)),
  );
  stage?.start();
  keepTime(clock);
  window.washtub = { ...buildApi(clock, settings, stage), plots };
}

function section(name: string, contents: HTMLElement | null): HTMLElement {
  return make('section', name, ...(contents ? [contents] : []));
}

/** Timeline, choices and keys. */
function buildControls(
  runs: LoadedRun[],
  clock: Clock,
  settings: Store<Settings>,
  choices: Choices,
  stage: Stage | null,
): HTMLElement {
  const save = () => stage && savePicture(stage, runs, clock);
  const keys = buildKeys({ clock, settings, choices, stage, save });
  const timeline = buildTimeline(clock, commonPeriod(runs), stage);
  if (!stage) return make('section', 'controls', timeline, keys);
  const toolbar = buildToolbar(settings, choices, {
    reset: () => stage.look('slanted'),
    side: () => stage.look('side'),
    top: () => stage.look('top'),
    save,
    keys: () => keys.showModal(),
  });
  return make('section', 'controls', timeline, toolbar, keys);
}

const NO_WEBGL =
  'The views need WebGL 2, which this browser does not offer or which is switched off. ' +
  'The plots and tables below work without it.';
const NO_FRAMES = 'No frames were kept, so there is nothing to see but the plots and tables.';

/** The views, or why there are none. */
function viewsOf(runs: readonly LoadedRun[], stage: Stage | null): HTMLElement[] {
  if (stage) return stage.elements;
  return [message(anyFrames(runs) ? NO_WEBGL : NO_FRAMES)];
}

function anyFrames(runs: readonly LoadedRun[]): boolean {
  return runs.some((run) => run.times.length > 0);
}

function message(text: string): HTMLElement {
  const element = make('p', 'message', text);
  element.setAttribute('role', 'alert');
  return element;
}

function stageFor(runs: LoadedRun[], clock: Clock, settings: Store<Settings>): Stage | null {
  if (!anyFrames(runs)) return null;
  const renderer = createRenderer();
  return renderer && new Stage(runs, clock, settings, renderer);
}

/** The frames' times of all runs, each once; those of the histories' ends without frames. */
function timesOf(runs: readonly LoadedRun[]): number[] {
  const times = anyFrames(runs) ? runs.flatMap((run) => [...run.times]) : runs.flatMap(endsOf);
  const sorted = times.sort((a, b) => a - b);
  return sorted.filter((time, i) => i === 0 || time - sorted[i - 1]! > 1e-9);
}

function endsOf({ history }: LoadedRun): number[] {
  const times = history ? (parseTable(history).columns[0]?.values ?? []) : [];
  return times.length > 0 ? [times[0]!, times[times.length - 1]!] : [];
}

void main(document.getElementById('page')!);
