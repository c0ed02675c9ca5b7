import type { Ensemble } from '../model/bundle';
import type { Curve, MeanBand, Section, TimePlotSpec } from './spec';

const colour = '--curve-0';

/** The value of a curve at a time: on the line between its samples, or of the step. */
export function valueAt({ times, values, until }: Curve, time: number): number {
  const last = times.length - 1;
  if (last < 0 || time < times[0]! || time > (until ?? times[last]!)) return NaN;
  let [low, high] = [0, last];
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if (times[middle]! <= time) low = middle;
    else high = middle - 1;
  }
  if (low === last || until !== null) return values[low]!;
  const part = (time - times[low]!) / (times[low + 1]! - times[low]!);
  return values[low]! + part * (values[low + 1]! - values[low]!);
}

/** Mean and 95 % half width of the members' values at one time; NaN where one lacks it. */
function meanAt(members: readonly Curve[], time: number, student: number): [number, number] {
  const values = members.map((member) => valueAt(member, time));
  const n = values.length;
  const mean = values.reduce((sum, value) => sum + value, 0) / n;
  const squares = values.reduce((sum, value) => sum + (value - mean) ** 2, 0);
  return [mean, student * Math.sqrt(squares / ((n - 1) * n))];
}

/** The mean of members at the times of the first, with the band that holds the true mean. */
function meanCurve(members: readonly Curve[], student: number): Curve {
  const first = members[0]!;
  const points = Array.from(first.times, (time) => meanAt(members, time, student));
  return {
    ...first,
    label: `mean of ${members.length} members`,
    colour,
    dash: [],
    faint: false,
    width: 2,
    values: Float64Array.from(points, ([mean]) => mean),
    band: Float64Array.from(points, ([, half]) => half),
  };
}

/** The pooled mean over the window, in place of the members' own. */
function bandsOf(curve: Curve, plot: TimePlotSpec, ensemble: Ensemble): MeanBand[] {
  const row = ensemble.rows.find(({ name }) => name === plot.quantity);
  const [own] = plot.bands;
  return row && own ? [{ ...own, curve, mean: row.mean, halfWidth: row.half_width }] : [];
}

/** The members of a plot standing back behind their mean, which has one entry in the legend. */
function poolPlot(plot: TimePlotSpec, ensemble: Ensemble): TimePlotSpec {
  const smooth = plot.curves.filter(({ column }) => column.endsWith('(running mean)'));
  const members = smooth.length > 0 ? smooth : plot.curves;
  if (members.length < 2) return plot;
  const mean = meanCurve(members, ensemble.student ?? NaN);
  const back = members.map((member) => ({
    ...member,
    colour,
    dash: [],
    width: 1,
    faint: true,
    with: mean,
  }));
  return {
    ...plot,
    curves: [...back, mean],
    bands: bandsOf(mean, plot, ensemble),
  };
}

/** Plots of an ensemble, from those that compare its members. */
export function poolSections(sections: Section[], ensemble: Ensemble): Section[] {
  return sections.map((section) => ({
    ...section,
    plots: section.plots.map((plot) => poolPlot(plot, ensemble)),
  }));
}
