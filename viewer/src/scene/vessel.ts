import * as THREE from 'three';
import type { RunIndex, Vec3 } from '../model/bundle';
import { angleAt } from '../model/between';
import type { LoadedRun, SolidMesh } from '../model/run';
import type { Part, Showing } from './part';

/** The box: its far walls, so that one looks in, and its edges; a tub leaves only the floor. */
export function buildBox(run: LoadedRun): Part {
  const { lower, upper } = run.index.box;
  const size = upper.map((high, axis) => high - lower[axis]!) as Vec3;
  const shape = new THREE.BoxGeometry(...size);
  const wall = new THREE.MeshLambertMaterial({ side: THREE.BackSide, emissiveIntensity: 0.5 });
  const none = new THREE.MeshBasicMaterial({ visible: false });
  const edge = new THREE.LineBasicMaterial();
  const object = new THREE.Group();
  const side = run.solids.some(({ index }) => !index.moving) ? none : wall;
  const walls = new THREE.Mesh(shape, [side, side, side, side, none, wall]); // x, y, top, floor
  walls.receiveShadow = true;
  walls.visible = run.index.dimension === 3;
  object.add(walls, new THREE.LineSegments(new THREE.EdgesGeometry(shape), edge));
  object.position.set(...centreOf(run.index));
  return {
    object,
    update({ theme }) {
      wall.color.set(theme.wall).multiplyScalar(0.5);
      wall.emissive.set(theme.wall);
      edge.color.set(theme.edge);
    },
  };
}

export function centreOf({ box }: RunIndex): Vec3 {
  return box.lower.map((low, axis) => (low + box.upper[axis]!) / 2) as Vec3;
}

/** A solid; of one at rest only what looks towards the reader through the water is seen. */
export function buildSolid(run: LoadedRun, solid: SolidMesh): Part {
  const { moving, name, centre } = solid.index;
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(solid.vertices, 3));
  const open = !moving && run.index.dimension === 3;
  const triangles = open ? withoutBoxSides(run.index, solid) : solid.triangles;
  geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
  const material = new THREE.MeshStandardMaterial({
    roughness: 0.6,
    metalness: 0.05,
    flatShading: true,
  });
  const object = new THREE.Mesh(geometry, material);
  object.castShadow = moving;
  object.receiveShadow = true;
  object.renderOrder = 1;
  object.position.set(...centre);
  return {
    object,
    update({ moment, theme }: Showing) {
      object.rotation.z = angleAt(run, name, moment);
      material.color.set(moving ? theme.solid : theme.wall);
    },
  };
}

/** The triangles that do not lie in a side of the box, where nobody could look in through them. */
export function withoutBoxSides({ box }: RunIndex, solid: SolidMesh): Uint32Array {
  const { vertices, triangles, index } = solid;
  const margin = 1e-3 * Math.max(...box.upper.map((high, axis) => high - box.lower[axis]!));
  const inSide = (corner: number, axis: number, side: Vec3) =>
    Math.abs(vertices[3 * corner + axis]! + index.centre[axis]! - side[axis]!) < margin;
  const kept: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = [...triangles.subarray(t, t + 3)];
    const hidden = [0, 1, 2].some((axis) =>
      [box.lower, box.upper].some((side) => corners.every((corner) => inSide(corner, axis, side))),
    );
    if (!hidden) kept.push(...corners);
  }
  return Uint32Array.from(kept);
}
