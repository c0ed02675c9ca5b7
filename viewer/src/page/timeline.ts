import type { Clock } from '../model/clock';
import { decimalsFor } from '../model/moment';
import { timeText } from '../scene/caption';
import { button, make, select } from '../dom';

/** Speeds to choose from: seconds of the run per second of the reader. */
export function speedsOf({ pace }: Clock): number[] {
  return [0.1, 0.25, 0.5, 1, 2, 4].map((times) => Number((times * pace).toPrecision(6)));
}

/** Tells the time of what is shown, and calls when that changes though the clock stands. */
export interface Showing {
  timeShown(): number;
  readonly settings: { subscribe(listener: () => void): void };
}

/**
 * Play, step, scrub, speed, and the time of what is shown; `period` of the stroke [s], 0 where
 * there is none.
 */
export function buildTimeline(
  clock: Clock,
  period: number,
  showing: Showing | null = null,
): HTMLElement {
  const play = button('▶', 'Play (space)', () => togglePlaying(clock));
  play.classList.add('play');
  const scrub = scrubber(clock);
  const readout = make('output', 'time');
  readout.setAttribute('aria-live', 'off'); // the slider tells the time to those who do not see it
  const decimals = decimalsFor(clock.times);
  const speed = select(
    'speed',
    speedsOf(clock).map((value) => [String(value), `${value}×`] as const),
    (value) => clock.set({ speed: Number(value) }),
  );
  const tell = () => {
    const text = timeText(showing?.timeShown() ?? clock.state.time, period, decimals);
    scrub.setAttribute('aria-valuetext', text);
    readout.textContent = text;
  };
  clock.subscribe(({ time, playing, speed: now }) => {
    const name = playing ? 'Pause (space)' : 'Play (space)';
    play.textContent = playing ? '❚❚' : '▶';
    play.title = name;
    play.setAttribute('aria-label', name);
    scrub.value = String(time);
    speed.select.value = String(now);
    tell();
  });
  showing?.settings.subscribe(tell);
  const element = make(
    'div',
    'timeline',
    play,
    button('|◂', 'First frame (Home)', () => clock.set({ time: clock.begin, playing: false })),
    button('◂', 'Frame before (left arrow)', () => clock.step(-1)),
    button('▸', 'Next frame (right arrow)', () => clock.step(1)),
    scrub,
    readout,
    speed.element,
  );
  element.hidden = clock.times.length < 2;
  return element;
}

function scrubber(clock: Clock): HTMLInputElement {
  const scrub = document.createElement('input');
  Object.assign(scrub, { type: 'range', min: clock.begin, max: clock.end, step: 'any' });
  scrub.className = 'scrub';
  scrub.setAttribute('aria-label', 'Time');
  scrub.addEventListener('input', () => clock.set({ time: Number(scrub.value), playing: false }));
  return scrub;
}

/** Plays or pauses; at the end it begins anew. */
export function togglePlaying(clock: Clock): void {
  const { time, playing } = clock.state;
  const over = !playing && time >= clock.end - 1e-9;
  clock.set({ playing: !playing, ...(over ? { time: clock.begin } : {}) });
}

/** Goes to the next speed, or the one before. */
export function changeSpeed(clock: Clock, by: 1 | -1): void {
  const speeds = speedsOf(clock);
  const now = speeds.findIndex((value) => value >= clock.state.speed);
  const next = Math.min(Math.max(now + by, 0), speeds.length - 1);
  clock.set({ speed: speeds[next]! });
}

/** Lets the clock run while it plays, picture by picture of the screen. */
export function keepTime(clock: Clock): void {
  let last: number | null = null;
  const turn = (now: number) => {
    if (!clock.state.playing) return void (last = null);
    if (last !== null) clock.advance(Math.min((now - last) / 1000, 0.25));
    last = now;
    requestAnimationFrame(turn);
  };
  clock.subscribe(({ playing }) => {
    if (playing && last === null) {
      last = performance.now();
      requestAnimationFrame(turn);
    }
  });
}
