import type { FieldQuantity } from '../model/field';
import { quantitiesOf } from '../model/field';
import { STRESS_KINDS, type LoadedRun, type StressKind } from '../model/run';

export type ClothColour = 'piece' | StressKind;
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
  trails: number[]; // [s]
  cloth: boolean;
}

export function choicesFor(runs: readonly LoadedRun[]): Choices {
  const kinds = STRESS_KINDS.filter((kind) => runs.some((run) => run.motion?.stress[kind]));
  const fields = runs.flatMap((run) => (run.field ? [quantitiesOf(run.field)] : []));
  const period = runs.find((run) => run.index.scales.period > 0)?.index.scales.period;
  const span = Math.max(...runs.map((run) => run.times.at(-1) ?? 0));
  return {
    plane: runs.every((run) => run.index.dimension === 2),
    colours: ['piece', ...kinds],
    quantities: (fields[0] ?? []).filter((one) => fields.every((all) => all.includes(one))),
    trails: period ? [0, period / 2, period, 2 * period] : [0, span / 8, span / 4, span / 2],
    cloth: runs.some((run) => run.motion),
  };
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
