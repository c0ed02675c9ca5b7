import { wordsFor, type Field } from '../model/field';
import type { LoadedRun, StressKind } from '../model/run';
import { pieceColour, type ColourMap } from './colours';
import type { Ranges } from './ranges';
import { stressShown, type Settings } from './settings';
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

/** What a colour stands for that belongs to no scale. */
export interface Named {
  name: string;
  colour: string;
}

export function legendsOf(
  run: LoadedRun,
  settings: Readonly<Settings>,
  ranges: Ranges,
  theme: Theme,
): Legend[] {
  const legends: Legend[] = [];
  const kind = stressShown(settings.colour);
  if (kind && settings.cloth && run.motion)
    legends.push(stressLegend(run, kind, settings, ranges, theme));
  if (settings.slice !== 'off' && run.field)
    legends.push(fieldLegend(run.field, settings, ranges, theme));
  return legends;
}

/** The groups of cloth and their colours, where these tell groups apart. */
export function namesOf(run: LoadedRun, settings: Readonly<Settings>): Named[] {
  if (settings.colour !== 'group' || !settings.cloth || !run.motion) return [];
  const groups = run.index.cloth?.groups ?? [];
  return groups.map(({ name }, group) => ({ name, colour: pieceColour(group) }));
}

function stressLegend(
  run: LoadedRun,
  kind: StressKind,
  { range }: Readonly<Settings>,
  ranges: Ranges,
  theme: Theme,
): Legend {
  const [unit, factor] = pascals(ranges.stress);
  const sigma = run.index.scales.stress;
  return {
    title: run.motion?.stress[kind]?.label ?? kind,
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
