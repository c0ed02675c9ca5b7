import type { RunIndex } from '../model/bundle';
import { button, download, element, fileName } from '../dom';

/** The runs' cases, folded, and what the page was made by. */
export function buildDetails(runs: RunIndex[], program: string): HTMLElement {
  const cases = runs.map((run) => buildCase(run, runs.length > 1));
  const made = `Made by ${program}. The page holds all its data: it can be mailed and opened anywhere.`;
  return element(
    'div',
    {},
    element('h2', {}, 'Details'),
    ...cases,
    element('p', { class: 'note' }, made),
  );
}

function buildCase(run: RunIndex, several: boolean): HTMLElement {
  const title = several ? `case.toml of ${run.name}` : 'case.toml';
  const summary = element('summary', {}, title);
  if (run.case === '') return element('p', { class: 'note' }, `${run.name} has no case.toml.`);
  const text = element('pre', { tabindex: '0' }, run.case);
  const copy = button('Copy', 'Copy the case', () => void copyText(run.case, copy, text));
  const save = button('Save', 'Save the case as a file', () =>
    download(`${fileName(run.name)}.toml`, new Blob([run.case], { type: 'text/plain' })),
  );
  return element('details', {}, summary, element('p', { class: 'buttons' }, copy, save), text);
}

/** Copies; where the browser does not allow that, selects the text to be copied by hand. */
async function copyText(text: string, told: HTMLElement, shown: HTMLElement): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    told.textContent = 'Copied';
  } catch {
    getSelection()?.selectAllChildren(shown);
    told.textContent = 'Selected: press Ctrl + C';
  }
  setTimeout(() => (told.textContent = 'Copy'), 3000);
}
