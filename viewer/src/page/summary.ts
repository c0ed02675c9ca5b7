import type { Quantity, RunIndex } from '../model/bundle';
import { element } from '../dom';
import { displayOf, formatMean, formatNumber, isWide, prettySymbol } from '../plots/format';

/** Means over the statistics window with their intervals: a table for each run. */
export function buildSummary(runs: RunIndex[]): HTMLElement {
  const known = runs.filter(({ quantities }) => quantities.length > 0);
  const parts = known.map((run) => (known.length > 1 ? buildFold(run) : buildTable(run)));
  const nothing = element('p', { class: 'note' }, 'The run has no statistics.');
  const content = parts.length > 0 ? parts : [nothing];
  return element('div', { id: 'statistics' }, element('h2', {}, 'Statistics'), ...content);
}

function buildFold(run: RunIndex): HTMLElement {
  return element('details', {}, element('summary', {}, run.name), buildTable(run));
}

function buildTable(run: RunIndex): HTMLElement {
  const isScaled = run.quantities.some(({ scaled }) => scaled !== null);
  const heads = ['quantity', 'mean ± half width', 'unit', ...(isScaled ? ['scaled'] : [])];
  const head = heads.map((text) => element('th', { scope: 'col' }, text));
  const rows = run.quantities.map((quantity) => buildRow(quantity, isScaled));
  const table = element(
    'table',
    {},
    element('caption', {}, windowText(run)),
    element('thead', {}, element('tr', {}, ...head)),
    element('tbody', {}, ...rows),
  );
  const scroll = {
    class: 'table-scroll',
    tabindex: '0',
    role: 'region',
    'aria-label': 'Statistics',
  };
  const notes = footnotes(run.quantities, run.scales.period > 0).map((text) =>
    element('p', { class: 'note' }, text),
  );
  return element('div', {}, element('div', scroll, table), ...notes);
}

const withoutInterval = 'No interval: fewer than two batches are known.';

/** What the marks in a table of means say; `cycles`: whether their batches are cycles. */
export function footnotes(quantities: readonly Quantity[], cycles: boolean): string[] {
  const wide = quantities.filter((quantity) => isWide(quantity.mean, quantity.half_width));
  const batches = [...new Set(wide.map((quantity) => quantity.batches))].sort((a, b) => a - b);
  const few = cycles ? 'cycles' : 'batches';
  return [
    ...(quantities.some(({ half_width }) => half_width === null) ? [`* ${withoutInterval}`] : []),
    ...(wide.length > 0
      ? [`† Interval wider than the mean: too few ${few} (${batches.join(', ')}).`]
      : []),
  ];
}

/** Window of the statistics in words. */
export function windowText({ averaged: [from, to], scales: { period } }: RunIndex): string {
  if (!(to > from)) return 'Half width of the 95 % interval of the mean; the window is not known.';
  const cycles = period > 0 ? `, ${Number(((to - from) / period).toPrecision(3))} cycles` : '';
  const times = `${formatNumber(from, 4)} s to ${formatNumber(to, 4)} s`;
  return `Over ${times}${cycles}; half width of the 95 % interval of the mean.`;
}

function buildRow(quantity: Quantity, isScaled: boolean): HTMLElement {
  const { name, scaled } = quantity;
  const { text, unit } = formatQuantity(quantity);
  const inScale = scaled
    ? `${formatMean(scaled.mean, scaled.half_width)} ${prettySymbol(scaled.by)}`
    : '';
  return element(
    'tr',
    {},
    element('th', { scope: 'row' }, name),
    element('td', { class: 'number', title: batchText(quantity) }, text, markOf(quantity)),
    element('td', {}, unit),
    isScaled ? element('td', { class: 'number' }, inScale) : null,
  );
}

/** The mark behind a mean that a footnote explains. */
export function markOf({ mean, half_width }: Quantity): HTMLElement | null {
  if (half_width === null) return element('abbr', { title: withoutInterval }, ' *');
  return isWide(mean, half_width)
    ? element('abbr', { title: 'Interval wider than the mean' }, ' †')
    : null;
}

function batchText({ batches, half_width }: Quantity): string {
  return half_width === null ? '' : `From ${batches} batches`;
}

/** Mean and half width in a unit that suits them. */
export function formatQuantity(quantity: Pick<Quantity, 'mean' | 'half_width' | 'unit'>): {
  text: string;
  unit: string;
} {
  const largest = Math.max(Math.abs(quantity.mean), quantity.half_width ?? 0);
  const { factor, unit } = displayOf(quantity.unit, largest);
  const half = quantity.half_width === null ? null : quantity.half_width * factor;
  return { text: formatMean(quantity.mean * factor, half), unit };
}
