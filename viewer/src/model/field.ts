import type { Companded, FieldIndex, RunIndex } from './bundle';
import { DataError, toInt8, type ChunkReader } from './decode';
import { frameAt } from './moment';

/** The water's frames as they came: companded eight-bit numbers on a lattice of cells. */
export interface Field {
  index: FieldIndex;
  axes: 2 | 3;
  cells: number; // of one frame
  times: number[]; // of the frames that carry fields [s]
  velocity: Int8Array; // [frame][axis][cell]
  vorticity: Int8Array | null; // [frame][cell], 2-D only
  solid: Uint8Array; // [frame][cell], 255 where all solid
  scalars: Record<string, Int8Array>; // [frame][cell] of each
}

/** "speed", "vorticity", a component "x", "y" or "z" of the velocity, or the name of a scalar. */
export type FieldQuantity = string;

/** What the page calls them; scalars bring their own names. */
const VELOCITY: Record<string, { label: string; unit: string }> = {
  speed: { label: 'speed', unit: 'm/s' },
  vorticity: { label: 'vorticity', unit: '1/s' },
  x: { label: 'velocity along x', unit: 'm/s' },
  y: { label: 'velocity along y', unit: 'm/s' },
  z: { label: 'velocity along z', unit: 'm/s' },
};

/** Name of a quantity in words, and its unit. */
export function wordsFor(
  { index }: Pick<Field, 'index'>,
  quantity: FieldQuantity,
): { label: string; unit: string } {
  const known = VELOCITY[quantity] ?? index.scalars.find(({ name }) => name === quantity);
  return known ? { label: known.label, unit: known.unit } : { label: quantity, unit: '' };
}

export async function loadField(index: RunIndex, read: ChunkReader): Promise<Field | null> {
  const fields = index.frames.fields;
  if (!fields || fields.frames.length === 0) return null;
  const field = {
    index: fields,
    axes: index.dimension,
    cells: fields.cells[0] * fields.cells[1] * fields.cells[2],
    times: fields.frames.map((frame) => index.frames.times[frame] ?? 0),
    velocity: toInt8(await read(fields.velocity.values)),
    vorticity: fields.vorticity ? toInt8(await read(fields.vorticity.values)) : null,
    solid: await read(fields.solid),
    scalars: Object.fromEntries(
      await Promise.all(
        fields.scalars.map(async ({ name, values }) => [name, toInt8(await read(values))] as const),
      ),
    ),
  };
  const values = fields.frames.length * field.cells;
  const whole =
    field.velocity.length === values * field.axes &&
    field.solid.length === values &&
    (field.vorticity === null || field.vorticity.length === values) &&
    Object.values(field.scalars).every(({ length }) => length === values);
  if (!whole)
    throw new DataError('The data of this page are damaged: the water has not all its frames.');
  return field;
}

/** Number of the field's frame that is nearest to `time` and not later. */
export function fieldFrame(field: Field, time: number): number {
  return frameAt(field.times, time);
}

/** Table of the values that int8 numbers stand for; index by q + 128. */
export function expansion(largest: number): Float32Array {
  return Float32Array.from({ length: 256 }, (_, i) => {
    const q = (i - 128) / 127;
    return Math.sign(q) * largest * q * q;
  });
}

/** Quantities that the field can show. */
export function quantitiesOf(field: Field): FieldQuantity[] {
  const scalars = Object.keys(field.scalars);
  return field.axes === 2
    ? [...(field.vorticity ? ['vorticity'] : []), 'speed', 'x', 'y', ...scalars]
    : ['speed', 'x', 'y', 'z', ...scalars];
}

/** Writes the values of a quantity in all cells of a field's frame into `out`, SI. */
export function quantityOf(
  field: Field,
  quantity: FieldQuantity,
  frame: number,
  out: Float32Array,
): void {
  if (quantity === 'vorticity') return vorticityOf(field, frame, out);
  const scalar = field.scalars[quantity];
  if (scalar) {
    const about = field.index.scalars.find(({ name }) => name === quantity)!;
    return expand(scalar, frame * field.cells, expansion(about.largest[frame] ?? 0), out);
  }
  const table = expansion(field.index.velocity.largest[frame] ?? 0);
  if (quantity === 'speed') return speedOf(field, frame, table, out);
  const axis = 'xyz'.indexOf(quantity);
  expand(field.velocity, (frame * field.axes + axis) * field.cells, table, out);
}

function vorticityOf(field: Field, frame: number, out: Float32Array): void {
  if (!field.vorticity) return void out.fill(0);
  const { largest } = field.index.vorticity as Companded;
  expand(field.vorticity, frame * field.cells, expansion(largest[frame] ?? 0), out);
}

function expand(values: Int8Array, begin: number, table: Float32Array, out: Float32Array): void {
  for (let cell = 0; cell < out.length; cell++) out[cell] = table[128 + values[begin + cell]!]!;
}

function speedOf(field: Field, frame: number, table: Float32Array, out: Float32Array): void {
  const begin = frame * field.axes * field.cells;
  for (let cell = 0; cell < field.cells; cell++) {
    let sum = 0;
    for (let axis = 0; axis < field.axes; axis++) {
      const value = table[128 + field.velocity[begin + axis * field.cells + cell]!]!;
      sum += value * value;
    }
    out[cell] = Math.sqrt(sum);
  }
}
