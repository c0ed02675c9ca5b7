import * as THREE from 'three';
import type { Field } from '../model/field';
import type { LoadedRun } from '../model/run';
import { opening, smoothMask } from './mask';
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

/** Where the topmost cells of the first frame are open: white, else black. */
function openingOf(field: Field): THREE.DataTexture {
  const [nx, ny, nz] = field.index.cells;
  const mask = smoothMask(field, 0).subarray((nz - 1) * nx * ny);
  const at = (i: number, j: number) =>
    mask[Math.min(Math.max(i, 0), nx - 1) + nx * Math.min(Math.max(j, 0), ny - 1)]!;
  const side = Math.min(6 * Math.max(nx, ny), 384);
  const pixels = new Uint8Array(4 * side * side);
  for (let row = 0; row < side; row++)
    for (let column = 0; column < side; column++) {
      const [x, y] = [((column + 0.5) * nx) / side - 0.5, ((row + 0.5) * ny) / side - 0.5];
      const [i, j] = [Math.floor(x), Math.floor(y)];
      const [p, q] = [x - i, y - j];
      const low = (1 - p) * at(i, j) + p * at(i + 1, j);
      const share = (1 - q) * low + q * ((1 - p) * at(i, j + 1) + p * at(i + 1, j + 1));
      const pixel = 4 * (column + side * row);
      pixels.fill(255 * opening(share + 0.08), pixel, pixel + 4);
    }
  const texture = new THREE.DataTexture(pixels, side, side);
  texture.magFilter = texture.minFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
