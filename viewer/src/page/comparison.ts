import type { Comparison, ComparisonRow, Difference, RunIndex } from '../model/bundle';
import { runStyle } from '../plots/catalogue';
import { element } from '../plots/dom';
import { displayOf, formatInterval, formatPercent, type Display } from '../plots/format';
import { cssColour } from '../plots/theme';

const meaning =
  'Values are means over the statistics window ± half the width of their 95 % interval. A difference is significant where its 95 % interval leaves out zero.';

/** The runs' values side by side, with what of their differences can be told. */
export function buildComparison(comparison: Comparison, runs: RunIndex[]): HTMLElement {
  const sentences = comparison.sentences.map((sentence) => element('li', {}, sentence));
  const note = element('p', { class: 'note' }, meaning);
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
    element('ul', { class: 'sentences' }, ...sentences),
    ...(comparison.rows.length > 0
      ? [element('div', scroll, buildTable(comparison, runs)), note]
      : []),
  );
}

function buildTable({ rows }: Comparison, runs: RunIndex[]): HTMLElement {
  const values = runs.map((run, i) => element('th', { scope: 'col' }, swatch(i), run.name));
  const differences = runs
    .slice(1)
    .map((run) => element('th', { scope: 'col' }, `${run.name} against ${runs[0]!.name}`));
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
    element('td', { class: 'number' }, value ? shown(value.mean, value.half_width, display) : '–'),
  );
  const differences = row.against_first.slice(1).map((each) => buildDifference(each, display));
  return element('tr', {}, element('th', { scope: 'row' }, name), ...cells, ...differences);
}

function shown(value: number, halfWidth: number | null, { factor }: Display): string {
  return formatInterval(value * factor, halfWidth === null ? null : halfWidth * factor);
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
  const words = element('span', { class: kind }, verdict(difference));
  const sign = difference.difference > 0 && !text.startsWith('(') ? '+' : '';
  return element('td', { class: 'number' }, `${sign}${text}`, ` (${percent}) `, words);
}
