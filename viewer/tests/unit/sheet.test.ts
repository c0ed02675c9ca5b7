import { describe, expect, it } from 'vitest';
import { Sheet } from '../../src/scene/sheet';
import { partsFor, refine } from '../../src/scene/spline';

/** Values of the refined row for nodes' values. */
function refined(values: number[], parts: number, closed: boolean): number[] {
  const { points, node, weight } = refine(values.length, parts, closed);
  return Array.from({ length: points }, (_, i) =>
    [0, 1, 2, 3].reduce((sum, m) => sum + weight[4 * i + m]! * values[node[4 * i + m]!]!, 0),
  );
}

describe('refine', () => {
  it('passes through the nodes', () => {
    const values = [3, -1, 4, 1, 5];
    const row = refined(values, 4, false);
    expect(row).toHaveLength(17);
    values.forEach((value, i) => expect(row[4 * i]).toBeCloseTo(value, 6));
  });

  it.each([2, 3, 4, 7])('keeps a straight row of %i nodes straight', (nodes) => {
    const row = refined(
      Array.from({ length: nodes }, (_, i) => i),
      4,
      false,
    );
    row.forEach((value, i) => expect(value).toBeCloseTo(i / 4, 6));
  });

  it('keeps a parabola, up to the ends', () => {
    const row = refined([0, 1, 4, 9, 16], 4, false);
    row.forEach((value, i) => expect(value).toBeCloseTo((i / 4) ** 2, 5));
  });

  it('wraps a closed row', () => {
    const row = refined([0, 1, 0, -1], 2, true);
    expect(row).toHaveLength(9);
    expect(row[8]).toBeCloseTo(row[0]!, 6);
    expect(row[7]).toBeCloseTo(-row[1]!, 6);
  });

  it('has slopes that fit its points', () => {
    const { slope, node } = refine(5, 4, false);
    const at = (i: number) =>
      [0, 1, 2, 3].reduce((sum, m) => sum + slope[4 * i + m]! * node[4 * i + m]! ** 2, 0);
    for (let i = 0; i <= 16; i++) expect(at(i)).toBeCloseTo(i / 2, 4);
  });

  it('is coarser for more cloth', () => {
    expect(partsFor(400, 36_000)).toBe(4);
    expect(partsFor(3136, 36_000)).toBe(3);
    expect(partsFor(1e6, 36_000)).toBe(1);
  });
});

describe('Sheet', () => {
  const piece = { first: 0, nr: 3, ns: 3, closed: [false, false] as [boolean, boolean] };
  const nodes = Float32Array.from({ length: 27 }, (_, i) => {
    const node = Math.floor(i / 3);
    return [node % 3, 2 * Math.floor(node / 3), 7][i % 3]!;
  });

  it('is flat with its normal upwards for flat nodes', () => {
    const sheet = new Sheet(piece, 2, 0);
    const [places, normals] = [new Float32Array(75), new Float32Array(75)];
    sheet.shape(nodes, places, normals);
    expect(sheet.points).toBe(25);
    expect([...places.slice(72)]).toEqual([2, 4, 7]);
    for (let i = 0; i < 25; i++)
      expect([...normals.slice(3 * i, 3 * i + 3)].map((n) => Math.round(1e5 * n) / 1e5)).toEqual([
        0, 0, 1,
      ]);
  });

  it('covers its cells with two triangles each', () => {
    const corners = new Sheet(piece, 2, 10).triangles();
    expect(corners).toHaveLength(16 * 6);
    expect(Math.min(...corners)).toBe(10);
    expect(Math.max(...corners)).toBe(34);
  });

  it('spreads values without exceeding them', () => {
    const sheet = new Sheet(piece, 4, 0);
    const out = new Float32Array(sheet.points);
    sheet.spread(Float32Array.from([0, 0, 0, 0, 8, 0, 0, 0, 0]), out);
    expect(Math.max(...out)).toBe(8);
    expect(Math.min(...out)).toBe(0);
    expect(out[2 + 9 * 4]).toBe(4);
  });

  it('knows its hem', () => {
    const sheet = new Sheet({ ...piece, closed: [true, false] }, 2, 0);
    expect(sheet.atHem(0)).toBe(true);
    expect(sheet.atHem(7)).toBe(false);
  });
});
