import { describe, expect, it } from 'vitest';
import type { ColumnIndex, RunIndex } from '../../src/model/bundle';
import { parseTable, type Table } from '../../src/model/csv';
import { commonWindow } from '../../src/plots/axis';
import { catalogue } from '../../src/plots/catalogue';
import { alignedData, csvOf, displayFor, isLogarithmic } from '../../src/plots/data';
import { isolated, sampleAt } from '../../src/plots/legend';
import { pieceSection } from '../../src/plots/pieces';
import type { RunTables } from '../../src/plots/spec';
import { madeColumn } from './made';

const washer =
  'time [s],step,tub torque [N],tub friction torque [N],agitator angle [rad],agitator speed [rad/s],' +
  'agitator power [W/m],agitator torque [N],agitator friction torque [N],agitator force x [N/m],' +
  'stress [Pa],membrane stress [Pa],cloth radius [m],largest strain,tip x [m]';

/** What is declared of some columns, as the program puts it into the page. */
function declared(name: string, moving: boolean): ColumnIndex | null {
  const cloth = { fold: 'Cloth', plot: 'Stress', scale: 'stress', statistic: name } as const;
  const [, solid, what] = /^(tub|agitator|cylinder) (.*)$/.exec(name) ?? [];
  const torque = {
    fold: 'Torque and energy',
    plot: `Torque on ${solid}`,
    scale: 'torque',
  } as const;
  const simple: Record<string, Partial<ColumnIndex>> = {
    stress: { ...cloth, curve: 'total', meaning: 'of the cloth' },
    'membrane stress': { ...cloth, curve: 'membrane' },
    'cloth radius': { fold: 'Cloth', plot: 'Radius of the cloth' },
    'largest strain': { fold: 'Numerics', plot: 'Largest strain' },
    divergence: { fold: 'Numerics', plot: 'Divergence', logarithmic: true },
    'kinetic energy': { fold: 'Water', plot: 'Kinetic energy' },
    'tip x': { fold: 'Probes' },
    torque: { ...torque, curve: 'total', instants: !moving },
    'friction torque': { ...torque, curve: 'friction', shown: false },
    power: {
      fold: 'Torque and energy',
      plot: `Power of ${solid}`,
      statistic: `${solid} mean power`,
      integral: `Energy per cycle of ${solid}`,
      integral_statistic: `${solid} energy per cycle`,
    },
    speed: { fold: 'Torque and energy', plot: `Speed of ${solid}` },
    angle: {},
    'force x': { fold: 'Forces', plot: `Force on ${solid}`, curve: 'x' },
  };
  const change = simple[what ?? name];
  return change ? madeColumn(name, change) : null;
}

/** Of a history, moving solids first. */
function declaredOf(table: Table): ColumnIndex[] {
  const names = table.columns.map(({ name }) => name);
  const moves = (name: string) => names.includes(`${name.split(' ')[0]} power`);
  const columns = names.flatMap((name) => declared(name, moves(name)) ?? []);
  return [
    ...columns.filter(({ name }) => moves(name)),
    ...columns.filter(({ name }) => !moves(name)),
  ];
}

function index(change: Partial<RunIndex> = {}): RunIndex {
  const frames = { times: [], angles: {}, positions: null, stress: null, fields: null };
  const zero = { lower: [0, 0, 0], upper: [1, 1, 1] } as RunIndex['box'];
  return {
    name: 'a',
    directory: '/runs/a',
    title: '',
    dimension: 2,
    outcome: 'complete',
    facts: [],
    groups: [],
    warnings: [],
    notes: [],
    quantities: [],
    scales: { stress: 100, torque: 0, length: 1, period: 1 },
    columns: [],
    window: [1, 2],
    averaged: [1, 2],
    case: '',
    history: null,
    tracks: null,
    box: zero,
    free_surface: false,
    solids: [],
    cloth: { pieces: [], groups: [], nodes: 0 },
    frames: { ...frames, span: zero },
    ...change,
  };
}

/** A run of so many rows, 0.5 s apart, whose columns count 0, 1, 2 ... times their number. */
function run(header: string, rows = 5, change: Partial<RunIndex> = {}): RunTables {
  const columns = header.split(',').length;
  const row = (i: number) => [
    0.5 * i,
    ...Array.from({ length: columns - 1 }, (_, c) => i * (c + 1)),
  ];
  const lines = Array.from({ length: rows }, (_, i) => row(i).join());
  const history = parseTable([header, ...lines, ''].join('\n'));
  return { index: index({ columns: declaredOf(history), ...change }), history, tracks: null };
}

const titles = (runs: RunTables[]) =>
  catalogue(runs).map(({ title, plots }) => [title, plots.map((plot) => plot.title)]);

const find = (runs: RunTables[], title: string) =>
  catalogue(runs)
    .flatMap(({ plots }) => plots)
    .find((plot) => plot.title === title)!;

describe('catalogue of one run', () => {
  it('shows what the columns allow, and every other column as well', () => {
    expect(titles([run(washer)])).toEqual([
      ['Cloth', ['Stress', 'Radius of the cloth']],
      [
        'Torque and energy',
        [
          'Speed of agitator',
          'Power of agitator',
          'Energy per cycle of agitator',
          'Torque on agitator',
          'Torque on tub',
        ],
      ],
      ['Probes', ['tip x']],
      ['Forces', ['Force on agitator']],
      ['Other', ['agitator angle']],
      ['Numerics', ['Largest strain']],
    ]);
  });

  it('draws what no one has declared, and a declared column where its declaration says', () => {
    const salt = madeColumn('salt', { fold: 'Water', plot: 'Salt', meaning: 'dissolved' });
    const header = 'time [s],salt [kg],soap [kg]';
    expect(titles([run(header, 5, { columns: [salt] })])).toEqual([
      ['Water', ['Salt']],
      ['Other', ['soap']],
    ]);
    const plot = find([run(header, 5, { columns: [salt] })], 'Salt');
    expect(plot).toMatchObject({ unit: 'kg', curves: [{ meaning: 'dissolved' }] });
  });

  it('takes units from the header, and the energy’s from the power', () => {
    expect(find([run(washer)], 'Torque on tub').unit).toBe('N');
    expect(find([run(washer)], 'Energy per cycle of agitator').unit).toBe('J/m');
  });

  it('has the mean of the window in the stress plot, if its unit is the same', () => {
    const quantity = {
      name: 'stress',
      unit: 'Pa',
      meaning: '',
      mean: 7,
      half_width: 2,
      batches: 3,
      scaled: null,
    };
    const bands = (unit: string) =>
      find([run(washer, 5, { quantities: [{ ...quantity, unit }] })], 'Stress').bands;
    expect(bands('Pa')).toMatchObject([{ mean: 7, halfWidth: 2, from: 1, to: 2 }]);
    expect(bands('kPa')).toEqual([]);
    expect(bands('Pa')[0]!.curve.column).toBe('stress');
  });

  it('scales by sigma_o where there is one', () => {
    expect(find([run(washer)], 'Stress').scale).toEqual({ size: 100, symbol: 'σₒ' });
    expect(find([run(washer)], 'Torque on tub').scale).toBeNull();
  });

  it('opens forces and water only where there is no cloth', () => {
    const header =
      'time [s],kinetic energy [J],cylinder friction torque [N m],cylinder force x [N]';
    const sections = catalogue([run(header, 5, { cloth: null })]);
    expect(sections.map(({ title, open }) => [title, open])).toEqual([
      ['Torque and energy', true],
      ['Forces', true],
      ['Water', true],
    ]);
  });

  it('shows nothing without a history', () => {
    expect(catalogue([{ index: index(), history: null, tracks: null }])).toEqual([]);
  });
});

describe('catalogue of several runs', () => {
  const runs = [run(washer), run(washer, 3, { name: 'b' })];

  it('has one quantity in a plot, with a curve for each run', () => {
    const plot = find(runs, 'Stress: membrane');
    expect(plot.curves.map(({ label, run: number }) => [label, number])).toEqual([
      ['a', 0],
      ['b', 1],
    ]);
    expect(new Set(plot.curves.map(({ colour }) => colour)).size).toBe(2);
    expect(plot.curves[1]!.dash).not.toEqual([]);
  });

  it('keeps a run’s curve out where the run lacks the column', () => {
    const other = run('time [s],stress [Pa]', 3, { name: 'b' });
    expect(find([runs[0]!, other], 'Largest strain').curves).toHaveLength(1);
  });

  it('takes a solid for moving that moves in one of them', () => {
    const rest = run('time [s],agitator friction torque [N]', 3, { name: 'b' });
    for (const order of [
      [runs[0]!, rest],
      [rest, runs[0]!],
    ])
      expect(find(order, 'Power of agitator').curves).toHaveLength(1);
  });

  it('shades the same window once', () => {
    expect(find(runs, 'Stress: total').windows).toEqual([[1, 2]]);
  });
});

describe('data of a plot', () => {
  it('joins runs of different times, with empty cells in the table', () => {
    const runs = [run('time [s],stress [Pa]', 3), run('time [s],stress [Pa]', 2, { name: 'b' })];
    const plot = find(runs, 'Stress');
    expect(csvOf(plot, ['a', 'b'])).toBe(
      'time [s],a: stress [Pa],b: stress [Pa]\n0,0,0\n0.5,1,1\n1,2,\n',
    );
    expect(alignedData(plot, 1)[0]).toHaveLength(3);
  });

  it('has as many cells in each line of the table as in its header', () => {
    const times = Array.from({ length: 401 }, (_, i) => 0.01 * i);
    const lines = times.map((time) => `${time},${time === 1 ? '' : time},0`);
    const header = 'time [s],tub torque [N],tub friction torque [N]';
    const history = parseTable([header, ...lines, ''].join('\n'));
    const columns = declaredOf(history);
    const one = { index: index({ name: 'a, b', columns }), history, tracks: null };
    const plot = find([one], 'Torque on tub');
    expect(plot.curves.map(({ column }) => column)).toContain('tub torque (running mean)');
    const rows = csvOf(plot, ['a, b']).trimEnd().split('\n');
    expect(new Set(rows.map((row) => row.split(',').length))).toEqual(new Set([4]));
    expect(rows[101]).toMatch(/^1,,/);
    const two = csvOf(find([one, one], 'Torque on tub: total'), ['a, b', 'c']);
    expect(two).toMatch(/^time \[s\],"a, b: tub torque \[N\]",/);
  });

  it('is logarithmic only where there is a value for it', () => {
    const plot = find([run('time [s],divergence')], 'Divergence');
    expect(isLogarithmic(plot)).toBe(true);
    plot.curves[0]!.values.fill(0);
    expect(isLogarithmic(plot)).toBe(false);
    expect(alignedData(plot, 1)[1]![0]).toBe(0);
  });

  it('shows values in the plot’s unit and leaves out what a logarithm cannot take', () => {
    const plot = find([run('time [s],divergence')], 'Divergence');
    expect(alignedData(plot, 2)[1]).toEqual([null, 2, 4, 6, 8]);
    const stress = run('time [s],stress [Pa]', 5);
    stress.history!.columns[1]!.values.fill(5e4);
    expect(displayFor(find([stress], 'Stress'))).toEqual({ factor: 1e-3, unit: 'kPa' });
  });

  it('draws the last cycle’s energy to its end', () => {
    const plot = find([run(washer)], 'Energy per cycle of agitator');
    expect([...plot.curves[0]!.times]).toEqual([0, 1]);
    expect([...alignedData(plot, 1)[0]!]).toEqual([0, 1, 2]);
  });

  it('finds the sample of a time', () => {
    const [curve] = find([run('time [s],stress [Pa]')], 'Stress').curves;
    expect([-9, 0, 0.2, 0.3, 2, 9].map((time) => sampleAt(curve!, time))).toEqual([
      null,
      0,
      0,
      1,
      4,
      null,
    ]);
  });
});

describe('plots of the pieces', () => {
  it('have a curve for each piece, and no height in two dimensions', () => {
    const tracks = parseTable(
      'time [s],piece 1 r [m],piece 1 z [m],piece 1 stress [Pa],piece 2 r [m],piece 2 z [m],piece 2 stress [Pa]\n0,1,2,3,4,5,6\n',
    );
    const section = pieceSection([{ index: index(), history: null, tracks }])!;
    expect(section.plots.map(({ title }) => title)).toEqual([
      'Radius of each piece',
      'Stress of each piece',
    ]);
    expect(section.plots[1]!.curves.map(({ values }) => values[0])).toEqual([3, 6]);
  });
});

describe('commonWindow', () => {
  it('holds all windows, as far as there are values', () => {
    const windows: [number, number][] = [
      [1, 2],
      [3, 9],
      [0, 0],
    ];
    expect(commonWindow(windows, [0, 6])).toEqual([1, 6]);
  });

  it('is none where nothing is known of it', () => {
    expect(commonWindow([[0, 0]], [0, 6])).toBeNull();
    expect(commonWindow([[7, 9]], [0, 6])).toBeNull();
  });
});

describe('isolated', () => {
  const shown = (...states: boolean[]) => states.map((state) => ({ shown: state }));

  it('leaves one curve, and shows all where it is alone already', () => {
    expect(isolated(shown(true, true, false), 2)).toEqual([false, false, true]);
    expect(isolated(shown(false, false, true), 2)).toEqual([true, true, true]);
  });
});
