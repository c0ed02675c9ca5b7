import * as THREE from 'three';
import { frameAt, momentAt } from '../model/moment';
import { centreAt } from '../model/between';
import type { LoadedRun, Motion } from '../model/run';
import { channels, colourOf } from './colours';
import { linear } from './linear';
import { buildLines, type Lines } from './lines';
import type { Part, Showing } from './part';

/** Most segments drawn; longer trails get fewer per frame, then leave out frames. */
const SEGMENTS = 40_000;
/** Segments from one frame to the next, where the pieces' centres turn about the axis. */
const PER_FRAME = 8;
/** Width of a trail [pixels], and what is left of it behind cloth and solids. */
const WIDTH = 3.5;
const BEHIND = 0.3;

/** Trails of the pieces' centres over the last seconds, which fade with age. */
export function buildTrails(run: LoadedRun): Part | null {
  const { motion } = run;
  const pieces = run.index.cloth?.pieces.length ?? 0;
  if (!motion || pieces === 0 || run.times.length < 2) return null;
  const most = Math.max(SEGMENTS, pieces);
  const plane = run.index.dimension === 2;
  const lines = buildLines(most, WIDTH, plane ? { above: true, order: 2 } : { behind: BEHIND });
  return {
    object: lines.object,
    update(showing) {
      lines.rim(showing.theme.background);
      const shown = showing.settings.trails > 0;
      lines.send(shown ? writeTrails(run, motion, Math.floor(most / pieces), showing, lines) : 0);
    },
  };
}

/** Times of a trail's points [s], from its begin to now: the frames and some between them. */
export function trailTimes(
  times: readonly number[],
  begin: number,
  now: number,
  most: number,
): number[] {
  const [first, last] = [frameAt(times, begin), frameAt(times, now)];
  const frames = last - first + 1;
  const fine = Math.min(Math.max(Math.floor(most / frames), 1), PER_FRAME);
  const stride = Math.ceil(frames / most);
  const points: number[] = [];
  for (let frame = first; frame <= last; frame += stride)
    for (let i = 0; i < fine; i++) {
      const next = times[Math.min(frame + stride, times.length - 1)]!;
      points.push(times[frame]! + (i / fine) * (next - times[frame]!));
    }
  const from = Math.max(begin, times[0] ?? begin);
  return [from, ...points.filter((time) => time > from && time < now), now];
}

/** Writes all trails and returns the number of segments. */
function writeTrails(
  run: LoadedRun,
  motion: Motion,
  most: number,
  { time, moment, settings, theme }: Showing,
  lines: Lines,
): number {
  const now = run.times[moment.frame]! + moment.part * spanOf(run.times, moment);
  const times = trailTimes(run.times, time - settings.trails, now, most - 2);
  const moments = times.map((at) => momentAt(run.times, at));
  const fresh = times.map((at) => 1 - Math.min((time - at) / settings.trails, 1));
  const background = new THREE.Color(theme.background).toArray();
  let segment = 0;
  for (let piece = 0; piece < motion.pieces.length; piece++) {
    const hue = colourOf(run.index.cloth!, piece, settings.colour === 'group');
    const colour = channels(hue).map((level) => linear[level]!);
    for (let i = 0; i + 1 < times.length; i++, segment++)
      for (let end = 0; end < 2; end++) {
        const at = 6 * segment + 3 * end;
        centreAt(motion, piece, moments[i + end]!, lines.ends, at);
        const strength = 0.3 + 0.7 * fresh[i + end]!;
        for (let c = 0; c < 3; c++)
          lines.colours[at + c] = background[c]! + strength * (colour[c]! - background[c]!);
      }
  }
  return segment;
}

/** Time from a moment's frame to its next [s]. */
function spanOf(times: readonly number[], { frame, next }: Showing['moment']): number {
  return times[next]! - times[frame]!;
}
