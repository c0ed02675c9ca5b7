/** A moment between two frames: `part` of the way from `frame` to `next`. */
export interface Moment {
  frame: number;
  next: number;
  part: number;
}

/** The moment of a time; before the first and behind the last frame, that frame. */
export function momentAt(times: readonly number[], time: number): Moment {
  const frame = frameAt(times, time);
  const next = Math.min(frame + 1, Math.max(times.length - 1, 0));
  if (next === frame) return { frame, next, part: 0 };
  const part = (time - times[frame]!) / (times[next]! - times[frame]!);
  return { frame, next, part: Math.abs(part) < 1e-6 ? 0 : Math.min(Math.max(part, 0), 1) };
}

/** Number of the last time not later than `time`, 0 before the first. */
export function frameAt(times: readonly number[], time: number): number {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if (times[middle]! <= time + 1e-9) low = middle;
    else high = middle - 1;
  }
  return Math.max(low, 0);
}

/** Decimal places that tell the times of frames [s] apart, by the middle one of their distances. */
export function decimalsFor(times: readonly number[]): number {
  const steps = times.slice(1).map((time, i) => time - times[i]!);
  const middle = steps.sort((a, b) => a - b)[Math.floor(steps.length / 2)] ?? 0;
  if (!(middle > 0)) return 3;
  return Math.min(Math.max(1 - Math.floor(Math.log10(middle)), middle < 1 ? 3 : 1), 9);
}
