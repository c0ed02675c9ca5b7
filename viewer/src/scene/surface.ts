import * as THREE from 'three';
import type { Field } from '../model/field';
import type { LoadedRun } from '../model/run';
import type { Part } from './part';

/** The water's free surface: a faint plane at the top of the box, left out where a solid is. */
export function buildSurface(run: LoadedRun): Part | null {
  const { box, free_surface: free, dimension } = run.index;
  if (!free || dimension === 2) return null;
  const [width, depth] = [box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]];
  const material = new THREE.MeshBasicMaterial({
    transparent: true,
    opacity: 0.16,
    side: THREE.DoubleSide,
    depthWrite: false,
    alphaMap: run.field ? openingOf(run.field) : null,
  });
  const object = new THREE.Mesh(new THREE.PlaneGeometry(width, depth), material);
  object.position.set(box.lower[0] + width / 2, box.lower[1] + depth / 2, box.upper[2]);
  object.renderOrder = 5;
  return {
    object,
    update({ theme }) {
      material.color.set(theme.water);
    },
  };
}

/** Where the topmost cells of the first frame and their neighbours are open: white, else black. */
function openingOf({ index, solid }: Field): THREE.DataTexture {
  const [nx, ny, nz] = index.cells;
  const top = solid.subarray((nz - 1) * nx * ny, nz * nx * ny);
  const at = (i: number, j: number) =>
    top[Math.min(Math.max(i, 0), nx - 1) + nx * Math.min(Math.max(j, 0), ny - 1)]!;
  const pixels = new Uint8Array(4 * nx * ny);
  for (let j = 0; j < ny; j++)
    for (let i = 0; i < nx; i++) {
      const near = [at(i, j), at(i - 1, j), at(i + 1, j), at(i, j - 1), at(i, j + 1)];
      pixels.fill(255 - Math.max(...near), 4 * (i + nx * j), 4 * (i + nx * j) + 4);
    }
  const texture = new THREE.DataTexture(pixels, nx, ny);
  texture.magFilter = texture.minFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
