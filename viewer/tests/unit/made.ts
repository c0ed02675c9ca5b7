import type { ColumnIndex, FieldIndex, RunIndex } from '../../src/model/bundle';
import type { Field } from '../../src/model/field';
import type { LoadedRun, Motion } from '../../src/model/run';

/** An index of a run of one piece of 2 x 2 nodes with frames at 0, 1 and 2 s, for tests. */
export function madeIndex(change: Partial<RunIndex> = {}): RunIndex {
  return {
    name: 'made',
    directory: '/made',
    title: 'Made',
    dimension: 3,
    outcome: 'complete',
    facts: [],
    groups: [],
    warnings: [],
    notes: [],
    quantities: [],
    scales: { stress: 10, torque: 0, length: 1, period: 2 },
    columns: [],
    window: [0, 2],
    averaged: [0, 2],
    case: '',
    history: null,
    tracks: null,
    box: { lower: [0, 0, 0], upper: [1, 1, 1] },
    free_surface: false,
    solids: [],
    cloth: {
      nodes: 4,
      pieces: [{ first: 0, nr: 2, ns: 2, closed: [false, false] }],
      groups: [{ name: 'cloth', pieces: 1 }],
    },
    frames: {
      times: [0, 1, 2],
      angles: { agitator: [0, 1, -1] },
      positions: 0,
      span: { lower: [0, 0, 0], upper: [65.535, 65.535, 65.535] },
      stress: null,
      fields: null,
    },
    ...change,
  };
}

/** What the program says of a column; drawn in a plot of its own where nothing else is said. */
export function madeColumn(name: string, change: Partial<ColumnIndex> = {}): ColumnIndex {
  return {
    name,
    meaning: '',
    fold: 'Other',
    plot: name,
    axis: name,
    curve: name,
    scale: '',
    shown: true,
    logarithmic: false,
    instants: false,
    statistic: '',
    integral: '',
    integral_statistic: '',
    ...change,
  };
}

/** Nodes that move along x: node n is at x = 1000 n + 100 frame steps of 1 mm. */
export function madePositions(): Uint16Array {
  const positions = new Uint16Array(3 * 3 * 4);
  for (let frame = 0; frame < 3; frame++)
    for (let node = 0; node < 4; node++) positions[frame * 12 + node] = 1000 * node + 100 * frame;
  return positions;
}

export function madeRun(change: Partial<LoadedRun> = {}): LoadedRun {
  const index = madeIndex();
  return {
    index,
    history: null,
    tracks: null,
    times: index.frames.times,
    solids: [],
    motion: null,
    field: null,
    ...change,
  };
}

export function madeMotion(change: Partial<Motion> = {}): Motion {
  return {
    nodes: 4,
    pieces: [{ first: 0, nr: 2, ns: 2, closed: [false, false] }],
    axes: 3,
    positions: madePositions(),
    lower: [0, 0, 0],
    scale: [1e-3, 1e-3, 1e-3],
    stress: {},
    centres: new Float32Array(9),
    turning: null,
    ...change,
  };
}

/** A field of one frame on `cells` of size 1 from the origin. */
export function madeField(cells: FieldIndex['cells'], velocity: Int8Array, largest: number): Field {
  const number = cells[0] * cells[1] * cells[2];
  return {
    index: {
      frames: [0],
      cells,
      lower: [0, 0, 0],
      spacing: [1, 1, 1],
      velocity: { values: 0, largest: [largest] },
      vorticity: null,
      solid: 0,
      scalars: [],
    },
    axes: 3,
    cells: number,
    times: [0],
    velocity,
    vorticity: null,
    solid: new Uint8Array(number),
    scalars: {},
  };
}
