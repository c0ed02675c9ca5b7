import { describe, expect, it } from 'vitest';
import { parseTable } from '../../src/model/csv';
import {
  cycleBounds,
  energyPerCycle,
  integrate,
  runningMean,
  scatterOverTime,
} from '../../src/plots/derived';

const series = (times: number[], values: number[]) => ({
  times: Float64Array.from(times),
  values: Float64Array.from(values),
});

describe('cycleBounds', () => {
  it('lets a cycle begin with the window and starts with the first sample', () => {
    expect(cycleBounds(Float64Array.of(0, 7), 2, 2)).toEqual([0, 2, 4, 6]);
    expect(cycleBounds(Float64Array.of(0, 7), 3, 2)).toEqual([1, 3, 5, 7]);
    expect(cycleBounds(Float64Array.of(1.5, 7), 2, 2)).toEqual([2, 4, 6]);
  });

  it('takes a last cycle whose end is rounded', () => {
    const bounds = cycleBounds(Float64Array.of(0, 6.28318531), 1.5707963267948966, Math.PI / 2);
    expect(bounds).toHaveLength(5);
  });

  it('has none without a period or samples', () => {
    expect(cycleBounds(Float64Array.of(0, 7), 0, 0)).toEqual([]);
    expect(cycleBounds(new Float64Array(), 0, 1)).toEqual([]);
  });
});

describe('integrate', () => {
  it('shares a sample that lies across a bound in proportion', () => {
    // 10 W from 0 s to 1.5 s, then 20 W to 3 s; the value at 0 s stands for no time.
    const sums = integrate(series([0, 1.5, 3], [99, 10, 20]), [0, 1, 2, 3]);
    expect([...sums]).toEqual([10, 15, 20]);
  });
});

describe('energyPerCycle', () => {
  it('is the mean power times the period in every whole cycle', () => {
    const times = Array.from({ length: 101 }, (_, i) => i * 0.05);
    const power = series(
      times,
      times.map((t) => (t <= 2 ? 3 : 5)),
    );
    const energy = energyPerCycle(power, 2, 2)!;
    expect([...energy.times]).toEqual([0, 2]);
    expect(energy.values[0]).toBeCloseTo(6, 9);
    expect(energy.values[1]).toBeCloseTo(10, 9);
    expect(energy.end).toBe(4);
  });

  it('is nothing before a whole cycle has passed', () => {
    expect(energyPerCycle(series([0, 1], [1, 1]), 0, 2)).toBeNull();
  });
});

describe('scatterOverTime', () => {
  const header = 'time [s],piece 1 r [m],piece 1 z [m],piece 2 r [m],piece 2 z [m]';

  it('is half the distance of two pieces', () => {
    const scatter = scatterOverTime(parseTable(`${header}\n0,0,0,0,0\n1,0,0,3,4\n`))!;
    expect([...scatter.values]).toEqual([0, 2.5]);
    expect([...scatter.times]).toEqual([0, 1]);
  });

  it('leaves out a piece without a number', () => {
    const three = `${header},piece 3 r [m],piece 3 z [m]`;
    const scatter = scatterOverTime(parseTable(`${three}\n0,0,0,3,4,,\n1,,,3,4,,\n`))!;
    expect([...scatter.values]).toEqual([2.5, NaN]);
  });

  it('needs more than one piece', () => {
    expect(scatterOverTime(parseTable('time [s],piece 1 r [m],piece 1 z [m]\n0,1,1\n'))).toBeNull();
  });
});

describe('runningMean', () => {
  it('leaves a straight line as it is, but for its ends', () => {
    const times = Array.from({ length: 41 }, (_, i) => i);
    const mean = runningMean(series(times, times), 8)!;
    expect(mean.values[20]).toBeCloseTo(20, 12);
    expect(mean.values[0]).toBeCloseTo(2, 12);
    expect(mean.values[40]).toBeCloseTo(38, 12);
  });

  it('leaves out what is no number', () => {
    const times = Array.from({ length: 41 }, (_, i) => i);
    const values = times.map((t) => (t === 19 || t === 21 ? NaN : t));
    const mean = runningMean(series(times, values), 8)!;
    expect(mean.values[20]).toBeCloseTo(20, 12);
    expect(mean.values[40]).toBeCloseTo(38, 12);
  });

  it('is nothing where it would smooth nothing', () => {
    expect(runningMean(series([0, 1, 2], [1, 2, 3]), 1)).toBeNull();
    expect(runningMean(series([0, 1, 2], [1, 2, 3]), 0)).toBeNull();
  });
});
