import type { FieldQuantity } from '../model/field';
import { quantitiesOf, wordsFor } from '../model/field';
import type { LoadedRun, StressKind } from '../model/run';

export type ClothColour = 'piece' | 'group' | StressKind;
/** The stress that colours show; null where they tell pieces or groups apart. */
export function stressShown(colour: ClothColour): StressKind | null {
  return colour === 'piece' || colour === 'group' ? null : colour;
}
/** Upper end of the stress colours: 98 % of the run's values, the run's largest, the frame's. */
export type RangeChoice = 'most' | 'run' | 'frame';
export type SliceChoice = 'off' | 'vertical' | 'horizontal' | 'both';

/** What the reader chose to see; one for all views. */
export interface Settings {
  colour: ClothColour;
  range: RangeChoice;
  slice: SliceChoice; // in 2-D every choice but "off" shows the plane
  quantity: FieldQuantity;
  angle: number; // of the vertical slice about the axis, from x [degrees]
  height: number; // of the horizontal slice, from 0 (floor) to 1 (top of the box)
  arrows: boolean; // velocity in the slices
  trails: number; // length of the trails of the pieces' centres [s], 0 = none
  cloth: boolean; // whether the cloth is shown
}

/** What can be chosen for these runs. */
export interface Choices {
  plane: boolean; // all runs are 2-D
  colours: ClothColour[];
  quantities: FieldQuantity[]; // empty where no run carries the water
  words: Record<string, string>; // what colours and quantities are called
  trails: number[]; // [s]
  period: number; // of the stroke, if all runs have the same [s], else 0
  depth: number; // of the box, if all runs have the same [m], else 0
  cloth: boolean;
}

export function choicesFor(runs: readonly LoadedRun[]): Choices {
  const kinds = stressKinds(runs);
  const fields = runs.flatMap((run) => (run.field ? [quantitiesOf(run.field)] : []));
  const period = commonPeriod(runs);
  const grouped = runs.some(({ index: { cloth } }) => (cloth?.groups.length ?? 0) > 1);
  return {
    plane: runs.every((run) => run.index.dimension === 2),
    colours: ['piece', ...(grouped ? ['group'] : []), ...kinds],
    quantities: (fields[0] ?? []).filter((one) => fields.every((all) => all.includes(one))),
    words: wordsOf(runs),
    trails: period > 0 ? [0, period / 2, period, 2 * period] : roundTrails(runs),
    period,
    depth: common(runs.map(({ index: { box } }) => box.upper[2] - box.lower[2])),
    cloth: runs.some((run) => run.motion),
  };
}

/** Kinds of stress that some run has, the total first. */
function stressKinds(runs: readonly LoadedRun[]): StressKind[] {
  const kinds = new Set(runs.flatMap(({ motion }) => Object.keys(motion?.stress ?? {})));
  return [...kinds].sort((a, b) => Number(b === 'total') - Number(a === 'total'));
}

function wordsOf(runs: readonly LoadedRun[]): Record<string, string> {
  const stress = runs.flatMap(({ motion }) =>
    Object.entries(motion?.stress ?? {}).map(([kind, { label }]) => [kind, label]),
  );
  const water = runs.flatMap(({ field }) =>
    field ? quantitiesOf(field).map((one) => [one, wordsFor(field, one).label]) : [],
  );
  return Object.fromEntries([...stress, ...water]);
}

/** Period of the stroke of all runs [s], 0 where they have none or several. */
export function commonPeriod(runs: readonly LoadedRun[]): number {
  return common(runs.map((run) => run.index.scales.period));
}

function common(values: readonly number[]): number {
  const [first = 0] = values;
  return values.every((value) => Math.abs(value - first) <= 1e-6 * Math.abs(first)) ? first : 0;
}

/** None, and round times of about a tenth, a quarter and half of the longest run [s]. */
function roundTrails(runs: readonly LoadedRun[]): number[] {
  const span = Math.max(...runs.map(({ times }) => (times.at(-1) ?? 0) - (times[0] ?? 0)));
  if (!(span > 0)) return [0];
  const power = 10 ** Math.floor(Math.log10(span / 2));
  const longest = Math.floor(span / 2 / power) * power;
  return [0, longest / 5, longest / 2, longest].map((time) => Number(time.toPrecision(6)));
}

export function initialSettings(choices: Choices): Settings {
  return {
    colour: 'piece',
    range: 'most',
    slice: choices.plane || !choices.cloth ? 'horizontal' : 'off',
    quantity: choices.quantities[0] ?? 'speed',
    angle: 0,
    height: 0.5,
    arrows: false,
    trails: 0,
    cloth: true,
  };
}
