import * as THREE from 'three';
import type { LoadedRun, Motion } from '../model/run';
import { channels, pieceColour } from './colours';
import { linear } from './linear';
import { buildLines, type Lines } from './lines';
import { frameAt } from '../model/moment';
import type { Part, Showing } from './part';

/** Most segments drawn; longer trails leave out frames. */
const SEGMENTS = 40_000;

/** Trails of the pieces' centres over the last seconds, which fade with age. */
export function buildTrails(run: LoadedRun): Part | null {
  const { motion } = run;
  const pieces = run.index.cloth?.pieces.length ?? 0;
  if (!motion || pieces === 0 || run.times.length < 2) return null;
  const most = Math.min(run.times.length * pieces, Math.max(SEGMENTS, pieces));
  const lines = buildLines(most, 2, run.index.dimension === 2, 2);
  const draw = trailWriter(run, motion, pieces, Math.floor(most / pieces), lines);
  return {
    object: lines.object,
    update(showing) {
      lines.rim(showing.theme.background);
      lines.send(showing.settings.trails > 0 ? draw(showing) : 0);
    },
  };
}

/** Writes all trails and returns the number of segments. */
function trailWriter(
  run: LoadedRun,
  motion: Motion,
  pieces: number,
  most: number,
  lines: Lines,
): (showing: Showing) => number {
  const centre = (frame: number, piece: number, axis: number) =>
    motion.centres[(frame * pieces + piece) * 3 + axis]!;
  return ({ time, moment, settings, theme }) => {
    const oldest = frameAt(run.times, time - settings.trails);
    const stride = Math.max(1, Math.ceil((moment.frame - oldest + 1) / most));
    const background = new THREE.Color(theme.background).toArray();
    let segment = 0;
    for (let piece = 0; piece < pieces; piece++) {
      const colour = channels(pieceColour(piece)).map((level) => linear[level]!);
      for (let frame = oldest; frame <= moment.frame; frame += stride, segment++) {
        const next = Math.min(frame + stride, moment.frame);
        const last = frame + stride > moment.frame;
        for (let axis = 0; axis < 3; axis++) {
          const here = centre(moment.frame, piece, axis);
          const tip = here + moment.part * (centre(moment.next, piece, axis) - here);
          lines.ends[6 * segment + axis] = centre(frame, piece, axis);
          lines.ends[6 * segment + 3 + axis] = last ? tip : centre(next, piece, axis);
        }
        for (const [end, f] of [frame, next].entries()) {
          const fresh = 1 - Math.min((time - run.times[f]!) / settings.trails, 1);
          for (let c = 0; c < 3; c++)
            lines.colours[6 * segment + 3 * end + c] =
              background[c]! + (0.15 + 0.85 * fresh) * (colour[c]! - background[c]!);
        }
      }
    }
    return segment;
  };
}
