import type { ClothIndex } from '../model/bundle';
import { refine, type Refinement } from './spline';

/** One piece of cloth refined to a smooth surface; point (a, b) is `point` + a + rows b. */
export class Sheet {
  readonly points: number;
  readonly #r: Refinement;
  readonly #s: Refinement;
  readonly #along: Float32Array; // [node of s][point of r][x y z and their slopes along r]

  /** `point`: number of the piece's first point among those of all pieces. */
  constructor(
    readonly piece: ClothIndex['pieces'][number],
    parts: number,
    readonly point: number,
  ) {
    this.#r = refine(piece.nr, parts, piece.closed[0]);
    this.#s = refine(piece.ns, parts, piece.closed[1]);
    this.points = this.#r.points * this.#s.points;
    this.#along = new Float32Array(6 * this.#r.points * piece.ns);
  }

  /** Corners of the triangles, as numbers of points. */
  triangles(): number[] {
    const { points: rows } = this.#r;
    const corners: number[] = [];
    for (let b = 0; b + 1 < this.#s.points; b++)
      for (let a = 0; a + 1 < rows; a++) {
        const i = this.point + a + rows * b;
        corners.push(i, i + 1, i + rows, i + 1, i + 1 + rows, i + rows);
      }
    return corners;
  }

  /** Whether a point of the piece lies on an open edge. */
  atHem(point: number): boolean {
    const a = point % this.#r.points;
    const b = Math.floor(point / this.#r.points);
    const [closedR, closedS] = this.piece.closed;
    return (
      (!closedR && (a === 0 || a === this.#r.points - 1)) ||
      (!closedS && (b === 0 || b === this.#s.points - 1))
    );
  }

  /** The node nearest to a point of the piece, counted over all pieces. */
  nodeAt(point: number): number {
    const { first, nr, ns, closed } = this.piece;
    const rows = this.#r.points;
    const [i, nextI, p] = between(point % rows, rows, nr, closed[0]);
    const [j, nextJ, q] = between(Math.floor(point / rows), this.#s.points, ns, closed[1]);
    return first + (p < 0.5 ? i : nextI) + nr * (q < 0.5 ? j : nextJ);
  }

  /** Writes the surface's points and unit normals for the nodes' positions, all x y z. */
  shape(nodes: Float32Array, positions: Float32Array, normals: Float32Array): void {
    this.#refineAlongR(nodes);
    for (let b = 0; b < this.#s.points; b++)
      for (let a = 0; a < this.#r.points; a++) this.#place(a, b, positions, normals);
  }

  #refineAlongR(nodes: Float32Array): void {
    const { points, node, weight, slope } = this.#r;
    const { first, nr, ns } = this.piece;
    for (let j = 0; j < ns; j++)
      for (let a = 0; a < points; a++)
        for (let axis = 0; axis < 3; axis++) {
          let place = 0;
          let change = 0;
          for (let m = 4 * a; m < 4 * a + 4; m++) {
            const x = nodes[3 * (first + nr * j + node[m]!) + axis]!;
            place += weight[m]! * x;
            change += slope[m]! * x;
          }
          const at = 6 * (points * j + a) + axis;
          this.#along[at] = place;
          this.#along[at + 3] = change;
        }
  }

  #place(a: number, b: number, positions: Float32Array, normals: Float32Array): void {
    const { node, weight, slope } = this.#s;
    const along = this.#along;
    let x = 0;
    let y = 0;
    let z = 0;
    let rx = 0;
    let ry = 0;
    let rz = 0;
    let sx = 0;
    let sy = 0;
    let sz = 0;
    for (let m = 4 * b; m < 4 * b + 4; m++) {
      const at = 6 * (this.#r.points * node[m]! + a);
      const w = weight[m]!;
      const d = slope[m]!;
      x += w * along[at]!;
      y += w * along[at + 1]!;
      z += w * along[at + 2]!;
      rx += w * along[at + 3]!;
      ry += w * along[at + 4]!;
      rz += w * along[at + 5]!;
      sx += d * along[at]!;
      sy += d * along[at + 1]!;
      sz += d * along[at + 2]!;
    }
    const at = 3 * (this.point + a + this.#r.points * b);
    positions[at] = x;
    positions[at + 1] = y;
    positions[at + 2] = z;
    const nx = ry * sz - rz * sy;
    const ny = rz * sx - rx * sz;
    const nz = rx * sy - ry * sx;
    const length = Math.sqrt(nx * nx + ny * ny + nz * nz) || 1;
    normals[at] = nx / length;
    normals[at + 1] = ny / length;
    normals[at + 2] = nz / length;
  }

  /** Spreads values at the nodes over the surface's points, linear in each cell of the grid. */
  spread(values: Float32Array, out: Float32Array): void {
    const { first, nr, ns, closed } = this.piece;
    const { points: rows } = this.#r;
    for (let b = 0; b < this.#s.points; b++) {
      const [j, nextJ, q] = between(b, this.#s.points, ns, closed[1]);
      for (let a = 0; a < rows; a++) {
        const [i, nextI, p] = between(a, rows, nr, closed[0]);
        const low = mix(values[first + i + nr * j]!, values[first + nextI + nr * j]!, p);
        const high = mix(values[first + i + nr * nextJ]!, values[first + nextI + nr * nextJ]!, p);
        out[this.point + a + rows * b] = mix(low, high, q);
      }
    }
  }
}

/** The nodes about a point of a refined row, and the part of the way between them. */
function between(
  point: number,
  points: number,
  nodes: number,
  closed: boolean,
): [number, number, number] {
  if (points === 1) return [0, 0, 0];
  const at = (point / (points - 1)) * (closed ? nodes : nodes - 1);
  const node = Math.min(Math.floor(at), closed ? nodes - 1 : nodes - 2);
  return [node, (node + 1) % nodes, at - node];
}

function mix(from: number, to: number, part: number): number {
  return from + part * (to - from);
}
