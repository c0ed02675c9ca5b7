import { quantityOf, type Field, type FieldQuantity } from '../model/field';
import type { Moment } from '../model/moment';
import type { LoadedRun, StressKind } from '../model/run';
import { stressShown, type RangeChoice, type Settings } from './settings';

/** Ends of the colours, the same for all views. */
export interface Ranges {
  stress: number; // upper end of the stress chosen [Pa]; the lower one is 0
  field: number; // largest size of the field's quantity [m/s or 1/s]
}

/** Part of a run's values that its colours cover by default. */
const MOST = 0.98;

/** Works out the ranges of all runs together; what spans whole runs is kept. */
export class RangeFinder {
  #kept = new Map<string, number>();

  constructor(readonly runs: readonly LoadedRun[]) {}

  find(settings: Readonly<Settings>, moments: readonly Moment[]): Ranges {
    const kind = stressShown(settings.colour);
    return {
      stress: kind ? this.#stress(kind, settings.range, moments) : 0,
      field: this.#keep(`field ${settings.quantity}`, (run) =>
        run.field ? mostOfField(run.field, settings.quantity) : 0,
      ),
    };
  }

  #stress(kind: StressKind, range: RangeChoice, moments: readonly Moment[]): number {
    if (range === 'frame')
      return Math.max(...this.runs.map((run, i) => largestOfFrame(run, kind, moments[i]!)));
    return this.#keep(`${range} ${kind}`, (run) =>
      range === 'run' ? (run.motion?.stress[kind]?.largest ?? 0) : mostOfStress(run, kind),
    );
  }

  #keep(name: string, find: (run: LoadedRun) => number): number {
    const found = this.#kept.get(name) ?? Math.max(...this.runs.map(find));
    this.#kept.set(name, found);
    return found;
  }
}

/** Stress that 98 % of all nodes' values over the run do not exceed [Pa]. */
export function mostOfStress(run: LoadedRun, kind: StressKind): number {
  const stress = run.motion?.stress[kind];
  if (!stress) return 0;
  const counts = new Uint32Array(65536);
  for (const value of stress.values) counts[value]!++;
  let left = MOST * stress.values.length;
  const q = counts.findIndex((count) => (left -= count) <= 0);
  return stress.largest * (q / 65535) ** 2;
}

/** Largest stress in the frames that the moment is made of [Pa]. */
function largestOfFrame(run: LoadedRun, kind: StressKind, moment: Moment): number {
  const { motion } = run;
  const stress = motion?.stress[kind];
  if (!motion || !stress) return 0;
  let largest = 0;
  for (const frame of moment.part > 0 ? [moment.frame, moment.next] : [moment.frame])
    for (let i = 0; i < motion.nodes; i++)
      largest = Math.max(largest, stress.values[frame * motion.nodes + i]!);
  return stress.largest * (largest / 65535) ** 2;
}

/** Size that 98 % of the values in the water do not exceed, from at most 24 frames. */
function mostOfField(field: Field, quantity: FieldQuantity): number {
  const frames = field.times.length;
  const every = Math.max(1, Math.ceil(frames / 24));
  const stride = fairStride(field.index.cells, Math.floor(field.cells / 4000));
  const values = new Float32Array(field.cells);
  const sizes: number[] = [];
  for (let frame = 0; frame < frames; frame += every) {
    quantityOf(field, quantity, frame, values);
    for (let cell = 0; cell < field.cells; cell += stride)
      if (field.solid[frame * field.cells + cell]! < 128) sizes.push(Math.abs(values[cell]!));
  }
  const sorted = Float32Array.from(sizes).sort();
  return sorted[Math.floor(MOST * (sorted.length - 1))] ?? 0;
}

/**
 * A stride of at least `least` through a lattice that shares no factor with its edges, so that it
 * does not keep to some of the rows.
 */
export function fairStride(cells: readonly number[], least: number): number {
  const shared = (a: number, b: number): number => (b === 0 ? a : shared(b, a % b));
  let stride = Math.max(1, least);
  while (cells.some((edge) => shared(edge, stride) !== 1)) stride++;
  return stride;
}
