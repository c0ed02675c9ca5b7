import { describe, expect, it } from 'vitest';
import { centreAt, positionsAt } from '../../src/model/between';
import { decimalsFor, momentAt } from '../../src/model/moment';
import { loadRun } from '../../src/model/run';
import { timeText, noticeFor } from '../../src/scene/caption';
import { RangeFinder } from '../../src/scene/ranges';
import { choicesFor, initialSettings } from '../../src/scene/settings';
import { madeField, madeIndex, madeMotion, madeRun } from './made';

const CENTRE = [0.3, -0.2];
const TURN = 1.9; // per frame [rad]
const PLACES = [
  [0.1, 0],
  [0.2, 0.05],
  [0.15, -0.1],
  [0.3, 0.02],
] as const;

/** Where a node is after `turns` of TURN about the axis. */
function turned(node: number, turns: number): [number, number] {
  const [x, y] = PLACES[node]!;
  const [c, s] = [Math.cos(TURN * turns), Math.sin(TURN * turns)];
  return [CENTRE[0]! + c * x - s * y, CENTRE[1]! + s * x + c * y];
}

/** A run whose piece turns as a whole with an agitator that stands at CENTRE. */
function turningRun() {
  const index = madeIndex();
  const positions = new Uint16Array(3 * 3 * 4);
  const code = (x: number) => Math.round(((x + 1) / 2) * 65535);
  for (let frame = 0; frame < 3; frame++)
    for (let node = 0; node < 4; node++)
      turned(node, frame).forEach((x, axis) => {
        positions[(frame * 3 + axis) * 4 + node] = code(x);
      });
  const agitator = {
    name: 'agitator',
    moving: true,
    centre: [...CENTRE, 0] as [number, number, number],
    vertices: 1,
    triangles: 1,
  };
  const span = { lower: [-1, -1, -1] as const, upper: [1, 1, 1] as const };
  const frames = {
    ...index.frames,
    span: { lower: [...span.lower], upper: [...span.upper] } as typeof index.frames.span,
  };
  const read = async (chunk: number) =>
    chunk === 0 ? new Uint8Array(positions.buffer) : new Uint8Array();
  return loadRun(madeIndex({ frames, solids: [agitator] }), read);
}

describe('between frames', () => {
  it('what turns about the axis as a whole keeps its size and rate', async () => {
    const { motion } = await turningRun();
    const out = new Float32Array(12);
    for (const time of [0, 0.25, 0.5, 0.9, 1, 1.6, 2]) {
      positionsAt(motion!, momentAt([0, 1, 2], time), out);
      for (let node = 0; node < 4; node++)
        turned(node, time).forEach((x, axis) => expect(out[3 * node + axis]).toBeCloseTo(x, 3.8));
    }
  });

  it('centres are those of the nodes', async () => {
    const { motion } = await turningRun();
    const moment = momentAt([0, 1, 2], 1.3);
    const out = new Float32Array(12);
    positionsAt(motion!, moment, out);
    const centre = new Float32Array(3);
    centreAt(motion!, 0, moment, centre);
    for (let axis = 0; axis < 3; axis++) {
      const mean = [0, 1, 2, 3].reduce((sum, node) => sum + out[3 * node + axis]! / 4, 0);
      expect(centre[axis]).toBeCloseTo(mean, 5);
    }
  });
});

describe('what is said of a moment', () => {
  const run = madeRun();
  const settings = { ...initialSettings(choicesFor([run])), slice: 'off' as const };

  it('tells frames from what is between them, and the end', () => {
    expect(noticeFor(run, 1, momentAt(run.times, 1), settings)).toBe('');
    expect(noticeFor(run, 1.5, momentAt(run.times, 1.5), settings)).toBe('between frames');
    expect(noticeFor(run, 3, momentAt(run.times, 3), settings)).toMatch(/^ended at t = 2/);
  });

  it('tells the time of water that is earlier or later', () => {
    const wet = { ...settings, slice: 'horizontal' as const };
    const field = { ...madeField([1, 1, 1], new Int8Array(3), 1), times: [1] };
    const at = (time: number) =>
      noticeFor(madeRun({ field }), time, momentAt([0, 1, 2], time), wet);
    expect([0, 1, 2].map(at)).toEqual(['water of t = 1.0 s', '', 'water of t = 1.0 s']);
  });

  it('has the decimals that tell the frames apart', () => {
    expect(decimalsFor([0, 0.05, 0.1])).toBe(3);
    expect(decimalsFor([0, 0.0002, 0.0004])).toBe(5);
    expect(decimalsFor([0, 10, 20])).toBe(1);
    expect(decimalsFor([])).toBe(3);
    expect(timeText(0.0012345, 0, 5)).toBe('t = 0.00123 s');
  });

  it('ranges over a frame by itself where it is shown by itself', () => {
    const values = Uint16Array.from([1, 1, 1, 1, 9, 9, 9, 9, 2, 2, 2, 2], (q) => 1000 * q);
    const motion = madeMotion({
      stress: { total: { label: 'total stress', values, largest: 100 } },
    });
    const stressed = madeRun({ motion });
    const finder = new RangeFinder([stressed]);
    const chosen = { ...settings, colour: 'total' as const, range: 'frame' as const };
    const at = (time: number) => finder.find(chosen, [momentAt([0, 1, 2], time)]).stress;
    expect(at(0)).toBeCloseTo(100 * (1000 / 65535) ** 2, 9);
    expect(at(0.5)).toBeCloseTo(100 * (9000 / 65535) ** 2, 9);
  });
});
