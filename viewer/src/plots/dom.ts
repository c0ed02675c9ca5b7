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

export function button(label: string, title: string, act: () => void): HTMLButtonElement {
  const made = element('button', { type: 'button', title }, label);
  made.addEventListener('click', act);
  return made;
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
