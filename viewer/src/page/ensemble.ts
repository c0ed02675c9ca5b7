import { element } from '../dom';
import type { Ensemble, PooledQuantity, RunIndex } from '../model/bundle';
import { buildHead } from './head';
import { displayOf, formatMean, formatNumber } from '../plots/format';

const meaning =
  'Means over the members, each counting alike, ± half the width of the 95 % interval that the ' +
  'spread between them gives; beside it the half width that the cycles within them would give. ' +
  'Spread: of the members’ means over what their cycles let expect, bold where that is more than ' +
  'chance (95 %): there a single run’s interval is too narrow. The last columns: what a half width ' +
  'of 5 % of the mean takes.';

const heads = [
  'quantity',
  'mean ± half width',
  'by cycles',
  'unit',
  'spread',
  'drift',
  'seeds for 5 %',
  'cycles for 5 %',
];

/** What an ensemble tells: sentences first, then all pooled quantities. */
export function buildEnsemble({ name, seeds, groups, rows, sentences }: Ensemble): HTMLElement {
  const isOfGroup = (row: PooledQuantity) =>
    groups.some((group) => row.name.startsWith(`${group} `));
  const apart = rows.filter(isOfGroup);
  const fold = element('details', {}, element('summary', {}, `Groups of cloth (${groups.length})`));
  fold.append(buildTable(apart));
  return element(
    'div',
    { id: 'ensemble' },
    element('h1', {}, `Ensemble ${name}`),
    element('p', { class: 'note' }, `${seeds.length} members, seeds ${seeds.join(', ')}.`),
    element('ul', { class: 'sentences' }, ...sentences.map((text) => element('li', {}, text))),
    buildTable(rows.filter((row) => !isOfGroup(row))),
    apart.length > 0 ? fold : null,
    element('p', { class: 'note' }, meaning),
  );
}

/** What each member is, with its warnings. */
export function buildMembers(runs: RunIndex[]): HTMLElement {
  return element('div', {}, element('h2', {}, 'Members'), ...runs.map(buildHead));
}

function buildTable(rows: readonly PooledQuantity[]): HTMLElement {
  const head = heads.map((text) => element('th', { scope: 'col' }, text));
  const table = element(
    'table',
    {},
    element('thead', {}, element('tr', {}, ...head)),
    element('tbody', {}, ...rows.map(buildRow)),
  );
  const scroll = { class: 'table-scroll', tabindex: '0', role: 'region', 'aria-label': 'Ensemble' };
  return element('div', scroll, table);
}

function buildRow(row: PooledQuantity): HTMLElement {
  const { factor, unit } = displayOf(row.unit, Math.max(Math.abs(row.mean), row.half_width ?? 0));
  const scaled = (value: number | null) => (value === null ? null : value * factor);
  const half = scaled(row.half_width);
  const within = scaled(row.half_width_within);
  const cells = [
    formatMean(row.mean * factor, half),
    within === null ? '–' : `${formatNumber(within, 2)}${blockText(row)}`,
    unit,
    spreadOf(row),
    driftOf(row),
    countOf(row.seeds_for_5_percent),
    countOf(row.cycles_for_5_percent),
  ];
  const name = element('th', { scope: 'row', title: row.meaning }, row.name);
  return element('tr', {}, name, ...cells.map((cell) => element('td', { class: 'number' }, cell)));
}

function spreadOf({ variance_ratio: ratio, chance }: PooledQuantity): string | HTMLElement {
  if (ratio === null) return '–';
  const text = formatNumber(Math.sqrt(ratio), 2);
  return chance !== null && chance < 0.05 ? element('b', {}, text) : text;
}

/** Where neighbouring cycles are correlated, how many count as one. */
function blockText({ cycles_per_block: block }: PooledQuantity): string {
  return block > 1 ? ` (${block} cycles as one)` : '';
}

/** In per cent of the mean, from the first cycle to the last. */
function driftOf({ drift, drift_half_width: half, mean }: PooledQuantity): string | HTMLElement {
  if (drift === null || half === null || mean === 0) return '–';
  const percent = (value: number) => (100 * value) / Math.abs(mean);
  const text = `${formatMean(percent(drift), percent(half))} %`;
  return Math.abs(drift) > half ? element('b', {}, text) : text;
}

function countOf(count: number | null): string {
  if (count === null) return '–';
  return count >= 1e6 ? '> 10⁶' : String(count);
}
