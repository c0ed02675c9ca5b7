import type { TimePlotSpec } from './spec';

const known = new Map<string, TimePlotSpec>();

/** Makes a plot's values known to `plots`. */
export function register(spec: TimePlotSpec): void {
  known.set(spec.title, spec);
}

const curveOf = (plot: string, column: string, run: number) =>
  known.get(plot)?.curves.find((curve) => curve.column === column && curve.run === run);

/** Reads what the plots show, in SI units: for tests, and for the browser's console. */
export const plots = {
  titles: (): string[] => [...known.keys()],
  columns: (plot: string): string[] => known.get(plot)?.curves.map(({ column }) => column) ?? [],
  length: (plot: string, column: string, run = 0): number =>
    curveOf(plot, column, run)?.values.length ?? 0,
  time: (plot: string, column: string, index: number, run = 0): number =>
    curveOf(plot, column, run)?.times[index] ?? NaN,
  /** Value of a column, as named in history.csv, in its row `index` [SI]. */
  value: (plot: string, column: string, index: number, run = 0): number =>
    curveOf(plot, column, run)?.values[index] ?? NaN,
};
