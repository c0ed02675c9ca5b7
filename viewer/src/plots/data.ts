import uPlot from 'uplot';
import { csvLine } from '../model/csv';
import { displayOf, type Display } from './format';
import type { Curve, TimePlotSpec } from './spec';

type Values = Float64Array | (number | null)[];

/** The largest value that a plot's curves reach, without its sign [SI]. */
export function largestOf(spec: TimePlotSpec): number {
  let largest = 0;
  for (const curve of spec.curves)
    for (const value of curve.values)
      if (Number.isFinite(value)) largest = Math.max(largest, Math.abs(value));
  return largest;
}

/** Unit and prefix of a plot: by the largest value that its curves reach. */
export function displayFor(spec: TimePlotSpec): Display {
  return displayOf(spec.unit, largestOf(spec));
}

/** Whether the vertical axis is logarithmic: where the plot wants it and has a value for it. */
export function isLogarithmic(spec: TimePlotSpec): boolean {
  return spec.logarithmic && spec.curves.some(({ values }) => values.some((value) => value > 0));
}

/** Values as drawn: a gap (null) where there is no number, or none that a logarithm takes. */
function drawn(curve: Curve, factor: number, logarithmic: boolean): Values {
  const fits = (value: number) => Number.isFinite(value) && !(logarithmic && value <= 0);
  if (curve.values.every(fits)) return curve.values.map((value) => value * factor);
  return Array.from(curve.values, (value) => (fits(value) ? value * factor : null));
}

/** Times and values, with the end of the last step. */
function lineOf(curve: Curve, factor: number, logarithmic: boolean): [Values, Values] {
  const values = drawn(curve, factor, logarithmic);
  if (curve.until === null) return [curve.times, values];
  return [
    [...curve.times, curve.until],
    [...values, values.at(-1) ?? null],
  ];
}

/** The curves over one common row of times, as uPlot wants them. */
export function alignedData(spec: TimePlotSpec, factor: number): uPlot.AlignedData {
  const logarithmic = isLogarithmic(spec);
  const lines = spec.curves.map((curve) => lineOf(curve, factor, logarithmic));
  const [times] = lines[0]!;
  if (lines.every(([other]) => other === times))
    return [times, ...lines.map(([, values]) => values)] as uPlot.AlignedData;
  return uPlot.join(lines.map((line) => line as uPlot.AlignedData));
}

/** A number as it is; nothing where there is none. */
export function cell(value: number | undefined): string {
  return value === undefined || Number.isNaN(value) ? '' : String(value);
}

/** The plot as a table with SI units in its header; cells without a value are empty. */
export function csvOf(spec: TimePlotSpec, runs: readonly string[]): string {
  const prefix = (curve: Curve) => (runs.length > 1 ? `${runs[curve.run]}: ` : '');
  const unit = spec.unit === '' ? '' : ` [${spec.unit}]`;
  const data = new Map<number, (number | undefined)[]>();
  spec.curves.forEach((curve, column) => {
    curve.times.forEach((time, i) => {
      const row = data.get(time) ?? [];
      row[column] = curve.values[i];
      data.set(time, row);
    });
  });
  const names = spec.curves.map((curve) => `${prefix(curve)}${curve.column}${unit}`);
  const rows = [...data].sort(([a], [b]) => a - b);
  const lines = rows.map(([time, row]) => csvLine([time, ...names.map((_, c) => cell(row[c]))]));
  return [csvLine(['time [s]', ...names]), ...lines, ''].join('\n');
}
