/** A button with a name for those who do not see its sign. */
export function button(sign: string, name: string, press: () => void): HTMLButtonElement {
  const element = document.createElement('button');
  element.type = 'button';
  element.textContent = sign;
  element.title = name;
  element.setAttribute('aria-label', name);
  element.addEventListener('click', press);
  return giveBackKeys(element, 'click');
}

/** Lets a control used with the pointer give the keys back to the page. */
function giveBackKeys<T extends HTMLElement>(control: T, when: 'click' | 'change'): T {
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
  const element = labelled(name, input);
  element.prepend(input);
  return { element, input };
}

function labelled(name: string, control: HTMLElement): HTMLLabelElement {
  const label = document.createElement('label');
  const text = document.createElement('span');
  text.textContent = name;
  label.append(text, control);
  return label;
}

/** An element with a class and contents. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  className: string,
  ...contents: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  if (className) element.className = className;
  element.append(...contents);
  return element;
}
