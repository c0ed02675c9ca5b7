import { wordsFor, type Field } from '../model/field';
import type { LoadedRun } from '../model/run';
import type { ColourMap } from './colours';
import type { Ranges } from './ranges';
import type { Settings } from './settings';
import { mapFor } from './slice';
import type { Theme } from './theme';

/** What the colours of a view mean. */
export interface Legend {
  title: string;
  unit: string;
  low: number; // in `unit`
  high: number;
  map: ColourMap;
  scaled: { by: string; factor: number } | null; // value in `unit` times factor: in units of `by`
  open: boolean; // whether larger values occur, at both ends where `low` is negative
}

export function legendsOf(
  run: LoadedRun,
  settings: Readonly<Settings>,
  ranges: Ranges,
  theme: Theme,
): Legend[] {
  const legends: Legend[] = [];
  if (settings.colour !== 'piece' && settings.cloth && run.motion)
    legends.push(stressLegend(run, settings, ranges, theme));
  if (settings.slice !== 'off' && run.field)
    legends.push(fieldLegend(run.field, settings, ranges, theme));
  return legends;
}

function stressLegend(
  run: LoadedRun,
  { colour, range }: Readonly<Settings>,
  ranges: Ranges,
  theme: Theme,
): Legend {
  const [unit, factor] = pascals(ranges.stress);
  const sigma = run.index.scales.stress;
  return {
    title: run.motion?.stress[colour]?.label ?? colour,
    unit,
    low: 0,
    high: ranges.stress * factor,
    map: theme.stress,
    scaled: sigma > 0 ? { by: 'σₒ', factor: 1 / (factor * sigma) } : null,
    open: range === 'most',
  };
}

/** Unit that suits a stress [Pa], and the factor to it. */
export function pascals(stress: number): [string, number] {
  if (stress >= 2e6) return ['MPa', 1e-6];
  return stress >= 2e3 ? ['kPa', 1e-3] : ['Pa', 1];
}

function fieldLegend(
  field: Field,
  { quantity }: Readonly<Settings>,
  ranges: Ranges,
  theme: Theme,
): Legend {
  const { map, signed } = mapFor(quantity, theme);
  const { label, unit } = wordsFor(field, quantity);
  return {
    title: label,
    unit,
    low: signed ? -ranges.field : 0,
    high: ranges.field,
    map,
    scaled: null,
    open: true,
  };
}

/** Round numbers from `low` to `high`, about `count` of them. */
export function ticks(low: number, high: number, count: number): number[] {
  if (!(high > low)) return [low];
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= 0.8 * rough)!;
  const list: number[] = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++)
    list.push(i * step + 0);
  return list;
}

/** A tick as text, without needless digits. */
export function tickText(value: number): string {
  return Math.abs(value) < 1e-12 ? '0' : String(Number(value.toPrecision(4))).replace('-', '−');
}
