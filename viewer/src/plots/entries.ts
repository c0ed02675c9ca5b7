import { findColumn, type Table } from '../model/csv';
import { scatterOverTime } from './derived';
import { solidEntries, solidsOf } from './entries_solids';
import type { RunTables } from './spec';
import type { Entry, Wanted } from './wanted';

const scatterNote =
  'Of the pieces’ centres from their common centre in (r, z) at each instant. The statistics take all points of the cloth instead, about the mean over the window.';

const one = (column: string): Wanted[] => [{ column, label: column }];

function clothEntries(): Entry[] {
  const section = 'Cloth';
  const stress: Wanted[] = [
    { column: 'stress', label: 'total', quantity: 'stress' },
    { column: 'membrane stress', label: 'membrane', quantity: 'membrane stress' },
    { column: 'bending stress', label: 'bending', quantity: 'bending stress' },
  ];
  const scatter: Wanted = { column: 'scatter', label: 'scatter', take: takeScatter };
  const area = one('enclosed area');
  return [
    {
      section,
      title: 'Stress',
      name: 'stress',
      curves: stress,
      scale: 'stress',
    },
    {
      section,
      title: 'Scatter of the pieces',
      name: 'rms distance',
      curves: [scatter],
      note: scatterNote,
    },
    {
      section,
      title: 'Radius of the cloth',
      name: 'radius',
      curves: [{ column: 'cloth radius', label: 'radius', quantity: 'cloth radius' }],
    },
    {
      section,
      title: 'Height of the cloth',
      name: 'height',
      curves: [
        { column: 'cloth height', label: 'height', quantity: 'cloth height', take: takeHeight },
      ],
    },
    { section, title: 'Enclosed area', name: 'area', curves: area },
  ];
}

function takeScatter({ tracks }: RunTables) {
  const series = tracks && scatterOverTime(tracks);
  return series && { ...series, unit: 'm' };
}

/** Nothing rises in two dimensions. */
function takeHeight({ index, history }: RunTables) {
  const time = findColumn(history, 'time');
  const height = findColumn(history, 'cloth height');
  if (index.dimension === 2 || !time || !height) return null;
  return { times: time.values, values: height.values, unit: height.unit };
}

function waterEntries(): Entry[] {
  const errors = ['largest', 'rms'].map((which) => ({
    column: `${which} velocity error`,
    label: which,
  }));
  return [
    {
      section: 'Water',
      title: 'Kinetic energy',
      name: 'kinetic energy',
      curves: one('kinetic energy'),
    },
    { section: 'Water', title: 'Largest speed', name: 'speed', curves: one('speed') },
    {
      section: 'Error against the exact solution',
      title: 'Velocity error',
      name: 'error',
      curves: errors,
      logarithmic: true,
    },
  ];
}

function numericsEntries(): Entry[] {
  const section = 'Numerics';
  const counts = [
    { column: 'pressure cycles', label: 'pressure cycles' },
    { column: 'newton steps', label: 'Newton steps of the cloth' },
  ];
  return [
    { section, title: 'Largest strain', name: 'strain', curves: one('largest strain') },
    { section, title: 'Slip', name: 'rms slip', curves: one('slip') },
    { section, title: 'Courant number', name: 'Courant number', curves: one('courant') },
    { section, title: 'Time step', name: 'time step', curves: one('time step') },
    {
      section,
      title: 'Divergence',
      name: 'divergence × h/U',
      curves: one('divergence'),
      logarithmic: true,
    },
    { section, title: 'Iterations', name: 'iterations', curves: counts },
  ];
}

const placed = (entries: Entry[]) =>
  entries.flatMap((entry) => entry.curves.map((curve) => curve.column));

/** What no entry shows: a probe's coordinate, or a column of a later version. */
function otherEntries(table: Table, known: Entry[]): Entry[] {
  const seen = new Set([...placed(known), 'time', 'step']);
  return table.columns
    .filter(({ name }) => !seen.has(name))
    .map(({ name, unit }) => {
      const section = unit === 'm' && / [xyz]$/.test(name) ? 'Probes' : 'Other';
      return { section, title: name, name, curves: one(name) };
    });
}

/** The catalogue of what the runs could show; curves that no run has are still in it. */
export function entriesFor(tables: Table[]): Entry[] {
  const solids = new Map<string, { name: string; moving: boolean }>();
  for (const { name, moving } of tables.flatMap(solidsOf))
    solids.set(name, { name, moving: moving || solids.get(name)?.moving === true });
  const known = [
    ...clothEntries(),
    ...[...solids.values()].flatMap(solidEntries),
    ...waterEntries(),
    ...numericsEntries(),
  ];
  const others = tables.flatMap((table) => otherEntries(table, known));
  const unique = new Map(others.map((entry) => [entry.title, entry]));
  return [...known, ...unique.values()];
}
