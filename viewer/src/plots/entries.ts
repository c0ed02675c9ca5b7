import type { ColumnIndex } from '../model/bundle';
import { findColumn, type Table } from '../model/csv';
import { energyPerCycle, scatterOverTime } from './derived';
import type { RunTables } from './spec';
import type { Entry, Wanted } from './wanted';

const scatterNote =
  'Of the pieces’ centres from their common centre in (r, z) at each instant. The statistics take all points of the cloth instead, about the mean over their time.';
const integralNote = 'Whole cycles, counted so that one begins with the statistics window.';

/** The plot that a column is drawn in, with this column alone. */
function entryOf(column: ColumnIndex): Entry {
  const { name, curve, meaning, shown, instants, statistic, scale } = column;
  const wanted: Wanted = { column: name, label: curve, meaning, shown, smooth: instants };
  if (statistic !== '') wanted.quantity = statistic;
  return {
    section: column.fold,
    title: column.plot,
    name: column.axis,
    curves: [wanted],
    logarithmic: column.logarithmic,
    ...(scale === '' ? {} : { scale }),
  };
}

/** The integral of a column over each whole cycle, such as the energy that a power makes up. */
function integralOf(column: ColumnIndex): Entry {
  const take = ({ index, history }: RunTables) => {
    const time = findColumn(history, 'time');
    const values = findColumn(history, column.name);
    if (!time || !values) return null;
    const samples = { times: time.values, values: values.values };
    const sums = energyPerCycle(samples, index.window[0], index.scales.period);
    return sums && { ...sums, unit: values.unit.replace('W', 'J') };
  };
  const quantity = column.integral_statistic;
  const wanted: Wanted = { column: quantity, label: 'energy of the cycle', quantity, take };
  return {
    section: column.fold,
    title: column.integral,
    name: 'energy',
    curves: [wanted],
    note: integralNote,
  };
}

function scatterEntry(): Entry {
  const take = ({ tracks }: RunTables) => {
    const series = tracks && scatterOverTime(tracks);
    return series && { ...series, unit: 'm' };
  };
  return {
    section: 'Cloth',
    title: 'Scatter of the pieces',
    name: 'rms distance',
    curves: [{ column: 'scatter', label: 'scatter', take }],
    note: scatterNote,
  };
}

/** What no declaration places: a column of another version. */
function otherEntries(table: Table, known: ReadonlySet<string>): Entry[] {
  return table.columns
    .filter(({ name }) => !known.has(name) && name !== 'time' && name !== 'step')
    .map(({ name }) => ({
      section: 'Other',
      title: name,
      name,
      curves: [{ column: name, label: name }],
    }));
}

/** The first of the same title takes the curves of the others; a curve that both have is one. */
function joined(entries: Entry[]): Entry[] {
  const plots = new Map<string, Entry>();
  for (const entry of entries) {
    const key = `${entry.section}\n${entry.title}`;
    const known = plots.get(key);
    if (!known) plots.set(key, { ...entry, curves: [...entry.curves] });
    else
      known.curves.push(
        ...entry.curves.filter(({ column }) => known.curves.every((c) => c.column !== column)),
      );
  }
  return [...plots.values()];
}

/** The catalogue of what the runs could show; curves that no run has are still in it. */
export function entriesFor(runs: RunTables[]): Entry[] {
  const columns = runs.flatMap(({ index }) => index.columns);
  const turning = (column: ColumnIndex) =>
    columns.some((other) => other.name === column.name && !other.instants);
  const known = new Set(columns.map(({ name }) => name));
  const declared = columns.flatMap((column) => [
    entryOf({ ...column, instants: column.instants && !turning(column) }),
    ...(column.integral === '' ? [] : [integralOf(column)]),
  ]);
  const others = runs.flatMap(({ history }) => (history ? otherEntries(history, known) : []));
  return joined([...declared, scatterEntry(), ...others]);
}
