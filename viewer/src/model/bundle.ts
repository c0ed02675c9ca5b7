/**
 * What `washtub report`, `compare` and `ensemble` put into the page: one JSON index in the element
 * `washtub-data`, and binary chunks, each deflated (zlib) and in base64, in the elements
 * `washtub-chunk-0`, `-1`, ... The index refers to them by number. Multi-byte numbers are
 * little-endian. SI units throughout, angles in radians.
 */
export interface Bundle {
  version: 1;
  program: string; // "washtub 0.1.0"
  runs: RunIndex[]; // one for a report, several for a comparison
  comparison: Comparison | null;
  ensemble: Ensemble | null; // whose members the runs are
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
  columns: ColumnIndex[]; // what is declared of the columns of history.csv
  window: [number, number]; // of the statistics, as the case has it [s]
  averaged: [number, number]; // what of it they rest on: its whole cycles [s]
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
  meaning: string;
  mean: number;
  half_width: number | null;
  batches: number;
  scaled: { mean: number; half_width: number | null; by: string } | null; // by "sigma_o"
}

/** A column of history.csv and where its curve is drawn; columns that are not listed are drawn too. */
export interface ColumnIndex {
  name: string;
  meaning: string; // in a few words
  fold: string; // of the page
  plot: string; // its title; columns of one title share a plot
  axis: string; // name of the vertical axis
  curve: string; // in the legend
  scale: 'stress' | 'torque' | '';
  shown: boolean; // at first
  logarithmic: boolean;
  instants: boolean; // drawn with a running mean
  statistic: string; // whose mean belongs to the curve; "" = none
  integral: string; // title of the plot of its integral over each cycle; "" = none
  integral_statistic: string;
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
  groups: { name: string; pieces: number }[]; // in the order of the pieces
  nodes: number;
}

export interface FrameIndex {
  times: number[]; // of the frames kept [s]
  angles: Record<string, number[]>; // per moving solid
  positions: Chunk | null; // uint16 [frame][axis][node]: lower + q (upper - lower)/65535 of `span`
  span: { lower: Vec3; upper: Vec3 };
  stress: Record<string, { label: string; values: Chunk; largest: number }> | null; // per kind
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
  scalars: ScalarIndex[]; // all other fields of the run
}

/** A scalar of the water as the program declares it, int8 [frame][z][y][x]. */
export interface ScalarIndex extends Companded {
  name: string;
  label: string; // "pressure"
  unit: string;
  meaning: string;
}

/** int8 q stands for sign(q) largest (q/127)^2, with one `largest` per frame. */
export interface Companded {
  values: Chunk;
  largest: number[];
}

export interface Comparison {
  names: string[]; // of the runs; of an ensemble, whose first member is drawn, its own
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
  paired: boolean; // of runs that start alike
}

/** One case from several random starts. */
export interface Ensemble {
  name: string;
  seeds: number[]; // of the members
  missing: number[]; // of those that have not reached their end
  groups: string[]; // of cloth, where there are several
  student: number | null; // 97.5 % point of Student's t for as many members
  rows: PooledQuantity[];
  sentences: string[]; // how sure it all is, and what would make it surer
}

/** A mean over the members, each counting alike. Half widths are 95 %; null: cannot be told. */
export interface PooledQuantity {
  name: string;
  unit: string;
  meaning: string;
  mean: number;
  half_width: number | null; // by the spread between the members
  half_width_within: number | null; // by the cycles within them
  variance_ratio: number | null; // of the members' means, over what their cycles let expect
  chance: number | null; // of that or more, where the start does not matter
  cycles_per_block: number; // that count as one value, since neighbours are correlated
  members_told: number; // that have an interval of their own
  members_that_hold_the_mean: number; // in it
  drift: number | null; // from the first cycle of the window to the last
  drift_half_width: number | null;
  seeds_for_5_percent: number | null;
  cycles_for_5_percent: number | null;
  members: number[]; // their means
}
