import { fieldFrame } from '../model/field';
import { decimalsFor, type Moment } from '../model/moment';
import type { LoadedRun } from '../model/run';
import type { Settings } from './settings';

/** Time, and cycles of the stroke where there is one. */
export function timeText(time: number, period: number, decimals: number): string {
  const cycles = period > 0 ? `  ·  cycle ${(time / period).toFixed(2)}` : '';
  return `${plainTime(time, decimals)}${cycles}`;
}

function plainTime(time: number, decimals: number): string {
  return `t = ${time.toFixed(decimals)} s`;
}

/** Time of what is shown [s]. */
export function timeShown({ times }: LoadedRun, moment: Moment, time: number): number {
  const from = times[moment.frame] ?? time;
  return from + moment.part * ((times[moment.next] ?? from) - from);
}

/** What the reader must know of what is shown, besides its time; mostly empty. */
export function noticeFor(
  run: LoadedRun,
  time: number,
  moment: Moment,
  settings: Readonly<Settings>,
): string {
  const { times, field } = run;
  if (times.length === 0) return 'This run kept no frames.';
  const shown = times[moment.frame]!;
  const decimals = decimalsFor(times);
  if (moment.frame === times.length - 1 && time > shown + 1e-6)
    return `ended at ${plainTime(shown, decimals)}: last frame`;
  const water = field && settings.slice !== 'off' ? field.times[fieldFrame(field, shown)]! : shown;
  if (Math.abs(water - shown) > 1e-9) return `water of ${plainTime(water, decimals)}`;
  return moment.part > 0 ? 'between frames' : '';
}
