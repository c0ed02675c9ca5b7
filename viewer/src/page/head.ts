import type { Group, RunIndex } from '../model/bundle';
import { element } from '../dom';
import { formatNumber } from '../plots/format';

const outcomeMarks: Record<string, string> = { complete: '✓', stopped: '■', unfinished: '…' };

/**
 * What a run is: title, outcome, warnings, dimensionless groups, facts, and notes. In a comparison
 * all but title and outcome are in a fold, so that the views come soon.
 */
export function buildHead(run: RunIndex, _: number, all: readonly RunIndex[]): HTMLElement {
  const details = [
    buildSentences('warnings', 'Warning', '⚠', run.warnings),
    element('div', { class: 'groups' }, ...buildGroups(run.groups), buildFacts(run)),
    buildSentences('notes', 'Note', 'i', run.notes),
  ];
  return element(
    'div',
    { class: 'run-head' },
    element('h1', {}, run.title || run.name),
    element('p', { class: 'run-name' }, buildOutcome(run.outcome), ` ${run.directory || run.name}`),
    ...(all.length > 1 ? [buildFold(run, details)] : details),
  );
}

/** The details in a fold whose title counts the warnings. */
function buildFold({ warnings }: RunIndex, details: (HTMLElement | null)[]): HTMLElement {
  const count = warnings.length === 1 ? '⚠ 1 warning, ' : `⚠ ${warnings.length} warnings, `;
  const title = `${warnings.length > 0 ? count : ''}groups, facts and notes`;
  return element('details', { class: 'run-details' }, element('summary', {}, title), ...details);
}

function buildOutcome(outcome: string): HTMLElement {
  const mark = outcomeMarks[outcome] ?? '✗';
  const kind = outcomeMarks[outcome] ? outcome : 'failed';
  return element('span', { class: `outcome ${kind}` }, `${mark} ${outcome}`);
}

function buildSentences(
  kind: string,
  name: string,
  mark: string,
  sentences: readonly string[],
): HTMLElement | null {
  if (sentences.length === 0) return null;
  const items = sentences.map((sentence) => {
    const icon = element('span', { class: 'mark', role: 'img', 'aria-label': name }, mark);
    return element('li', {}, icon, element('span', {}, sentence));
  });
  return element('ul', { class: kind }, ...items);
}

/** The groups in one line; each one's meaning on pointing at it, and all of them in a fold. */
function buildGroups(groups: readonly Group[]): HTMLElement[] {
  if (groups.length === 0) return [];
  const line = groups.map(({ name, value, meaning }) =>
    element(
      'li',
      { title: `${name} = ${meaning}` },
      element('b', {}, name),
      ` ${formatNumber(value, 4)}`,
    ),
  );
  const meanings = groups.flatMap(({ name, meaning }) => [
    element('dt', {}, name),
    element('dd', {}, meaning),
  ]);
  const all = element('dl', { class: 'facts' }, ...meanings);
  return [
    element('ul', { 'aria-label': 'Dimensionless groups' }, ...line),
    element('details', {}, element('summary', {}, 'What the groups mean'), all),
  ];
}

function buildFacts({ facts }: RunIndex): HTMLElement | null {
  if (facts.length === 0) return null;
  const pairs = facts.map(({ name, value }) =>
    element('div', {}, element('dt', {}, name), element('dd', {}, value)),
  );
  const list = element('dl', { class: 'fact-grid' }, ...pairs);
  return element('details', {}, element('summary', {}, 'Grid, time, cloth and cost'), list);
}
