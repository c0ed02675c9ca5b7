import type { Moment } from './moment';
import type { LoadedRun, Motion, StressKind } from './run';
import { turnAt, turnedWeights } from './turning';

/**
 * Writes x y z of each node [m] into `out`. Between frames each piece turns about the axis of the
 * moving solid and changes its shape evenly meanwhile; without an axis its nodes go straight.
 */
export function positionsAt(motion: Motion, moment: Moment, out: Float32Array): void {
  const { nodes, axes, pieces } = motion;
  const begin = axes * nodes * moment.frame;
  const end = axes * nodes * moment.next;
  pieces.forEach(({ first, nr, ns }, piece) => {
    const turn = turnAt(motion.turning, pieces.length, piece, moment);
    placeTurned(motion, [begin, end], [first, first + nr * ns], turn, moment.part, out);
    if (axes === 3) placeUpright(motion, [begin, end], [first, first + nr * ns], moment.part, out);
  });
}

type Pair = readonly [number, number];

/** x and y of the nodes of one piece between the frames that begin at `from` and `to`. */
function placeTurned(
  { nodes, positions, lower, scale, turning }: Motion,
  [from, to]: Pair,
  [first, last]: Pair,
  turn: number,
  part: number,
  out: Float32Array,
): void {
  const [x, y] = turning?.axis ?? [0, 0];
  const [a, b, c, d] = turnedWeights(turn, part);
  const [sx, sy] = [scale[0]!, scale[1]!];
  const [lx, ly] = [lower[0]! - x, lower[1]! - y];
  for (let node = first; node < last; node++) {
    const x0 = lx + sx * positions[from + node]!;
    const y0 = ly + sy * positions[from + nodes + node]!;
    const x1 = lx + sx * positions[to + node]!;
    const y1 = ly + sy * positions[to + nodes + node]!;
    out[3 * node] = x + a * x0 - b * y0 + c * x1 - d * y1;
    out[3 * node + 1] = y + b * x0 + a * y0 + d * x1 + c * y1;
  }
}

/** z of the nodes of one piece, linear between the frames. */
function placeUpright(
  { nodes, positions, lower, scale }: Motion,
  [from, to]: Pair,
  [first, last]: Pair,
  part: number,
  out: Float32Array,
): void {
  for (let node = first; node < last; node++) {
    const low = positions[from + 2 * nodes + node]!;
    const high = positions[to + 2 * nodes + node]!;
    out[3 * node + 2] = lower[2]! + scale[2]! * (low + part * (high - low));
  }
}

/** Writes x y z of a piece's centre [m] into `out` at `at`; between frames as its nodes go. */
export function centreAt(
  { centres, pieces, turning }: Motion,
  piece: number,
  moment: Moment,
  out: Float32Array,
  at = 0,
): void {
  const from = 3 * (moment.frame * pieces.length + piece);
  const to = 3 * (moment.next * pieces.length + piece);
  const [x, y] = turning?.axis ?? [0, 0];
  const [a, b, c, d] = turnedWeights(turnAt(turning, pieces.length, piece, moment), moment.part);
  const [x0, y0] = [centres[from]! - x, centres[from + 1]! - y];
  const [x1, y1] = [centres[to]! - x, centres[to + 1]! - y];
  out[at] = x + a * x0 - b * y0 + c * x1 - d * y1;
  out[at + 1] = y + b * x0 + a * y0 + d * x1 + c * y1;
  const low = centres[from + 2]!;
  out[at + 2] = low + moment.part * (centres[to + 2]! - low);
}

/** Writes the stress of each node [Pa], linear between the frames, into `out`. */
export function stressAt(
  motion: Motion,
  kind: StressKind,
  moment: Moment,
  out: Float32Array,
): void {
  const { values, largest } = motion.stress[kind] ?? { values: null, largest: 0 };
  if (!values) return void out.fill(0);
  const a = moment.frame * motion.nodes;
  const b = moment.next * motion.nodes;
  const unit = largest / (65535 * 65535);
  for (let node = 0; node < motion.nodes; node++) {
    const from = values[a + node]! * values[a + node]!;
    const to = values[b + node]! * values[b + node]!;
    out[node] = unit * (from + moment.part * (to - from));
  }
}

/** Angle of a solid [rad], linear between the frames. */
export function angleAt(run: LoadedRun, solid: string, moment: Moment): number {
  const angles = run.index.frames.angles[solid];
  if (!angles || angles.length === 0) return 0;
  const from = angles[moment.frame] ?? 0;
  return from + moment.part * ((angles[moment.next] ?? from) - from);
}
