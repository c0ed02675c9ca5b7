import type { Mesh, Object3D } from 'three';
import type { Moment } from '../model/moment';
import type { Ranges } from './ranges';
import type { Settings } from './settings';
import type { Sheet } from './sheet';
import type { Theme } from './theme';

/** What a view shows at a moment. */
export interface Showing {
  time: number; // [s]
  moment: Moment;
  settings: Readonly<Settings>;
  ranges: Ranges;
  theme: Theme;
}

/** A part of the scene, which brings itself up to what is to be shown. */
export interface Part {
  object: Object3D;
  update(showing: Showing): void;
}

/** The cloth, with the points that it is drawn with [m]: x y z of each. */
export interface ClothPart extends Part {
  points: Float32Array;
  sheets: readonly Sheet[];
  surface: Mesh | null; // null where the cloth is threads
}
