import { describe, expect, it } from 'vitest';
import type { Ensemble, PooledQuantity } from '../../src/model/bundle';
import { poolSections, valueAt } from '../../src/plots/ensemble';
import type { Curve, TimePlotSpec } from '../../src/plots/spec';

function curve(change: Partial<Curve> = {}): Curve {
  return {
    column: 'stress',
    label: 'seed-1',
    meaning: '',
    run: 0,
    times: Float64Array.of(0, 1, 2),
    values: Float64Array.of(0, 10, 20),
    colour: '--curve-1',
    dash: [2, 2],
    width: 1.5,
    faint: false,
    until: null,
    shown: true,
    with: null,
    band: null,
    ...change,
  };
}

function plot(curves: Curve[]): TimePlotSpec {
  const halfWidth = 3;
  return {
    title: 'Stress: total',
    name: 'stress',
    unit: 'Pa',
    scale: null,
    logarithmic: false,
    note: '',
    quantity: 'stress',
    curves,
    bands: curves.map((each) => ({ curve: each, mean: 1, halfWidth, from: 0, to: 2 })),
    windows: [],
  };
}

const ensemble = {
  name: 'all',
  seeds: [1, 2],
  missing: [],
  groups: [],
  student: 12.706,
  rows: [{ name: 'stress', mean: 11, half_width: 2 } as PooledQuantity],
  sentences: [],
} satisfies Ensemble;

const pooled = (curves: Curve[]) =>
  poolSections([{ title: 'Cloth', open: true, plots: [plot(curves)] }], ensemble)[0]!.plots[0]!;

describe('a curve between its samples', () => {
  it('is straight, or a step, and ends', () => {
    expect(valueAt(curve(), 0.25)).toBe(2.5);
    expect(valueAt(curve(), 2)).toBe(20);
    expect(valueAt(curve(), 2.1)).toBeNaN();
    expect(valueAt(curve({ until: 3 }), 1.5)).toBe(10);
    expect(valueAt(curve({ until: 3 }), 2.9)).toBe(20);
  });
});

describe('plots of an ensemble', () => {
  const other = curve({ times: Float64Array.of(0, 2), values: Float64Array.of(2, 26), run: 1 });

  it('show the mean of the members with its band', () => {
    const { curves } = pooled([curve(), other]);
    const mean = curves.at(-1)!;
    expect(mean.label).toBe('mean of 2 members');
    expect([...mean.values]).toEqual([1, 12, 23]);
    expect(mean.band![1]).toBeCloseTo((12.706 * 4) / 2, 9);
  });

  it('have one entry in the legend, that switches the members behind it', () => {
    const { curves } = pooled([curve(), other]);
    const mean = curves.at(-1)!;
    expect(curves.map((each) => each.with)).toEqual([mean, mean, null]);
    expect(curves.map(({ faint }) => faint)).toEqual([true, true, false]);
  });

  it('bear the pooled interval in place of the members’ own', () => {
    const { bands, curves } = pooled([curve(), other]);
    expect(bands).toHaveLength(1);
    expect(bands[0]).toMatchObject({ curve: curves.at(-1), mean: 11, halfWidth: 2, to: 2 });
  });

  it('take running means where there are some', () => {
    const smooth = { column: 'stress (running mean)' };
    const { curves } = pooled([curve(), curve(smooth), other, { ...other, ...smooth }]);
    expect(curves).toHaveLength(3);
  });

  it('are left as they are with one member', () => {
    expect(pooled([curve()]).curves).toHaveLength(1);
  });
});
