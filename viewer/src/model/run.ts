import type { ClothIndex, RunIndex, SolidIndex } from './bundle';
import { DataError, toFloat32, toUint16, toUint32, type ChunkReader } from './decode';
import { loadField, type Field } from './field';
import { turningAxis, turnsOf, type Turning } from './turning';

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

/** Name of the field: "total", "membrane", "bending". */
export type StressKind = string;

/** The cloth's frames as they came: sixteen-bit numbers. */
export interface Motion {
  nodes: number;
  pieces: ClothIndex['pieces'];
  axes: 2 | 3;
  positions: Uint16Array; // [frame][axis][node]
  lower: readonly number[]; // position of 0 [m]
  scale: readonly number[]; // of one step [m]
  stress: Record<StressKind, { label: string; values: Uint16Array; largest: number }>;
  centres: Float32Array; // [frame][piece][3] mean of the piece's nodes [m]
  turning: Turning | null; // null where no solid moves
}

/** Decodes all chunks of a run; throws DataError where one is missing, damaged, or too short. */
export async function loadRun(index: RunIndex, read: ChunkReader): Promise<LoadedRun> {
  const text = async (chunk: number | null) =>
    chunk === null ? null : new TextDecoder().decode(await read(chunk));
  const solids = await Promise.all(
    index.solids.map(async (solid) => ({
      index: solid,
      vertices: toFloat32(await read(solid.vertices)),
      triangles: toUint32(await read(solid.triangles)),
    })),
  );
  return {
    index,
    history: await text(index.history),
    tracks: await text(index.tracks),
    times: index.frames.times,
    solids,
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
  const { nodes, pieces } = cloth;
  const motion = { nodes, pieces, axes, positions, lower, scale } as const;
  return {
    ...motion,
    centres: centresOf(index, motion),
    turning: turningOf(index, motion),
    stress: await loadStress(index, read),
  };
}

function turningOf(index: RunIndex, motion: Positions): Turning | null {
  const axis = turningAxis(index);
  if (!axis) return null;
  const { nodes, axes, positions, lower, scale } = motion;
  const turns = turnsOf(motion.pieces, index.frames.times.length, (frame, node, out) => {
    for (let k = 0; k < 2; k++)
      out[k] = lower[k]! + scale[k]! * positions[(frame * axes + k) * nodes + node]! - axis[k]!;
  });
  return { axis, turns };
}

async function loadStress(index: RunIndex, read: ChunkReader): Promise<Motion['stress']> {
  const stress: Motion['stress'] = {};
  for (const [kind, part] of Object.entries(index.frames.stress ?? {})) {
    const values = toUint16(await read(part.values));
    if (values.length !== index.frames.times.length * index.cloth!.nodes)
      throw new DataError(
        `The data of this page are damaged: the ${part.label} has not all its frames.`,
      );
    stress[kind] = { label: part.label, values, largest: part.largest };
  }
  return stress;
}

type Positions = Pick<Motion, 'nodes' | 'pieces' | 'axes' | 'positions' | 'lower' | 'scale'>;

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
