import type { Quantity, RunIndex } from '../model/bundle';
import { element } from '../plots/dom';
import { displayOf, formatInterval, formatNumber, prettySymbol } from '../plots/format';

/** Means over the statistics window with their intervals: a table for each run. */
export function buildSummary(runs: RunIndex[]): HTMLElement {
  const known = runs.filter(({ quantities }) => quantities.length > 0);
  const parts = known.map((run) => (known.length > 1 ? buildFold(run) : buildTable(run)));
  const nothing = element('p', { class: 'note' }, 'The run has no statistics.');
  const content = parts.length > 0 ? parts : [nothing];
  return element('div', {}, element('h2', {}, 'Statistics'), ...content);
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
  const unknown = run.quantities.some((quantity) => quantity.half_width === null);
  const footnote = element('p', { class: 'note' }, '* ', reasonWithoutInterval);
  return element('div', {}, element('div', scroll, table), unknown ? footnote : null);
}

const reasonWithoutInterval =
  'No interval: it needs at least two whole cycles in the statistics window, or where there is no cycle two of its eight parts.';

function windowText({ window: [from, to], scales: { period } }: RunIndex): string {
  const cycles = period > 0 ? `, ${Number(((to - from) / period).toPrecision(3))} cycles` : '';
  const times = `${formatNumber(from, 4)} s to ${formatNumber(to, 4)} s`;
  return `Over ${times}${cycles}; half width of the 95 % interval of the mean.`;
}

function buildRow(quantity: Quantity, isScaled: boolean): HTMLElement {
  const { name, half_width, scaled } = quantity;
  const { text, unit } = formatQuantity(quantity);
  const mark = half_width === null ? element('abbr', { title: reasonWithoutInterval }, ' *') : null;
  const inScale = scaled
    ? `${formatInterval(scaled.mean, scaled.half_width)} ${prettySymbol(scaled.by)}`
    : '';
  return element(
    'tr',
    {},
    element('th', { scope: 'row' }, name),
    element('td', { class: 'number', title: batchText(quantity) }, text, mark),
    element('td', {}, unit),
    isScaled ? element('td', { class: 'number' }, inScale) : null,
  );
}

function batchText({ batches, half_width }: Quantity): string {
  return half_width === null ? '' : `From ${batches} batches`;
}

/** Mean and half width in a unit that suits them. */
export function formatQuantity(quantity: Pick<Quantity, 'mean' | 'half_width' | 'unit'>): {
  text: string;
  unit: string;
} {
  const { factor, unit } = displayOf(quantity.unit, quantity.mean);
  const half = quantity.half_width === null ? null : quantity.half_width * factor;
  return { text: formatInterval(quantity.mean * factor, half), unit };
}
