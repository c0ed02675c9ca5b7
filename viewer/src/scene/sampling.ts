import type { Vec3 } from '../model/bundle';
import type { Field } from '../model/field';

/** Interpolates values at the cells' centres, linear between them and constant at the margin. */
export class Sampler {
  readonly #cells: readonly number[];
  readonly #lower: Vec3;
  readonly #spacing: Vec3;
  readonly corner = new Int32Array(8);
  readonly weight = new Float32Array(8);

  constructor({ index }: Pick<Field, 'index'>) {
    this.#cells = index.cells;
    this.#lower = index.lower;
    this.#spacing = index.spacing;
  }

  /** Finds the eight cells about a place [m] and their weights. */
  seek(x: number, y: number, z: number): void {
    const [nx, ny] = this.#cells as [number, number, number];
    const [i, p, di] = this.#along(x, 0);
    const [j, q, dj] = this.#along(y, 1);
    const [k, r, dk] = this.#along(z, 2);
    const first = i + nx * (j + ny * k);
    for (let m = 0; m < 8; m++) {
      const [a, b, c] = [m & 1, (m >> 1) & 1, m >> 2];
      this.corner[m] = first + a * di + nx * (b * dj + ny * c * dk);
      this.weight[m] = (a ? p : 1 - p) * (b ? q : 1 - q) * (c ? r : 1 - r);
    }
  }

  value(values: ArrayLike<number>, begin = 0): number {
    let sum = 0;
    for (let m = 0; m < 8; m++) sum += this.weight[m]! * values[begin + this.corner[m]!]!;
    return sum;
  }

  #along(x: number, axis: number): [number, number, number] {
    const cells = this.#cells[axis]!;
    const at = (x - this.#lower[axis]!) / this.#spacing[axis]! - 0.5;
    const low = Math.min(Math.max(Math.floor(at), 0), cells - 1);
    const next = low + 1 < cells && at > 0 ? 1 : 0;
    return [low, next ? at - low : 0, next];
  }
}
