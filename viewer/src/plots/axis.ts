import type { Clock } from '../model/clock';

/**
 * The time that holds all statistics windows, as far as there are values; null where they have
 * none in common with the `whole` time of the values [s].
 */
export function commonWindow(
  windows: readonly (readonly [number, number])[],
  [begin, end]: readonly [number, number],
): [number, number] | null {
  const known = windows.filter(([from, to]) => to > from && to > begin && from < end);
  if (known.length === 0) return null;
  const from = Math.min(...known.map((window) => window[0]));
  const to = Math.max(...known.map((window) => window[1]));
  return [Math.max(from, begin), Math.min(to, end)];
}

/** The time axis that all plots share: what of it is seen, and the time pointed at. */
export class TimeAxis {
  #range: [number, number];
  #hover: number | null = null;
  #rangeListeners = new Set<() => void>();
  #cursorListeners = new Set<() => void>();
  #scheduled = false;
  #zoomed = false;

  /** `whole`: all time that the histories cover [s]. */
  constructor(
    readonly clock: Clock,
    readonly whole: [number, number],
  ) {
    this.#range = whole;
    clock.subscribe(() => this.#moved());
  }

  get range(): [number, number] {
    return this.#range;
  }

  /** The time under the pointer [s]; null where it is nowhere over a plot. */
  get hover(): number | null {
    return this.#hover;
  }

  /** The time whose values the legends show [s]. */
  get cursor(): number {
    return this.#hover ?? this.clock.state.time;
  }

  set hover(time: number | null) {
    this.#hover = time;
    this.#moved();
  }

  /** Calls back, at most once a picture of the screen, when another time is shown. */
  onRange(listener: () => void): void {
    this.#rangeListeners.add(listener);
  }

  /** Calls back, at most once a picture of the screen, when clock or pointer have moved. */
  onCursor(listener: () => void): void {
    this.#cursorListeners.add(listener);
  }

  /** Shows the time between, kept within the whole and no shorter than a millionth of it. */
  show(from: number, to: number): void {
    const [begin, end] = this.whole;
    const range: [number, number] = [Math.max(from, begin), Math.min(to, end)];
    if (!(range[1] - range[0] >= 1e-6 * (end - begin))) return;
    this.#range = range;
    this.#zoomed = true;
    this.#moved();
  }

  /** Zooms by `factor` about a time; below one it shows less. */
  zoom(factor: number, about: number): void {
    const [from, to] = this.#range;
    this.show(about + factor * (from - about), about + factor * (to - about));
  }

  reset(): void {
    this.show(...this.whole);
  }

  #moved(): void {
    if (this.#scheduled) return;
    this.#scheduled = true;
    requestAnimationFrame(() => {
      this.#scheduled = false;
      if (this.#zoomed) for (const listener of this.#rangeListeners) listener();
      this.#zoomed = false;
      for (const listener of this.#cursorListeners) listener();
    });
  }
}
