import type { RunIndex, Vec3 } from '../model/bundle';
import type { Clock } from '../model/clock';
import type { LoadedRun } from '../model/run';
import type { Store } from '../model/store';
import type { Side } from './camera';
import { RangeFinder } from './ranges';
import type { Settings } from './settings';
import { followTheme, LIGHT, type Theme } from './theme';
import { View, type Shown } from './view';

/** All views of the page: one time, one choice of what to show, one camera. */
export class Stage {
  readonly views: View[];
  #theme: Theme = LIGHT;
  #stale = false; // whether the scenes do not show what they should
  #turned = false; // whether a camera moved since
  #waiting = false;
  #linking = false;
  readonly #ranges: RangeFinder;

  /** Throws where the browser has no WebGL. */
  constructor(
    readonly runs: readonly LoadedRun[],
    readonly clock: Clock,
    readonly settings: Store<Settings>,
  ) {
    this.#ranges = new RangeFinder(runs);
    const box = boxOfAll(runs);
    this.views = runs.map((run) => new View(run, box, runs.length > 1));
    this.#linkCameras();
  }

  get elements(): HTMLElement[] {
    return this.views.map((view) => view.element);
  }

  /** Begins to follow clock, settings, theme and size; the views must be in the page. */
  start(): void {
    followTheme((theme) => {
      this.#theme = theme;
      this.invalidate();
    });
    this.resize();
    const observer = new ResizeObserver(() => this.resize());
    for (const view of this.views) observer.observe(view.element);
    this.clock.subscribe(() => this.invalidate());
    this.settings.subscribe(() => this.invalidate());
  }

  /** Draws before the next picture of the screen. */
  invalidate(): void {
    this.#stale = true;
    this.#wait();
  }

  /** Draws at once. */
  draw(): void {
    const shown = this.#shown();
    for (const view of this.views) view.draw(shown);
    this.#stale = this.#turned = false;
  }

  /** Fits all views to the page and draws them at once, lest they flicker. */
  resize(): void {
    for (const view of this.views) view.resize();
    this.draw();
  }

  look(side: Side): void {
    for (const view of this.views) view.eye.look(side);
    this.#turn();
  }

  turn(azimuth: number, polar: number): void {
    for (const view of this.views)
      if (view.run.index.dimension === 3) view.eye.turn(azimuth, polar);
    this.#turn();
  }

  zoom(factor: number): void {
    for (const view of this.views) view.eye.zoom(factor);
    this.#turn();
  }

  /** The views side by side with their captions, together `width` by `height` in pixels
   * that are `fineness` times finer. */
  picture(width: number, height: number, fineness = 1): HTMLCanvasElement {
    const canvas = document.createElement('canvas');
    canvas.width = width * fineness;
    canvas.height = height * fineness;
    const context = canvas.getContext('2d')!;
    if (this.#stale) this.draw();
    const each = Math.floor(width / this.views.length);
    this.views.forEach((view, i) => view.paint(context, i * each, each, height, fineness));
    this.#turn();
    return canvas;
  }

  #shown(): Shown {
    const { time } = this.clock.state;
    const settings = this.settings.value;
    const moments = this.views.map((view) => view.moment(time, settings));
    const ranges = this.#ranges.find(settings, moments);
    return { time, settings, ranges, theme: this.#theme };
  }

  #turn(): void {
    this.#turned = true;
    this.#wait();
  }

  #wait(): void {
    if (this.#waiting) return;
    this.#waiting = true;
    requestAnimationFrame(() => {
      this.#waiting = false;
      if (this.#stale) this.draw();
      else if (this.#turned) for (const view of this.views) view.render();
      this.#turned = false;
    });
  }

  /** Moving one camera moves those of the other views. */
  #linkCameras(): void {
    for (const view of this.views)
      view.eye.moved(() => {
        if (this.#linking) return;
        this.#linking = true;
        for (const other of this.views)
          if (other !== view && other.run.index.dimension === view.run.index.dimension)
            other.eye.copy(view.eye);
        this.#linking = false;
        this.#turn();
      });
  }
}

/** The smallest box about those of all runs. */
function boxOfAll(runs: readonly LoadedRun[]): RunIndex['box'] {
  const along = (side: 'lower' | 'upper', pick: (...values: number[]) => number) =>
    [0, 1, 2].map((axis) => pick(...runs.map(({ index }) => index.box[side][axis]!))) as Vec3;
  return { lower: along('lower', Math.min), upper: along('upper', Math.max) };
}
