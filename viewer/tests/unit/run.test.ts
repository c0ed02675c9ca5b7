import { describe, expect, it } from 'vitest';
import { frameAt, momentAt } from '../../src/model/moment';
import { angleAt, positionsAt, stressAt } from '../../src/model/between';
import { loadRun } from '../../src/model/run';
import { madeIndex, madeMotion, madePositions, madeRun } from './made';

const bytesOf = (values: Uint16Array) => new Uint8Array(values.buffer);

describe('moments', () => {
  const times = [0, 1, 3];

  it('lie between two frames', () => {
    expect(momentAt(times, 2.5)).toEqual({ frame: 1, next: 2, part: 0.75 });
  });

  it('are exact at frames', () => {
    expect(momentAt(times, 1)).toMatchObject({ frame: 1, part: 0 });
  });

  it('hold the first and last frame', () => {
    expect(momentAt(times, -1)).toMatchObject({ frame: 0, part: 0 });
    expect(momentAt(times, 9)).toEqual({ frame: 2, next: 2, part: 0 });
    expect(momentAt([], 1)).toEqual({ frame: 0, next: 0, part: 0 });
  });

  it('find the last frame not later', () => {
    expect([-1, 0, 0.99, 1, 2.9, 3, 7].map((t) => frameAt(times, t))).toEqual([
      0, 0, 0, 1, 1, 2, 2,
    ]);
  });
});

describe('loadRun', () => {
  it('decodes positions and finds the centres of the pieces', async () => {
    const run = await loadRun(madeIndex(), async () => bytesOf(madePositions()));
    expect(run.motion?.axes).toBe(3);
    expect(run.motion?.centres[0]).toBeCloseTo(1.5, 6);
    expect(run.motion?.centres[6]).toBeCloseTo(1.7, 6);
  });

  it('refuses positions that are too short', async () => {
    const short = async () => bytesOf(madePositions()).subarray(0, 20);
    await expect(loadRun(madeIndex(), short)).rejects.toThrow(/cloth has not all its frames/);
  });

  it('takes a run without cloth and frames', async () => {
    const frames = { ...madeIndex().frames, times: [], positions: null };
    const run = await loadRun(madeIndex({ cloth: null, frames }), async () => new Uint8Array());
    expect(run.motion).toBeNull();
  });
});

describe('between frames', () => {
  it('positions are linear', () => {
    const out = new Float32Array(12);
    positionsAt(madeMotion(), { frame: 0, next: 1, part: 0.25 }, out);
    expect(out[0]).toBeCloseTo(0.025, 6);
    expect(out[9]).toBeCloseTo(3.025, 6);
  });

  it('stress is linear and of the square of what is kept', () => {
    const values = new Uint16Array(12).fill(0);
    values[1] = 65535;
    values[5] = 32767.5;
    const motion = madeMotion({
      stress: { total: { label: 'total stress', values, largest: 800 } },
    });
    const out = new Float32Array(4);
    stressAt(motion, 'total', { frame: 0, next: 1, part: 0 }, out);
    expect(out[1]).toBeCloseTo(800, 2);
    stressAt(motion, 'total', { frame: 0, next: 1, part: 0.5 }, out);
    expect(out[1]).toBeCloseTo((800 + 200) / 2, 1);
    expect(out[0]).toBe(0);
  });

  it('angles are linear', () => {
    expect(angleAt(madeRun(), 'agitator', { frame: 1, next: 2, part: 0.75 })).toBeCloseTo(-0.5);
    expect(angleAt(madeRun(), 'wall', { frame: 1, next: 2, part: 0.75 })).toBe(0);
  });
});
