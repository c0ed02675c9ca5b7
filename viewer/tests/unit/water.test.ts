import { describe, expect, it } from 'vitest';
import { opening, smoothMask } from '../../src/scene/mask';
import { fairStride } from '../../src/scene/ranges';
import { choicesFor } from '../../src/scene/settings';
import { trailTimes } from '../../src/scene/trails';
import { madeField, madeIndex, madeRun } from './made';

describe('the mask of the solids', () => {
  it('is smooth, and a half where solid and open cells meet', () => {
    const field = madeField([8, 1, 1], new Int8Array(24), 1);
    field.solid.set([255, 255, 255, 255, 0, 0, 0, 0]);
    const mask = smoothMask(field, 0);
    expect((mask[3]! + mask[4]!) / 2).toBeCloseTo(0.5, 6);
    expect([mask[0], mask[7]]).toEqual([1, 0]);
    expect(opening(0)).toBe(1);
    expect(opening(0.5)).toBe(0);
  });
});

describe('samples of the water', () => {
  it('do not keep to some rows', () => {
    expect(fairStride([32, 32, 32], 8)).toBe(9);
    expect(fairStride([30, 7, 1], 0)).toBe(1);
    expect(fairStride([30, 7, 1], 5)).toBe(11);
  });
});

describe('trails', () => {
  it('go from their begin to now, with points between the frames', () => {
    const times = trailTimes([0, 1, 2, 3], 0.5, 2.25, 1000);
    expect([times[0], times.at(-1)]).toEqual([0.5, 2.25]);
    expect(times).toContain(1);
    expect(times).toContain(1.125);
    expect(times).toEqual([...times].sort((a, b) => a - b));
  });

  it('have no more points than there is room for', () => {
    const frames = Array.from({ length: 1001 }, (_, i) => i);
    expect(trailTimes(frames, 0, 1000, 100).length).toBeLessThanOrEqual(102);
  });

  it('are of cycles where all runs have one period, else of round times', () => {
    const run = (period: number) => {
      const index = madeIndex();
      return madeRun({ index: { ...index, scales: { ...index.scales, period } } });
    };
    expect(choicesFor([run(2), run(2)]).trails).toEqual([0, 1, 2, 4]);
    expect(choicesFor([run(2), run(3)]).trails).toEqual([0, 0.2, 0.5, 1]);
  });
});
