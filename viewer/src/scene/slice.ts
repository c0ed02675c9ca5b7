import * as THREE from 'three';
import type { Vec3 } from '../model/bundle';
import { fieldFrame, quantityOf, type Field, type FieldQuantity } from '../model/field';
import type { LoadedRun } from '../model/run';
import { buildArrows, type Arrows } from './arrows';
import { channels, mapOffset } from './colours';
import { opening, smoothMask } from './mask';
import type { Part, Showing } from './part';
import { Sampler } from './sampling';
import type { Theme } from './theme';

/** A rectangle in space: a corner and two sides at right angles [m]. */
export interface Rectangle {
  corner: THREE.Vector3;
  across: THREE.Vector3;
  up: THREE.Vector3;
}

/** A field's frame: the values shown and the share of solids in all cells. */
interface Cells {
  values: Float32Array;
  mask: Float32Array;
  frame: number;
}

/** Most picture elements along a side of a slice. */
const FINEST = 256;

/** Colour map of a quantity, and whether it takes both signs. */
export function mapFor(quantity: FieldQuantity, theme: Theme) {
  const signed = quantity !== 'speed';
  return { map: signed ? theme.signed : theme.speed, signed };
}

/** The slices through the water of a run that carries it. */
export function buildSlices(run: LoadedRun): Part | null {
  const { field } = run;
  if (!field) return null;
  const values = new Float32Array(field.cells);
  const planes = (['vertical', 'horizontal'] as const).map((way) => ({
    way,
    plane: new Plane(field, run.index.dimension),
  }));
  let mask: Float32Array = new Float32Array();
  let masked = -1; // frame of the mask
  const object = new THREE.Group();
  object.add(...planes.map(({ plane }) => plane.object));
  return {
    object,
    update(showing) {
      const { slice, quantity } = showing.settings;
      object.visible = slice !== 'off';
      if (!object.visible) return;
      const frame = fieldFrame(field, showing.time);
      quantityOf(field, quantity, frame, values);
      if (frame !== masked) mask = smoothMask(field, (masked = frame));
      for (const { way, plane } of planes) {
        const rectangle = rectangleFor(run, way, showing);
        plane.object.visible = rectangle !== null;
        if (rectangle) plane.show(rectangle, { values, mask, frame }, showing);
      }
    },
  };
}

/** Where a slice lies, or null where it is not to be shown. */
function rectangleFor(
  run: LoadedRun,
  way: 'vertical' | 'horizontal',
  { settings }: Showing,
): Rectangle | null {
  const { lower, upper } = run.index.box;
  const size = upper.map((high, axis) => high - lower[axis]!) as Vec3;
  if (run.index.dimension === 2 || way === 'horizontal') {
    if (run.index.dimension === 3 && settings.slice === 'vertical') return null;
    if (run.index.dimension === 2 && way === 'vertical') return null;
    const z = run.index.dimension === 2 ? lower[2] : lower[2] + settings.height * size[2];
    return {
      corner: new THREE.Vector3(lower[0], lower[1], z),
      across: new THREE.Vector3(size[0], 0, 0),
      up: new THREE.Vector3(0, size[1], 0),
    };
  }
  return settings.slice === 'horizontal' ? null : vertical(run, settings.angle);
}

/** The plane through the axis at an angle from x [degrees], as far as the box reaches. */
function vertical(run: LoadedRun, angle: number): Rectangle {
  const { lower, upper } = run.index.box;
  const axis = axisOf(run);
  const turn = (angle * Math.PI) / 180;
  const way = new THREE.Vector3(Math.cos(turn), Math.sin(turn), 0);
  const reach = (sign: number) =>
    Math.min(
      ...[0, 1].map((i) => {
        const w = sign * way.getComponent(i);
        const side = w > 0 ? upper[i]! : lower[i]!;
        return Math.abs(w) < 1e-9 ? Infinity : (side - axis.getComponent(i)) / w;
      }),
    );
  const corner = axis.clone().addScaledVector(way, -reach(-1)).setZ(lower[2]);
  return {
    corner,
    across: way.multiplyScalar(reach(1) + reach(-1)),
    up: new THREE.Vector3(0, 0, upper[2] - lower[2]),
  };
}

/** Axis of the moving solid, or else the middle of the box. */
function axisOf(run: LoadedRun): THREE.Vector3 {
  const { lower, upper } = run.index.box;
  const moving = run.solids.find(({ index }) => index.moving)?.index.centre;
  return moving
    ? new THREE.Vector3(...moving)
    : new THREE.Vector3((lower[0] + upper[0]) / 2, (lower[1] + upper[1]) / 2, 0);
}

class Plane {
  readonly object = new THREE.Group();
  readonly #sampler: Sampler;
  readonly #arrows: Arrows;
  readonly #mesh: THREE.Mesh<THREE.BufferGeometry, THREE.MeshBasicMaterial>;
  readonly #pixels: Uint8Array;
  readonly #texture: THREE.DataTexture;
  readonly #width: number;
  readonly #height: number;

  constructor(
    readonly field: Field,
    readonly dimension: 2 | 3,
  ) {
    this.#sampler = new Sampler(field);
    this.#arrows = buildArrows(field, this.#sampler);
    const cells = Math.max(...field.index.cells);
    this.#width = this.#height = Math.min(FINEST, Math.max(cells, Math.min(3 * cells, 192)));
    this.#pixels = new Uint8Array(4 * this.#width * this.#height);
    this.#texture = textureOf(this.#pixels, this.#width, this.#height);
    this.#mesh = new THREE.Mesh(
      new THREE.PlaneGeometry(1, 1).translate(0.5, 0.5, 0),
      new THREE.MeshBasicMaterial({
        map: this.#texture,
        side: THREE.DoubleSide,
        transparent: true,
        alphaTest: 0.02,
        polygonOffset: true, // behind its arrows
        polygonOffsetFactor: 1,
        polygonOffsetUnits: 1,
      }),
    );
    this.#mesh.matrixAutoUpdate = false;
    this.object.add(this.#mesh, this.#arrows.object);
  }

  show(rectangle: Rectangle, cells: Cells, showing: Showing): void {
    const { corner, across, up } = rectangle;
    const normal = across.clone().cross(up).normalize();
    this.#mesh.matrix.makeBasis(across, up, normal).setPosition(corner);
    this.#mesh.matrixWorldNeedsUpdate = true;
    this.#paint(rectangle, cells, showing);
    this.#arrows.show(rectangle, cells.frame, showing);
  }

  /** Colours each picture element; in solids it is left out, or grey in two dimensions. */
  #paint(
    { corner, across, up }: Rectangle,
    { values, mask }: Cells,
    { settings, ranges, theme }: Showing,
  ): void {
    const { map, signed } = mapFor(settings.quantity, theme);
    const low = signed ? -ranges.field : 0;
    const solid = this.dimension === 2 ? channels(theme.solid) : null;
    for (let row = 0, at = 0; row < this.#height; row++)
      for (let column = 0; column < this.#width; column++, at += 4) {
        const p = (column + 0.5) / this.#width;
        const q = (row + 0.5) / this.#height;
        this.#sampler.seek(
          corner.x + p * across.x + q * up.x,
          corner.y + p * across.y + q * up.y,
          corner.z + p * across.z + q * up.z,
        );
        const offset = mapOffset(this.#sampler.value(values), low, ranges.field);
        const clear = opening(this.#sampler.value(mask));
        for (let c = 0; c < 3; c++) {
          const colour = map[offset + c]!;
          this.#pixels[at + c] = solid ? solid[c]! + clear * (colour - solid[c]!) : colour;
        }
        this.#pixels[at + 3] = solid ? 255 : 255 * clear;
      }
    this.#texture.needsUpdate = true;
  }
}

function textureOf(pixels: Uint8Array, width: number, height: number): THREE.DataTexture {
  const texture = new THREE.DataTexture(pixels, width, height);
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.magFilter = texture.minFilter = THREE.LinearFilter;
  return texture;
}
