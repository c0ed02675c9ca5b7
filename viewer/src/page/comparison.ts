import type { Comparison, ComparisonRow, Difference, Quantity, RunIndex } from '../model/bundle';
import { runStyle } from '../plots/catalogue';
import { element } from '../dom';
import { displayOf, formatMean, formatPercent, type Display } from '../plots/format';
import { cssColour } from '../plots/theme';
import { footnotes, markOf } from './summary';

const meaning =
  'Values are means over the statistics window ± half the width of their 95 % interval. A difference is significant where its 95 % interval leaves out zero.';

/** The runs' values side by side, with what of their differences can be told. */
export function buildComparison(comparison: Comparison, runs: RunIndex[]): HTMLElement {
  const scroll = {
    class: 'table-scroll',
    tabindex: '0',
    role: 'region',
    'aria-label': 'Comparison',
  };
  return element(
    'div',
    {},
    element('h2', {}, 'Comparison'),
    ...(comparison.rows.length > 0
      ? [element('div', scroll, buildTable(comparison)), ...notesOf(comparison, runs)]
      : []),
    buildSentences(comparison),
  );
}

/** What values, differences and marks in the table mean. */
function notesOf({ rows }: Comparison, runs: readonly RunIndex[]): HTMLElement[] {
  const known = rows.flatMap(({ values }) => values.filter((value) => value !== null));
  const cycles = runs.every(({ scales }) => scales.period > 0);
  const texts = [meaning, ...footnotes(known, cycles)];
  return texts.map((text) => element('p', { class: 'note' }, text));
}

/** What differs in words: folded below the table, open where there is none. */
function buildSentences({ rows, sentences }: Comparison): HTMLElement | null {
  if (sentences.length === 0) return null;
  const title = element('summary', {}, `What differs, in words (${sentences.length})`);
  const items = sentences.map((sentence) => element('li', {}, sentence));
  const list = element('ul', { class: 'sentences' }, ...items);
  return element('details', rows.length > 0 ? {} : { open: '' }, title, list);
}

function buildTable({ names, rows }: Comparison): HTMLElement {
  const values = names.map((name, i) => element('th', { scope: 'col' }, swatch(i), name));
  const differences = names
    .slice(1)
    .map((name) => element('th', { scope: 'col' }, `${name} against ${names[0]!}`));
  const head = element('tr', {}, element('th', { scope: 'col' }, 'quantity'), ...values);
  head.append(...differences);
  return element(
    'table',
    {},
    element('thead', {}, head),
    element('tbody', {}, ...rows.map((row) => buildRow(row))),
  );
}

/** The colour and dash in which the plots show a run. */
function swatch(run: number): HTMLElement {
  const { colour, dash } = runStyle(run);
  const line = element('span', { class: 'swatch' });
  line.style.borderTop = `3px ${dash.length > 0 ? 'dashed' : 'solid'} ${cssColour(colour)}`;
  return line;
}

function buildRow(row: ComparisonRow): HTMLElement {
  const means = row.values.flatMap((value) => (value ? [Math.abs(value.mean)] : []));
  const display = displayOf(row.unit, Math.max(0, ...means));
  const name = row.unit === '' ? row.name : `${row.name} [${display.unit}]`;
  const cells = row.values.map((value) =>
    value ? buildMean(value, display) : element('td', { class: 'number' }, '–'),
  );
  const differences = row.against_first.slice(1).map((each) => buildDifference(each, display));
  return element('tr', {}, element('th', { scope: 'row' }, name), ...cells, ...differences);
}

function buildMean(value: Quantity, display: Display): HTMLElement {
  const text = shown(value.mean, value.half_width, display);
  return element('td', { class: 'number' }, text, markOf(value));
}

function shown(value: number, halfWidth: number | null, { factor }: Display): string {
  return formatMean(value * factor, halfWidth === null ? null : halfWidth * factor);
}

/** What a difference amounts to, in words. */
export function verdict(difference: Difference): string {
  if (difference.significant === null) return 'cannot be told';
  return difference.significant ? 'significant' : 'not significant';
}

function buildDifference(difference: Difference | null, display: Display): HTMLElement {
  if (!difference) return element('td', { class: 'number' }, '–');
  const text = shown(difference.difference, difference.half_width, display);
  const percent = Number.isFinite(difference.percent) ? formatPercent(difference.percent) : '–';
  const kind = difference.significant ? 'verdict significant' : 'verdict';
  const pairs = difference.paired ? ', of equal starts' : '';
  const words = element('span', { class: kind }, verdict(difference) + pairs);
  const signed = difference.difference > 0 ? withPlus(text) : text;
  return element('td', { class: 'number' }, signed, ` (${percent}) `, words);
}

/** "+12 ± 3"; "(+5.8 ± 0.1) × 10⁻⁴". */
export function withPlus(text: string): string {
  return text.replace(/^\(?/, '$&+');
}
