import { findColumn, type Table } from '../model/csv';
import { energyPerCycle } from './derived';
import type { RunTables } from './spec';
import type { Entry, Wanted } from './wanted';

const section = 'Torque and energy';
const instants =
  'Of the water on it. The parts are instants; the total is the mean since the row before.';
function takeEnergy(solid: string) {
  return ({ index, history }: RunTables) => {
    const time = findColumn(history, 'time');
    const power = findColumn(history, `${solid} power`);
    if (!time || !power) return null;
    const samples = { times: time.values, values: power.values };
    const energy = energyPerCycle(samples, index.window[0], index.scales.period);
    return energy && { ...energy, unit: power.unit.replace('W', 'J') };
  };
}

/** Torque of the water on a solid, in all and in parts. */
function torqueEntry(solid: string, moving: boolean): Entry {
  const parts = ['friction', 'pressure', 'convection'].map((part) => ({
    column: `${solid} ${part} torque`,
    label: part,
    shown: false,
  }));
  const total: Wanted = { column: `${solid} torque`, label: 'total', smooth: !moving };
  return {
    section,
    title: `Torque on ${solid}`,
    name: 'torque',
    curves: [total, ...parts],
    scale: 'torque',
    note: moving ? instants : 'Of the water on it, at each instant.',
  };
}

function energyEntries(solid: string): Entry[] {
  const power = { column: `${solid} power`, label: 'power', quantity: `${solid} mean power` };
  const energy = {
    column: `${solid} energy per cycle`,
    label: 'energy of the cycle',
    quantity: `${solid} energy per cycle`,
    take: takeEnergy(solid),
  };
  return [
    {
      section,
      title: `Power of ${solid}`,
      name: 'power',
      curves: [power],
      note: 'Given to the water; the mean since the row before.',
    },
    {
      section,
      title: `Energy per cycle of ${solid}`,
      name: 'energy',
      curves: [energy],
      note: 'Whole cycles, counted so that one begins with the statistics window.',
    },
  ];
}

function forceEntry(solid: string): Entry {
  const curves = ['x', 'y', 'z'].map((axis) => ({ column: `${solid} force ${axis}`, label: axis }));
  return { section: 'Forces', title: `Force on ${solid}`, name: 'force', curves };
}

/** Solids of a history by the columns that it has, moving ones first. */
export function solidsOf(table: Table): { name: string; moving: boolean }[] {
  const names = table.columns.map((column) => column.name);
  const solids = names
    .filter((name) => name.endsWith(' friction torque'))
    .map((name) => name.slice(0, -' friction torque'.length));
  return solids
    .map((name) => ({ name, moving: names.includes(`${name} power`) }))
    .sort((a, b) => Number(b.moving) - Number(a.moving));
}

/** Torque, force, and of a moving solid power and energy. */
export function solidEntries({ name, moving }: { name: string; moving: boolean }): Entry[] {
  const speed: Entry = {
    section,
    title: `Speed of ${name}`,
    name: 'angular speed',
    curves: [{ column: `${name} speed`, label: 'speed' }],
    note: 'The mean since the row before.',
  };
  const motion = moving ? [...energyEntries(name), speed] : [];
  return [torqueEntry(name, moving), ...motion, forceEntry(name)];
}
