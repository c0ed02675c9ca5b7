import * as THREE from 'three';
import { expansion, type Field } from '../model/field';
import type { Part, Showing } from './part';
import type { Sampler } from './sampling';
import type { Rectangle } from './slice';

/** Arrows along the longer side of a slice, in two and in three dimensions. */
const ALONG = { 2: 26, 3: 20 } as const;
/** Length of the arrow of the frame's largest speed, were there no limit [distances of arrows]. */
const LENGTH = { 2: 2.4, 3: 4.5 } as const;
const LONGEST = 1.6;
const SHORTEST = 0.1; // shorter ones are left out
const NARROWEST = 0.45; // shorter ones are as wide as one of this length

/** Arrows of the velocity's part in the plane: as long as it is fast, up to a limit. */
export interface Arrows {
  object: Part['object'];
  show(rectangle: Rectangle, frame: number, showing: Showing): void;
}

export function buildArrows(field: Field, sampler: Sampler): Arrows {
  const material = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide });
  const mesh = new THREE.InstancedMesh(arrowShape(), material, ALONG[field.axes] ** 2);
  mesh.frustumCulled = false;
  mesh.renderOrder = 1;
  return {
    object: mesh,
    show(rectangle, frame, { settings, theme }) {
      mesh.visible = settings.arrows;
      if (!mesh.visible) return;
      material.color.set(theme.arrow);
      mesh.count = place(mesh, rectangle, new Velocity(field, sampler, frame));
      mesh.instanceMatrix.needsUpdate = true;
    },
  };
}

/** A flat arrow along x of length 1, which begins at the origin. */
function arrowShape(): THREE.BufferGeometry {
  const outline = [0, 0.06, 0.55, 0.06, 0.55, 0.22, 1, 0, 0.55, -0.22, 0.55, -0.06, 0, -0.06];
  const shape = new THREE.Shape();
  for (let i = 0; i < outline.length; i += 2) {
    if (i === 0) shape.moveTo(outline[0]!, outline[1]!);
    else shape.lineTo(outline[i]!, outline[i + 1]!);
  }
  return new THREE.ShapeGeometry(shape);
}

class Velocity {
  readonly #table: Float32Array;
  readonly largest: number;

  constructor(
    readonly field: Field,
    readonly sampler: Sampler,
    readonly frame: number,
  ) {
    this.largest = field.index.velocity.largest[frame] ?? 0;
    this.#table = expansion(this.largest);
  }

  /** Velocity at a place [m/s]; none in solids. */
  at(place: THREE.Vector3, out: THREE.Vector3): THREE.Vector3 {
    const { field, sampler, frame } = this;
    sampler.seek(place.x, place.y, place.z);
    out.set(0, 0, 0);
    if (sampler.value(field.solid, frame * field.cells) > 127) return out;
    for (let axis = 0; axis < field.axes; axis++) {
      const begin = (frame * field.axes + axis) * field.cells;
      let sum = 0;
      for (let m = 0; m < 8; m++)
        sum += sampler.weight[m]! * this.#table[128 + field.velocity[begin + sampler.corner[m]!]!]!;
      out.setComponent(axis, sum);
    }
    return out;
  }
}

/** Places the arrows and returns their number. */
function place(mesh: THREE.InstancedMesh, plane: Rectangle, velocity: Velocity): number {
  const step = Math.max(plane.across.length(), plane.up.length()) / ALONG[velocity.field.axes];
  const [ex, ey] = [plane.across.clone().normalize(), plane.up.clone().normalize()];
  const normal = ex.clone().cross(ey);
  const [at, u, along, side] = Array.from({ length: 4 }, () => new THREE.Vector3()) as [
    THREE.Vector3,
    THREE.Vector3,
    THREE.Vector3,
    THREE.Vector3,
  ];
  const matrix = new THREE.Matrix4();
  const unit = velocity.largest > 0 ? (LENGTH[velocity.field.axes] * step) / velocity.largest : 0;
  let count = 0;
  for (let p = step / 2; p < plane.across.length(); p += step)
    for (let q = step / 2; q < plane.up.length(); q += step) {
      at.copy(plane.corner).addScaledVector(ex, p).addScaledVector(ey, q);
      velocity.at(at, u).addScaledVector(normal, -u.dot(normal));
      const length = Math.min(unit * u.length(), LONGEST * step);
      if (length < SHORTEST * step || count >= mesh.instanceMatrix.count) continue;
      along.copy(u).setLength(length);
      side
        .copy(normal)
        .cross(along)
        .setLength(Math.max(length, NARROWEST * step));
      at.addScaledVector(along, -0.5);
      mesh.setMatrixAt(count++, matrix.makeBasis(along, side, normal).setPosition(at));
    }
  return count;
}
