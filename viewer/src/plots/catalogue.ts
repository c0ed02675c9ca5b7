import type { Quantity } from '../model/bundle';
import { findColumn } from '../model/csv';
import { runningMean, type Series } from './derived';
import { entriesFor } from './entries';
import type { Curve, MeanBand, RunTables, Section, TimePlotSpec } from './spec';
import type { Entry, Wanted } from './wanted';

const curveColours = 8;
const dashes = [[], [8, 4], [2, 3], [10, 3, 2, 3]];
const order = [
  'Cloth',
  'Torque and energy',
  'Error against the exact solution',
  'Probes',
  'Forces',
  'Water',
  'Parts of the torque',
  'Other',
  'Numerics',
];
const closed = ['Parts of the torque', 'Other', 'Numerics'];

/** Custom property with the colour of a curve. */
export function curveColour(number: number): string {
  return `--curve-${number % curveColours}`;
}

/** Colour and dash of a run in a comparison. */
export function runStyle(run: number): { colour: string; dash: number[] } {
  return { colour: curveColour(run), dash: dashes[run % dashes.length]! };
}

type Taken = Series & { unit: string; end?: number };

function take(run: RunTables, wanted: Wanted): Taken | null {
  if (wanted.take) return wanted.take(run);
  const time = findColumn(run.history, 'time');
  const column = findColumn(run.history, wanted.column);
  return time && column && { times: time.values, values: column.values, unit: column.unit };
}

type Style = Pick<Curve, 'label' | 'run' | 'colour' | 'dash'>;

function makeCurve(wanted: Wanted, taken: Taken, style: Style): Curve {
  const { times, values } = taken;
  const shown = wanted.shown !== false;
  const until = taken.end ?? null;
  const width = until === null ? 1.5 : 2.5;
  const { column, meaning = '' } = wanted;
  const plain = { faint: false, with: null, band: null };
  return { ...style, ...plain, column, meaning, times, values, width, until, shown };
}

/** The curve, with its running mean where one is wanted and the rows are close enough. */
function curvesOf(run: RunTables, wanted: Wanted, taken: Taken, style: Style): Curve[] {
  const curve = makeCurve(wanted, taken, style);
  const mean = wanted.smooth ? runningMean(taken, run.index.scales.period / 20) : null;
  if (!mean) return [curve];
  const label = `${style.label}, mean over 1/20 cycle`;
  const smooth = {
    ...curve,
    ...mean,
    label,
    column: `${wanted.column} (running mean)`,
    width: 2.5,
  };
  return [{ ...curve, faint: true }, smooth];
}

function bandOf(run: RunTables, wanted: Wanted, unit: string, curve: Curve): MeanBand[] {
  const fits = (q: Quantity) => q.name === wanted.quantity && q.unit === unit;
  const quantity = run.index.quantities.find(fits);
  if (!quantity) return [];
  const [from, to] = run.index.averaged;
  return [{ curve, mean: quantity.mean, halfWidth: quantity.half_width, from, to }];
}

/** The statistics windows of the runs, each different one once. */
function windowsOf(runs: RunTables[]): [number, number][] {
  const windows = runs.map((run) => run.index.window).filter(([from, to]) => to > from);
  return [...new Map(windows.map((window) => [window.join(), window])).values()];
}

/** The scale of stress or torque, if all runs have the same. */
function scaleOf(runs: RunTables[], entry: Entry): TimePlotSpec['scale'] {
  const kind = entry.scale;
  if (!kind) return null;
  const sizes = new Set(runs.map((run) => run.index.scales[kind]));
  const size = runs[0]!.index.scales[kind];
  return sizes.size === 1 && size > 0 ? { size, symbol: kind === 'stress' ? 'σₒ' : 'τₒ' } : null;
}

function plotOf(runs: RunTables[], entry: Entry, styled: StyledCurve[]): TimePlotSpec | null {
  const plot: TimePlotSpec = {
    title: entry.title,
    name: entry.name,
    unit: '',
    scale: scaleOf(runs, entry),
    logarithmic: entry.logarithmic ?? false,
    note: entry.note ?? '',
    quantity: entry.curves[0]?.quantity ?? '',
    curves: [],
    bands: [],
    windows: windowsOf(runs),
  };
  for (const { wanted, style } of styled) {
    const run = runs[style.run]!;
    const taken = take(run, wanted);
    if (!taken || taken.times.length < 1) continue;
    plot.unit = taken.unit;
    const curves = curvesOf(run, wanted, taken, style);
    plot.curves.push(...curves);
    plot.bands.push(...bandOf(run, wanted, taken.unit, curves[0]!));
  }
  return plot.curves.length > 0 ? plot : null;
}

interface StyledCurve {
  wanted: Wanted;
  style: Style;
}

/** Curves of one run, each with its colour. */
function withinRun(entry: Entry): StyledCurve[] {
  return entry.curves.map((wanted, i) => ({
    wanted,
    style: { label: wanted.label, run: 0, colour: curveColour(i), dash: [] },
  }));
}

/** A curve of an entry for each run, each with its colour. */
function acrossRuns(entry: Entry, runs: RunTables[]): StyledCurve[] {
  return runs.flatMap(({ index }, run) =>
    entry.curves.map((wanted) => ({
      wanted,
      style: { label: index.name, run, ...runStyle(run) },
    })),
  );
}

/** An entry for each curve, as a comparison needs: its runs share the plot. */
function separate(entry: Entry): Entry[] {
  return entry.curves.map((wanted) => ({
    ...entry,
    curves: [{ ...wanted, shown: true }],
    section: wanted.shown === false ? 'Parts of the torque' : entry.section,
    title: entry.curves.length === 1 ? entry.title : `${entry.title}: ${wanted.label}`,
  }));
}

function isOpen(section: string, hasCloth: boolean): boolean {
  if (closed.includes(section)) return false;
  return !hasCloth || (section !== 'Forces' && section !== 'Water');
}

/**
 * All plots over time that the runs' columns allow: of one run with its parts in one plot, of
 * several runs with one quantity in a plot.
 */
export function catalogue(runs: RunTables[]): Section[] {
  const sections = new Map<string, TimePlotSpec[]>();
  for (const entry of entriesFor(runs)) {
    for (const part of runs.length > 1 ? separate(entry) : [entry]) {
      const styled = runs.length > 1 ? acrossRuns(part, runs) : withinRun(part);
      const plot = plotOf(runs, part, styled);
      if (plot) sections.set(part.section, [...(sections.get(part.section) ?? []), plot]);
    }
  }
  const hasCloth = runs.some(({ index }) => index.cloth !== null);
  return order
    .map((title) => ({ title, open: isOpen(title, hasCloth), plots: sections.get(title) ?? [] }))
    .filter(({ plots }) => plots.length > 0);
}
