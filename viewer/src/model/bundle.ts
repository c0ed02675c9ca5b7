/**
 * What `washtub report` and `washtub compare` put into the page: one JSON index in the element
 * `washtub-data`, and binary chunks, each deflated (zlib) and in base64, in the elements
 * `washtub-chunk-0`, `-1`, ... The index refers to them by number. Multi-byte numbers are
 * little-endian. SI units throughout, angles in radians.
 */
export interface Bundle {
  version: 1;
  program: string; // "washtub 0.1.0"
  runs: RunIndex[]; // one for a report, several for a comparison
  comparison: Comparison | null;
}

export type Chunk = number;

export interface RunIndex {
  name: string; // unique among the runs, short: the directory's name
  directory: string;
  title: string;
  dimension: 2 | 3;
  outcome: string; // "complete", "stopped", "unfinished", or the error that ended it
  facts: Fact[]; // grid, time, cloth, steps, wall time, ...
  groups: Group[]; // dimensionless groups
  warnings: string[]; // sentences about the physics and the numbers: slip, CFL, ...
  notes: string[]; // what was thinned, what is missing
  quantities: Quantity[]; // statistics over the window
  scales: { stress: number; torque: number; length: number; period: number }; // 0 = none
  window: [number, number]; // of the statistics [s]
  case: string; // case.toml
  history: Chunk | null; // history.csv as it is
  tracks: Chunk | null; // tracks.csv as it is
  box: { lower: Vec3; upper: Vec3 }; // 2-D: z from -thickness to 0
  free_surface: boolean; // whether the top of the box is the water's surface
  solids: SolidIndex[];
  cloth: ClothIndex | null;
  frames: FrameIndex;
}

export type Vec3 = [number, number, number];

export interface Fact {
  name: string;
  value: string; // with units
}

export interface Group {
  name: string; // "Re"
  value: number;
  meaning: string; // "density r_o^2 omega_max / viscosity"
}

/** Mean over the window with its 95 % interval; half_width is null where it cannot be told. */
export interface Quantity {
  name: string;
  unit: string;
  mean: number;
  half_width: number | null;
  batches: number;
  scaled: { mean: number; half_width: number | null; by: string } | null; // by "sigma_o"
}

export interface SolidIndex {
  name: string;
  moving: boolean;
  centre: Vec3; // axis of rotation [m]
  vertices: Chunk; // float32 x y z about the centre, at angle 0
  triangles: Chunk; // uint32, counter-clockwise seen from the water
}

/** Nodes of all pieces one after the other; node (i, j) of a piece is first + i + nr j. */
export interface ClothIndex {
  pieces: { first: number; nr: number; ns: number; closed: [boolean, boolean] }[];
  nodes: number;
}

export interface FrameIndex {
  times: number[]; // of the frames kept [s]
  angles: Record<string, number[]>; // per moving solid
  positions: Chunk | null; // uint16 [frame][axis][node]: lower + q (upper - lower)/65535 of `span`
  span: { lower: Vec3; upper: Vec3 };
  stress: Record<'membrane' | 'bending' | 'total', { values: Chunk; largest: number }> | null;
  // uint16 [frame][node]: largest (q/65535)^2 [Pa]
  fields: FieldIndex | null;
}

/** The water on a lattice of cells, coarser than the run's where it was thinned. */
export interface FieldIndex {
  frames: number[]; // numbers of the frames that carry fields, ascending
  cells: [number, number, number];
  lower: Vec3; // lower corner of the lattice [m]
  spacing: Vec3;
  velocity: Companded; // int8 [frame][axis][z][y][x], axes x y (z) as the dimension says [m/s]
  vorticity: Companded | null; // int8 [frame][y][x], 2-D only [1/s]
  solid: Chunk; // uint8 [frame][z][y][x]: 255 where the cell is all solid
}

/** int8 q stands for sign(q) largest (q/127)^2, with one `largest` per frame. */
export interface Companded {
  values: Chunk;
  largest: number[];
}

export interface Comparison {
  rows: ComparisonRow[];
  sentences: string[]; // plain words: what differs, what does not, what cannot be told
}

export interface ComparisonRow {
  name: string;
  unit: string;
  values: (Quantity | null)[]; // one per run
  against_first: (Difference | null)[]; // one per run, null for the first
}

export interface Difference {
  difference: number; // value minus the first run's
  half_width: number | null; // 95 %
  percent: number; // of the first run's value
  significant: boolean | null; // null: cannot be told
}
