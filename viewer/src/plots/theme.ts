const resolved = new Map<string, string>();
const listeners = new Set<() => void>();

/** A colour that a canvas understands: of a custom property such as "--ink", or as it is. */
export function colourOf(name: string): string {
  if (!name.startsWith('--')) return name;
  let colour = resolved.get(name);
  if (colour === undefined) {
    colour = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
    resolved.set(name, colour);
  }
  return colour;
}

/** The same colour for a style sheet. */
export function cssColour(name: string): string {
  return name.startsWith('--') ? `var(${name})` : name;
}

/** Calls back whenever the page turns light or dark. */
export function onThemeChange(listener: () => void): void {
  if (listeners.size === 0)
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
      resolved.clear();
      for (const each of listeners) each();
    });
  listeners.add(listener);
}
