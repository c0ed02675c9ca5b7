import type { RunIndex, SolidIndex } from './bundle';
import { DataError, toFloat32, toUint16, toUint32, type ChunkReader } from './decode';
import { loadField, type Field } from './field';
import type { Moment } from './moment';

/** A run with its chunks decoded. */
export interface LoadedRun {
  index: RunIndex;
  history: string | null; // history.csv as it is
  tracks: string | null; // tracks.csv as it is
  times: readonly number[]; // of the frames [s]
  solids: SolidMesh[];
  motion: Motion | null; // of the cloth
  field: Field | null; // the water
}

/** Surface of a solid about its centre at angle 0 [m]; counter-clockwise seen from the water. */
export interface SolidMesh {
  index: SolidIndex;
  vertices: Float32Array;
  triangles: Uint32Array;
}

export type StressKind = 'membrane' | 'bending' | 'total';
export const STRESS_KINDS: readonly StressKind[] = ['total', 'membrane', 'bending'];

/** The cloth's frames as they came: sixteen-bit numbers. */
export interface Motion {
  nodes: number;
  axes: 2 | 3;
  positions: Uint16Array; // [frame][axis][node]
  lower: readonly number[]; // position of 0 [m]
  scale: readonly number[]; // of one step [m]
  stress: Partial<Record<StressKind, { values: Uint16Array; largest: number }>>;
  centres: Float32Array; // [frame][piece][3] mean of the piece's nodes [m]
}

/** Decodes all chunks of a run; throws DataError where one is missing, damaged, or too short. */
export async function loadRun(index: RunIndex, read: ChunkReader): Promise<LoadedRun> {
  const text = async (chunk: number | null) =>
    chunk === null ? null : new TextDecoder().decode(await read(chunk));
  const solids = index.solids.map(async (solid) => ({
    index: solid,
    vertices: toFloat32(await read(solid.vertices)),
    triangles: toUint32(await read(solid.triangles)),
  }));
  return {
    index,
    history: await text(index.history),
    tracks: await text(index.tracks),
    times: index.frames.times,
    solids: await Promise.all(solids),
    motion: await loadMotion(index, read),
    field: await loadField(index, read),
  };
}

async function loadMotion(index: RunIndex, read: ChunkReader): Promise<Motion | null> {
  const { cloth, frames } = index;
  if (!cloth || cloth.nodes === 0 || frames.positions === null || frames.times.length === 0)
    return null;
  const positions = toUint16(await read(frames.positions));
  const axes = positions.length / (frames.times.length * cloth.nodes);
  if (axes !== 2 && axes !== 3)
    throw new DataError('The data of this page are damaged: the cloth has not all its frames.');
  const { lower, upper } = frames.span;
  const scale = lower.map((low, axis) => (upper[axis]! - low) / 65535);
  const motion = { nodes: cloth.nodes, axes, positions, lower, scale } as const;
  const centres = centresOf(index, motion);
  return { ...motion, centres, stress: await loadStress(index, read) };
}

async function loadStress(index: RunIndex, read: ChunkReader): Promise<Motion['stress']> {
  const stress: Motion['stress'] = {};
  for (const kind of STRESS_KINDS) {
    const part = index.frames.stress?.[kind];
    if (part) stress[kind] = { values: toUint16(await read(part.values)), largest: part.largest };
  }
  return stress;
}

type Positions = Pick<Motion, 'nodes' | 'axes' | 'positions' | 'lower' | 'scale'>;

function centresOf(index: RunIndex, motion: Positions): Float32Array {
  const pieces = index.cloth!.pieces;
  const frames = index.frames.times.length;
  const centres = new Float32Array(frames * pieces.length * 3);
  for (let frame = 0; frame < frames; frame++)
    for (let p = 0; p < pieces.length; p++)
      for (let axis = 0; axis < motion.axes; axis++) {
        const { first, nr, ns } = pieces[p]!;
        const begin = (frame * motion.axes + axis) * motion.nodes + first;
        let sum = 0;
        for (let node = begin; node < begin + nr * ns; node++) sum += motion.positions[node]!;
        centres[(frame * pieces.length + p) * 3 + axis] =
          motion.lower[axis]! + (motion.scale[axis]! * sum) / (nr * ns);
      }
  return centres;
}

/** Writes x y z of each node [m], linear between the frames, into `out`. */
export function positionsAt(motion: Motion, moment: Moment, out: Float32Array): void {
  const { nodes, axes, positions } = motion;
  for (let axis = 0; axis < axes; axis++) {
    const a = (moment.frame * axes + axis) * nodes;
    const b = (moment.next * axes + axis) * nodes;
    const lower = motion.lower[axis]!;
    const scale = motion.scale[axis]!;
    for (let node = 0; node < nodes; node++) {
      const from = positions[a + node]!;
      out[3 * node + axis] = lower + scale * (from + moment.part * (positions[b + node]! - from));
    }
  }
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
