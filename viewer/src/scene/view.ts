import * as THREE from 'three';
import type { RunIndex } from '../model/bundle';
import { decimalsFor, momentAt, type Moment } from '../model/moment';
import type { LoadedRun } from '../model/run';
import { buildEye, type Eye } from './camera';
import { noticeFor, timeShown, timeText } from './caption';
import { buildCloth } from './cloth';
import { legendsOf, namesOf } from './legend';
import { lightUp } from './light';
import { drawCaption, type Caption } from './overlay';
import type { ClothPart, Part, Showing } from './part';
import { hitOf, hitText, pointNear, pointOnSurface } from './pointing';
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
  readonly #cloth: ClothPart | null;
  readonly #parts: Part[];
  readonly #hiding: THREE.Object3D[]; // solids that may stand before the cloth
  #showing: Showing | null = null;
  #size = { width: 1, height: 1, ratio: 1 };

  /**
   * `box`: what the camera is to hold, common to all views. `renderer`: serves all views, which
   * copy what it has drawn.
   */
  constructor(
    readonly run: LoadedRun,
    box: RunIndex['box'],
    readonly named: boolean,
    readonly renderer: THREE.WebGLRenderer,
  ) {
    this.element.className = 'view';
    this.element.append(this.#canvas, this.#overlay);
    this.#overlay.className = 'caption';
    this.#canvas.setAttribute('role', 'img');
    this.#canvas.setAttribute('aria-label', `The wash of ${run.index.name}`);
    this.eye = buildEye(box, run.index.dimension, this.#canvas);
    this.#cloth = run.index.dimension === 2 ? buildThreads(run) : buildCloth(run);
    const solids = run.solids.map((solid) => buildSolid(run, solid));
    this.#hiding = solids.filter((_, i) => run.solids[i]!.index.moving).map((part) => part.object);
    this.#parts = partsOf(run, solids, this.#cloth);
    this.#scene.add(...this.#parts.map((part) => part.object), this.eye.camera);
    lightUp(this.eye.camera, this.#scene, box);
  }

  /** What is shown at a time: with the water, whose frames are not blended, a frame as it is. */
  moment(time: number, { slice }: Readonly<Settings>): Moment {
    const moment = momentAt(this.run.times, time);
    const whole = slice !== 'off' && this.run.field !== null;
    return whole ? { frame: moment.frame, next: moment.frame, part: 0 } : moment;
  }

  /** Time of what is shown at a time [s]. */
  timeAt(time: number, settings: Readonly<Settings>): number {
    return timeShown(this.run, this.moment(time, settings), time);
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
    const { width, height, ratio } = this.#size;
    const { renderer } = this;
    const { x, y } = renderer.getSize(new THREE.Vector2());
    if (x !== width || y !== height || renderer.getPixelRatio() !== ratio)
      renderer.setDrawingBufferSize(width, height, ratio);
    renderer.setClearColor(this.#showing.theme.background);
    renderer.render(this.#scene, this.eye.camera);
    this.#canvas.getContext('2d')!.drawImage(renderer.domElement, 0, 0);
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

  /** What is seen at a place in the element [pixels]: a piece and its stress, or nothing. */
  pointed(x: number, y: number): string {
    if (!this.#cloth || !this.#showing?.settings.cloth) return '';
    const { width, height } = this.#size;
    const place = new THREE.Vector2((2 * x) / width - 1, 1 - (2 * y) / height);
    const point = this.#pointAt(this.#cloth, place);
    const hit = point === null ? null : hitOf(this.#cloth.sheets, point);
    return hit ? hitText(this.run, hit, this.#showing) : '';
  }

  #pointAt({ surface, points }: ClothPart, place: THREE.Vector2): number | null {
    if (!surface) return pointNear(points, this.eye.camera, place, this.#size, NEAR);
    const ray = new THREE.Raycaster();
    ray.setFromCamera(place, this.eye.camera);
    return pointOnSurface(ray, surface, this.#hiding);
  }

  /** Fits the picture to the element; it is to be drawn anew then. */
  resize(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width > 0 && height > 0) this.fit(width, height, Math.min(window.devicePixelRatio, 2));
  }

  /** Makes the picture `width` by `height`, in pixels that are `ratio` times finer. */
  fit(width: number, height: number, ratio: number): void {
    this.#size = { width, height, ratio };
    for (const canvas of [this.#canvas, this.#overlay]) {
      canvas.width = Math.floor(width * ratio);
      canvas.height = Math.floor(height * ratio);
    }
    this.eye.fit(width, height);
  }

  /** What is written into the picture. */
  caption(): Caption {
    const { time, moment, settings, ranges, theme } = this.#showing!;
    const { index } = this.run;
    const decimals = decimalsFor(this.run.times);
    const lost = this.renderer.getContext().isContextLost();
    return {
      title: this.named ? index.name : '',
      time: timeText(this.timeAt(time, settings), index.scales.period, decimals),
      notice: lost ? LOST : noticeFor(this.run, time, moment, settings),
      names: namesOf(this.run, settings),
      legends: legendsOf(this.run, settings, ranges, theme),
    };
  }

  #caption(): void {
    const context = this.#overlay.getContext('2d')!;
    const { width, height, ratio } = this.#size;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    drawCaption(context, width, height, this.caption(), this.#showing!.theme);
  }

  /** Copies the view with its caption into another picture, from `x` on. */
  copyTo(target: CanvasRenderingContext2D, x: number): void {
    for (const layer of [this.#canvas, this.#overlay]) target.drawImage(layer, x, 0);
  }
}

/** Distance at which the pointer still finds a thread [pixels]. */
const NEAR = 8;
const LOST = 'The browser has taken the graphics away; they come back when it has room.';

function partsOf(run: LoadedRun, solids: readonly Part[], cloth: Part | null): Part[] {
  return [
    buildBox(run),
    ...solids,
    buildSlices(run),
    buildTrails(run),
    cloth,
    buildSurface(run),
  ].filter((part) => part !== null);
}
