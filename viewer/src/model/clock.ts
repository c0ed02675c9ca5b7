import { frameAt } from './moment';

/** The time that the views and plots of the page show, and whether it runs. */
export interface ClockState {
  time: number; // [s]
  playing: boolean;
  speed: number; // seconds of the run per second
}

export type ClockListener = (state: ClockState) => void;

export class Clock {
  #state: ClockState;
  #listeners = new Set<ClockListener>();

  /** `times`: the frames' times, ascending; stepping goes from one to the next. */
  constructor(readonly times: readonly number[]) {
    this.#state = { time: times[0] ?? 0, playing: false, speed: this.pace };
  }

  get state(): Readonly<ClockState> {
    return this.#state;
  }

  get begin(): number {
    return this.times[0] ?? 0;
  }

  get end(): number {
    return this.times.at(-1) ?? 0;
  }

  /** Speed at which the whole takes seconds to minutes: 1, or another power of ten. */
  get pace(): number {
    const span = this.end - this.begin;
    if (span > 100) return 10 ** Math.floor(Math.log10(span / 10));
    return span > 0 && span < 1 ? 1 / 10 ** Math.ceil(-Math.log10(span)) : 1;
  }

  subscribe(listener: ClockListener): () => void {
    this.#listeners.add(listener);
    listener(this.#state);
    return () => this.#listeners.delete(listener);
  }

  set(change: Partial<ClockState>): void {
    const next = { ...this.#state, ...change };
    next.time = Math.min(Math.max(next.time, this.begin), this.end);
    this.#state = next;
    for (const listener of this.#listeners) listener(next);
  }

  /** Goes `frames` frames on, or back, from the frame last passed; stops playing. */
  step(frames: number): void {
    const last = this.times.length - 1;
    const target = Math.min(Math.max(this.frame + frames, 0), last);
    this.set({ time: this.times[target] ?? 0, playing: false });
  }

  /** Number of the last frame not later than the time. */
  get frame(): number {
    return frameAt(this.times, this.#state.time);
  }

  /** Lets `seconds` of the viewer's time pass; starts over behind the end. */
  advance(seconds: number): void {
    if (!this.#state.playing || this.end <= this.begin) return;
    const time = this.#state.time + seconds * this.#state.speed;
    this.set({ time: time > this.end ? this.begin : time });
  }
}
