import * as THREE from 'three';
import type { RunIndex, Vec3 } from '../model/bundle';
import type { Clock } from '../model/clock';
import type { LoadedRun } from '../model/run';
import type { Store } from '../model/store';
import type { Side } from './camera';
import { RangeFinder } from './ranges';
import { followPointer } from './readout';
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

  constructor(
    readonly runs: readonly LoadedRun[],
    readonly clock: Clock,
    readonly settings: Store<Settings>,
    readonly renderer: THREE.WebGLRenderer,
  ) {
    this.#ranges = new RangeFinder(runs);
    const box = boxOfAll(runs);
    this.views = runs.map((run) => new View(run, box, runs.length > 1, renderer));
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
    for (const view of this.views) {
      observer.observe(view.element);
      followPointer(view, this.clock);
    }
    this.clock.subscribe(() => this.invalidate());
    this.settings.subscribe(() => this.invalidate());
    for (const event of ['webglcontextlost', 'webglcontextrestored'])
      this.renderer.domElement.addEventListener(event, () => this.invalidate());
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
    for (const { run, eye } of this.#leaders())
      if (run.index.dimension === 3) eye.turn(azimuth, polar);
    this.#turn();
  }

  zoom(factor: number): void {
    for (const { eye } of this.#leaders()) eye.zoom(factor);
    this.#turn();
  }

  /** The first view of either dimension, whose camera the others follow. */
  #leaders(): View[] {
    const dimensions = this.views.map(({ run }) => run.index.dimension);
    return this.views.filter((_, i) => dimensions.indexOf(dimensions[i]!) === i);
  }

  /**
   * The views side by side with their captions, all at one scale, together `width` by `height`
   * pixels; with a `fineness` of 2, letters and lines are drawn twice as large.
   */
  picture(width: number, height: number, fineness = 1): HTMLCanvasElement {
    const canvas = document.createElement('canvas');
    Object.assign(canvas, { width, height });
    const context = canvas.getContext('2d')!;
    if (this.#stale) this.draw();
    const each = Math.floor(width / this.views.length);
    for (const view of this.views) view.fit(each / fineness, height / fineness, fineness);
    this.views.forEach((view, i) => {
      view.render();
      view.copyTo(context, i * each);
    });
    for (const view of this.views) view.resize();
    for (const view of this.views) view.render();
    return canvas;
  }

  /** Time of what the views show [s]; the clock's where they differ, as the captions tell. */
  timeShown(): number {
    const { time } = this.clock.state;
    const [first, ...others] = this.views.map((view) => view.timeAt(time, this.settings.value));
    return others.every((other) => other === first) ? (first ?? time) : time;
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

/** Draws the views; null where the browser has no WebGL 2 to spare. */
export function createRenderer(): THREE.WebGLRenderer | null {
  try {
    const renderer = new THREE.WebGLRenderer({ antialias: true });
    renderer.shadowMap.enabled = true;
    return renderer;
  } catch {
    return null;
  }
}
