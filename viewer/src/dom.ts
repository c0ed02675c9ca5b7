type Child = Node | string | null;

/** An element with its class, attributes of plain text, and children; null children are left out. */
export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, string> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children.filter((child) => child !== null));
  return made;
}

/** An element with a class, "" for none, and contents. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  className: string,
  ...contents: Child[]
): HTMLElementTagNameMap[K] {
  return element(tag, className === '' ? {} : { class: className }, ...contents);
}

/** A button; `name` says what it does, also to those who do not see its sign. */
export function button(sign: string, name: string, press: () => void): HTMLButtonElement {
  const made = element('button', { type: 'button', title: name, 'aria-label': name }, sign);
  made.addEventListener('click', press);
  return giveBackKeys(made, 'click');
}

/** Lets a control used with the pointer give the keys back to the page. */
export function giveBackKeys<T extends HTMLElement>(control: T, when: 'click' | 'change'): T {
  let pointed = false;
  control.addEventListener('pointerdown', () => (pointed = true));
  control.addEventListener('keydown', () => (pointed = false));
  control.addEventListener(when, () => {
    if (pointed) control.blur();
  });
  return control;
}

/** A labelled choice; `choose` gets the value chosen. */
export function select<T extends string>(
  name: string,
  options: readonly (readonly [T, string])[],
  choose: (value: T) => void,
): { element: HTMLLabelElement; select: HTMLSelectElement } {
  const box = document.createElement('select');
  box.append(...options.map(([value, text]) => new Option(text, value)));
  box.addEventListener('change', () => choose(box.value as T));
  giveBackKeys(box, 'change');
  return { element: labelled(name, box), select: box };
}

/** A labelled slider from `low` to `high`. */
export function slider(
  name: string,
  [low, high, step]: readonly [number, number, number],
  move: (value: number) => void,
): { element: HTMLLabelElement; input: HTMLInputElement } {
  const input = document.createElement('input');
  Object.assign(input, { type: 'range', min: low, max: high, step });
  input.addEventListener('input', () => move(Number(input.value)));
  return { element: labelled(name, input), input };
}

/** A labelled box to tick. */
export function tick(
  name: string,
  change: (on: boolean) => void,
): { element: HTMLLabelElement; input: HTMLInputElement } {
  const input = document.createElement('input');
  input.type = 'checkbox';
  input.addEventListener('change', () => change(input.checked));
  giveBackKeys(input, 'change');
  const made = labelled(name, input);
  made.prepend(input);
  return { element: made, input };
}

function labelled(name: string, control: HTMLElement): HTMLLabelElement {
  return element('label', {}, element('span', {}, name), control);
}

/** Lets the browser save a file. */
export function download(name: string, content: Blob): void {
  const url = URL.createObjectURL(content);
  const link = element('a', { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** A file name out of words: "Torque on tub" as "torque-on-tub". */
export function fileName(...words: string[]): string {
  const parts = words.map((word) => word.replace(/[^\p{L}\p{N}._]+/gu, '-'));
  return parts
    .join('-')
    .replace(/^-+|-+$/g, '')
    .toLowerCase();
}
