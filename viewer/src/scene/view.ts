import * as THREE from 'three';
import type { RunIndex } from '../model/bundle';
import { momentAt, type Moment } from '../model/moment';
import { fieldFrame } from '../model/field';
import type { LoadedRun } from '../model/run';
import { buildEye, type Eye } from './camera';
import { buildCloth } from './cloth';
import { legendsOf } from './legend';
import { lightUp } from './light';
import { drawCaption, type Caption } from './overlay';
import type { ClothPart, Part, Showing } from './part';
import type { Settings } from './settings';
import { buildSlices } from './slice';
import { buildSurface } from './surface';
import { buildThreads } from './threads';
import { buildTrails } from './trails';
import { buildBox, buildSolid } from './vessel';

export type Shown = Omit<Showing, 'moment'>;

/** One run seen in one rectangle of the page. */
export class View {
  readonly element = document.createElement('div');
  readonly eye: Eye;
  readonly #canvas = document.createElement('canvas');
  readonly #overlay = document.createElement('canvas');
  readonly #scene = new THREE.Scene();
  readonly #renderer: THREE.WebGLRenderer;
  readonly #cloth: ClothPart | null;
  readonly #parts: Part[];
  #showing: Showing | null = null;

  /** `box`: what the camera is to hold, common to all views; throws where there is no WebGL. */
  constructor(
    readonly run: LoadedRun,
    box: RunIndex['box'],
    readonly named: boolean,
  ) {
    this.element.className = 'view';
    this.element.append(this.#canvas, this.#overlay);
    this.#overlay.className = 'caption';
    this.#canvas.setAttribute('role', 'img');
    this.#canvas.setAttribute('aria-label', `The wash of ${run.index.name}`);
    this.#renderer = new THREE.WebGLRenderer({ canvas: this.#canvas, antialias: true });
    this.#renderer.shadowMap.enabled = true;
    this.eye = buildEye(box, run.index.dimension, this.#canvas);
    this.#cloth = run.index.dimension === 2 ? buildThreads(run) : buildCloth(run);
    this.#parts = partsOf(run, this.#cloth);
    this.#scene.add(...this.#parts.map((part) => part.object), this.eye.camera);
    lightUp(this.eye.camera, this.#scene, box);
  }

  /** What is shown at a time: with the water, whose frames are not blended, a frame as it is. */
  moment(time: number, { slice }: Readonly<Settings>): Moment {
    const moment = momentAt(this.run.times, time);
    const whole = slice !== 'off' && this.run.field !== null;
    return whole ? { frame: moment.frame, next: moment.frame, part: 0 } : moment;
  }

  /** Brings the scene up to date and draws it. */
  draw(shown: Shown): void {
    this.#showing = { ...shown, moment: this.moment(shown.time, shown.settings) };
    for (const part of this.#parts) part.update(this.#showing);
    this.render();
  }

  /** Draws the scene as it is, as after the camera moved. */
  render(): void {
    if (!this.#showing) return;
    this.#renderer.setClearColor(this.#showing.theme.background);
    this.#renderer.render(this.#scene, this.eye.camera);
    this.#caption();
  }

  /** Draws and returns the picture: red green blue alpha from its upper left corner. */
  pixels(): Uint8ClampedArray {
    this.render();
    return this.#read(this.#canvas.width, this.#canvas.height);
  }

  /** Returns when what was drawn last is done. */
  finish(): void {
    this.#read(1, 1);
  }

  #read(width: number, height: number): Uint8ClampedArray {
    const copy = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true })!;
    copy.drawImage(this.#canvas, 0, 0);
    return copy.getImageData(0, 0, width, height).data;
  }

  /** Positions of the points that the cloth is drawn with [m]. */
  points(): Float32Array {
    return this.#cloth?.points ?? new Float32Array();
  }

  /** Fits the picture to the element; it is to be drawn anew then. */
  resize(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width > 0 && height > 0) this.#size(width, height, Math.min(window.devicePixelRatio, 2));
  }

  #size(width: number, height: number, ratio: number): void {
    this.#renderer.setPixelRatio(ratio);
    this.#renderer.setSize(width, height, false);
    this.#overlay.width = width * ratio;
    this.#overlay.height = height * ratio;
    this.eye.fit(width, height);
  }

  /** What is written into the picture. */
  caption(): Caption {
    const { time, moment, settings, ranges, theme } = this.#showing!;
    const { index } = this.run;
    return {
      title: this.named ? index.name : '',
      time: timeText(timeShown(this.run, moment, time), index.scales.period),
      notice: noticeFor(this.run, time, moment, settings),
      legends: legendsOf(this.run, settings, ranges, theme),
    };
  }

  #caption(): void {
    const context = this.#overlay.getContext('2d')!;
    const ratio = this.#renderer.getPixelRatio();
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const { width, height } = this.#overlay;
    context.clearRect(0, 0, width, height);
    drawCaption(context, width / ratio, height / ratio, this.caption(), this.#showing!.theme);
  }

  /** Draws the view with its caption into a part of another picture, `fineness` times finer. */
  paint(
    target: CanvasRenderingContext2D,
    x: number,
    width: number,
    height: number,
    fineness: number,
  ): void {
    this.#size(width, height, fineness);
    this.render();
    for (const layer of [this.#canvas, this.#overlay])
      target.drawImage(layer, x * fineness, 0, width * fineness, height * fineness);
    this.resize();
  }
}

function partsOf(run: LoadedRun, cloth: Part | null): Part[] {
  return [
    buildBox(run),
    ...run.solids.map((solid) => buildSolid(run, solid)),
    buildSlices(run),
    buildTrails(run),
    cloth,
    buildSurface(run),
  ].filter((part) => part !== null);
}

/** Time, and cycles of the stroke where there is one. */
export function timeText(time: number, period: number): string {
  const cycles = period > 0 ? `  ·  cycle ${(time / period).toFixed(2)}` : '';
  return `t = ${time.toFixed(3)} s${cycles}`;
}

/** Time of what is shown [s]. */
function timeShown({ times }: LoadedRun, { frame, next, part }: Moment, time: number): number {
  const from = times[frame] ?? time;
  return from + part * ((times[next] ?? from) - from);
}

function noticeFor(run: LoadedRun, time: number, moment: Moment, settings: Settings): string {
  const { times, field } = run;
  if (times.length === 0) return 'This run kept no frames.';
  const shown = times[moment.frame]!;
  if (moment.frame === times.length - 1 && time > shown + 1e-6)
    return `ended at t = ${shown.toFixed(3)} s: last frame`;
  const water = field && settings.slice !== 'off' ? field.times[fieldFrame(field, shown)]! : shown;
  return water < shown - 1e-9 ? `water of t = ${water.toFixed(3)} s` : '';
}
