import { findColumn, type Table } from '../model/csv';

/** Values over time [s], SI. */
export interface Series {
  times: Float64Array;
  values: Float64Array;
}

/**
 * Where the cycles begin that the samples cover, so that one of them begins with the statistics
 * window [s]; the last entry is the end of the last whole cycle.
 */
export function cycleBounds(times: Float64Array, windowBegin: number, period: number): number[] {
  if (times.length < 2 || !(period > 0)) return [];
  const slack = 1e-9 * period;
  const first = Math.ceil((times[0]! - windowBegin) / period - 1e-6);
  const bounds: number[] = [];
  for (let k = first; windowBegin + k * period <= times.at(-1)! + slack; ++k)
    bounds.push(windowBegin + k * period);
  return bounds;
}

/**
 * Integral of a history column over each interval between neighbouring bounds. A sample's value is
 * the mean since the sample before; one that is partly inside counts in proportion.
 */
export function integrate(samples: Series, bounds: readonly number[]): Float64Array {
  const { times, values } = samples;
  const sums = new Float64Array(Math.max(bounds.length - 1, 0));
  for (let i = 1, first = 0; i < times.length; ++i) {
    const [from, to] = [times[i - 1]!, times[i]!];
    while (first < sums.length && bounds[first + 1]! <= from) ++first;
    for (let k = first; k < sums.length && bounds[k]! < to; ++k) {
      const overlap = Math.min(to, bounds[k + 1]!) - Math.max(from, bounds[k]!);
      if (overlap > 0) sums[k]! += values[i]! * overlap;
    }
  }
  return sums;
}

/** Work of a moving solid in each whole cycle, at the cycles' begins [J], and the end [s]. */
export function energyPerCycle(
  power: Series,
  windowBegin: number,
  period: number,
): (Series & { end: number }) | null {
  const bounds = cycleBounds(power.times, windowBegin, period);
  if (bounds.length < 2) return null;
  const times = Float64Array.from(bounds.slice(0, -1));
  return { times, values: integrate(power, bounds), end: bounds.at(-1)! };
}

/** Number of pieces of cloth that tracks.csv follows. */
export function pieceCount(tracks: Table | null): number {
  return tracks?.columns.filter((column) => /^piece \d+ r$/.test(column.name)).length ?? 0;
}

/** Values of one coordinate ("r", "z") or the stress of a piece, counted from 1. */
export function pieceColumn(tracks: Table, piece: number, what: string): Float64Array | null {
  return findColumn(tracks, `piece ${piece} ${what}`)?.values ?? null;
}

/**
 * At each time, the rms distance of the pieces' centres from their common centre in the (r, z)
 * plane [m]. Pieces count alike; those without a number do not count.
 */
export function scatterOverTime(tracks: Table): Series | null {
  const time = findColumn(tracks, 'time');
  const count = pieceCount(tracks);
  if (!time || count < 2) return null;
  const variance = new Float64Array(tracks.rows);
  for (const coordinate of ['r', 'z']) {
    const pieces = Array.from({ length: count }, (_, p) => pieceColumn(tracks, p + 1, coordinate));
    for (let i = 0; i < tracks.rows; ++i)
      variance[i]! += varianceOf(pieces.map((piece) => piece?.[i] ?? NaN).filter(Number.isFinite));
  }
  return { times: time.values, values: variance.map(Math.sqrt) };
}

/** Mean square distance of numbers from their mean; NaN where there are fewer than two. */
function varianceOf(numbers: readonly number[]): number {
  if (numbers.length < 2) return NaN;
  const mean = numbers.reduce((sum, x) => sum + x, 0) / numbers.length;
  return numbers.reduce((sum, x) => sum + (x - mean) ** 2, 0) / numbers.length;
}

/**
 * Mean over the samples within half a `width` [s] of each; null where that would hold fewer than
 * four samples, and so smooth nothing. Samples that are no numbers do not count.
 */
export function runningMean({ times, values }: Series, width: number): Series | null {
  const span = (times.at(-1) ?? 0) - (times[0] ?? 0);
  if (!(width > 0) || !(span > 0) || (width * (times.length - 1)) / span < 4) return null;
  const means = new Float64Array(values.length);
  let [sum, count] = [0, 0];
  const add = (sample: number, sign: 1 | -1) => {
    if (!Number.isFinite(values[sample])) return;
    sum += sign * values[sample]!;
    count += sign;
  };
  for (let i = 0, from = 0, to = 0; i < times.length; ++i) {
    while (to < times.length && times[to]! <= times[i]! + width / 2) add(to++, 1);
    while (times[from]! < times[i]! - width / 2) add(from++, -1);
    means[i] = count > 0 ? sum / count : NaN;
  }
  return { times, values: means };
}
