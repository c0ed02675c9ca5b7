import 'uplot/dist/uPlot.min.css';
import type { Ensemble } from '../model/bundle';
import type { Clock } from '../model/clock';
import { findColumn, parseTable } from '../model/csv';
import type { LoadedRun } from '../model/run';
import { commonWindow, TimeAxis } from './axis';
import { catalogue } from './catalogue';
import { button, element } from '../dom';
import { poolSections } from './ensemble';
import { pieceSection } from './pieces';
import { register } from './registry';
import type { RunTables, Section } from './spec';
import { buildTimePlot, type PlotPage } from './timeplot';
import { buildTrackPlot } from './trackplot';

export { plots } from './registry';

const hint =
  'Point at a curve for values, click or drag to set the time. Shift + drag or Shift + wheel zooms, a double click shows all. Click on a name to hide its curve.';

const windowHint =
  ' Grey: the statistics window. Dashed: the mean over it, in a band that is its 95 % interval; one wider than the plot is left out.';

type Readable = Pick<LoadedRun, 'index' | 'history' | 'tracks'>;

/** All plots of the runs, on one time axis and tied to the clock. */
export function buildPlots(
  runs: Readable[],
  clock: Clock,
  ensemble: Ensemble | null = null,
): HTMLElement {
  const tables = runs.map(readTables);
  const compared = catalogue(tables);
  const common = ensemble ? poolSections(compared, ensemble) : compared;
  const sections = [...common, pieceSection(tables)].filter((s) => s !== null);
  for (const plot of sections.flatMap((section) => section.plots)) register(plot);
  const axis = new TimeAxis(clock, wholeTime(tables, clock));
  const missing = tables
    .filter(({ history }) => history === null)
    .map(({ index }) =>
      element('p', { class: 'note' }, `${index.name} has no history.csv to plot.`),
    );
  const tracks = trackSection(tables, axis);
  const scaled = sections.some(({ plots }) => plots.some(({ scale }) => scale !== null));
  const page = { axis, runs: runs.map(({ index }) => index.name), scaled };
  const folds = sections.map((section) => buildSection(section, page));
  folds.splice(Math.min(1, folds.length), 0, ...(tracks ? [tracks] : []));
  return element('div', { class: 'plot-list' }, buildHead(tables, axis), ...missing, ...folds);
}

function readTables({ index, history, tracks }: Readable): RunTables {
  return { index, history: readTable(history), tracks: readTable(tracks) };
}

/** A table with a time in each row, or none. */
function readTable(text: string | null): RunTables['history'] {
  const table = text === null ? null : parseTable(text);
  return table && table.rows > 0 && findColumn(table, 'time') ? table : null;
}

/** From the first to the last time that history or frames know. */
function wholeTime(tables: RunTables[], clock: Clock): [number, number] {
  const times = tables.map(({ history }) => findColumn(history, 'time')?.values);
  const ends = times.flatMap((t) => (t ? [t[0]!, t.at(-1)!] : []));
  const all = [...ends, clock.begin, clock.end];
  const [begin, end] = [Math.min(...all), Math.max(...all)];
  return [begin, end > begin ? end : begin + 1];
}

/** Title, how to use the plots, and buttons that choose the time shown. */
function buildHead(tables: RunTables[], axis: TimeAxis): HTMLElement {
  const window = commonWindow(
    tables.map(({ index }) => index.window),
    axis.whole,
  );
  const show = window && (() => axis.show(...window));
  const head = element(
    'div',
    { class: 'plot-head' },
    element('h2', {}, 'Plots'),
    element('a', { href: '#statistics' }, 'Statistics'),
    button('Whole run', 'Show all time', () => axis.reset()),
    show && button('Statistics window', 'Show the time of the statistics', show),
  );
  const note = element('p', { class: 'note' }, window ? hint + windowHint : hint);
  return element('div', {}, head, note);
}

/** A fold whose plots are built when it is opened for the first time. */
function buildFold(title: string, open: boolean, build: () => HTMLElement[]): HTMLElement {
  const fold = element('details', { class: 'plot-section' });
  fold.append(element('summary', {}, element('h3', {}, title)));
  let built = false;
  const fill = () => {
    if (!fold.open || built) return;
    built = true;
    fold.append(element('div', { class: 'plot-grid' }, ...build()));
  };
  fold.addEventListener('toggle', fill);
  fold.open = open;
  fill();
  return fold;
}

function buildSection(section: Section, page: PlotPage): HTMLElement {
  return buildFold(section.title, section.open, () =>
    section.plots.map((plot) => buildTimePlot(plot, page)),
  );
}

function trackSection(tables: RunTables[], axis: TimeAxis): HTMLElement | null {
  const several = tables.length > 1;
  const made = tables.map((run) =>
    buildTrackPlot(run, axis, several ? run.index.name : 'Height over radius'),
  );
  const present = made.filter((plot) => plot !== null);
  return present.length > 0 ? buildFold('Tracks of the pieces', true, () => present) : null;
}
