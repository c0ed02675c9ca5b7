import type { ClothIndex, RunIndex } from './bundle';
import type { Moment } from './moment';

/**
 * How the pieces turn about the axis of the moving solid from each frame to the next, so that what
 * lies between two frames can be had by turning instead of along the chord.
 */
export interface Turning {
  axis: readonly [number, number]; // x and y of the axis [m]
  turns: Float32Array; // [frame][piece] from the frame to the next, between -pi and pi [rad]
}

/** Positions of nodes in a frame [m]: writes x and y relative to the axis into `out`. */
export type PlaceReader = (frame: number, node: number, out: [number, number]) => void;

/** The x and y of the first moving solid's axis, or null where nothing turns. */
export function turningAxis({ solids }: RunIndex): [number, number] | null {
  const moving = solids.find((solid) => solid.moving);
  return moving ? [moving.centre[0], moving.centre[1]] : null;
}

/** The turn of each piece between frames that brings its nodes nearest to where they are next. */
export function turnsOf(
  pieces: ClothIndex['pieces'],
  frames: number,
  place: PlaceReader,
): Float32Array {
  const turns = new Float32Array(Math.max(frames - 1, 0) * pieces.length);
  const a: [number, number] = [0, 0];
  const b: [number, number] = [0, 0];
  for (let frame = 0; frame + 1 < frames; frame++)
    pieces.forEach(({ first, nr, ns }, piece) => {
      let along = 0;
      let across = 0;
      for (let node = first; node < first + nr * ns; node++) {
        place(frame, node, a);
        place(frame + 1, node, b);
        along += a[0] * b[0] + a[1] * b[1];
        across += a[0] * b[1] - a[1] * b[0];
      }
      turns[frame * pieces.length + piece] = Math.atan2(across, along);
    });
  return turns;
}

/**
 * Weights of a point between two frames: with x0 and x1 from the axis, the point is
 * x = a x0 - b y0 + c x1 - d y1, y = b x0 + a y0 + d x1 + c y1. A point that turns about the axis
 * does so at an even rate; without a turn the weights are those of a straight line.
 */
export function turnedWeights(turn: number, part: number): [number, number, number, number] {
  const on = part * turn;
  const back = on - turn;
  return [
    (1 - part) * Math.cos(on),
    (1 - part) * Math.sin(on),
    part * Math.cos(back),
    part * Math.sin(back),
  ];
}

/** Turn of a piece from the moment's frame to the next [rad]. */
export function turnAt(
  turning: Turning | null,
  pieces: number,
  piece: number,
  moment: Moment,
): number {
  if (!turning || moment.next === moment.frame) return 0;
  return turning.turns[moment.frame * pieces + piece]!;
}
