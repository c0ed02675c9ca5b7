import type { Clock } from '../model/clock';
import type { Store } from '../model/store';
import type { plots } from '../plots/registry';
import type { Caption } from '../scene/overlay';
import type { Settings } from '../scene/settings';
import type { Stage } from '../scene/stage';

/** What the page offers to programs, such as `washtub movie` and the tests: `window.washtub`. */
export interface WashtubPage {
  frames: number; // 0 where there are no views
  times: readonly number[]; // of the frames [s]
  time(): number; // shown now [s]
  playing(): boolean;
  speed(): number;
  /** Shows the run at `time` [s], drawn on return; stops playing. */
  show(time: number): void;
  /** The views at this size [pixels] with legend and time, as a data URL; above 540 pixels high
   * letters and lines grow with it. */
  capture(width: number, height: number, type?: string): string;
  /** Time to bring the scene up to date, and to draw it as well, at the time shown [ms]. */
  drawTime(): { update: number; whole: number };
  settings(): Readonly<Settings>;
  set(change: Partial<Settings>): void;
  captions(): Caption[]; // one per view
  /** Positions of the drawn cloth of a view [m]: x y z of each point. */
  points(view: number): Float32Array;
  /** Picture of a view: red green blue alpha from its upper left corner. */
  pixels(view: number): Uint8ClampedArray;
  directions(): number[][]; // of the cameras, from their target
  plots: typeof plots; // read access to what the plots show
}

declare global {
  interface Window {
    washtub?: WashtubPage;
  }
}

export function buildApi(
  clock: Clock,
  settings: Store<Settings>,
  stage: Stage | null,
): Omit<WashtubPage, 'plots'> {
  const views = stage?.views ?? [];
  const times = stage ? clock.times : [];
  return {
    frames: times.length,
    times,
    time: () => clock.state.time,
    playing: () => clock.state.playing,
    speed: () => clock.state.speed,
    show(time) {
      clock.set({ time, playing: false });
      stage?.draw();
    },
    capture(width, height, type = 'image/png') {
      if (!stage) throw new Error('There are no views: no frames, or no WebGL.');
      return stage.picture(width, height, Math.max(height / 540, 1)).toDataURL(type, 0.92);
    },
    drawTime() {
      const begin = performance.now();
      stage?.draw();
      const update = performance.now() - begin;
      views.forEach((view) => view.finish());
      return { update, whole: performance.now() - begin };
    },
    settings: () => settings.value,
    set(change) {
      settings.set(change);
      stage?.draw();
    },
    captions: () => views.map((view) => view.caption()),
    points: (view) => views[view]?.points() ?? new Float32Array(),
    pixels: (view) => views[view]?.pixels() ?? new Uint8ClampedArray(),
    directions: () => views.map(({ eye }) => eye.camera.position.clone().sub(eye.target).toArray()),
  };
}
