import { describe, expect, it } from 'vitest';
import { channels, colourOf, mapOffset, pieceColour, VIRIDIS } from '../../src/scene/colours';
import { legendsOf, namesOf, ticks, tickText } from '../../src/scene/legend';
import { mostOfStress, RangeFinder } from '../../src/scene/ranges';
import { choicesFor, initialSettings } from '../../src/scene/settings';
import { LIGHT } from '../../src/scene/theme';
import { withoutBoxSides } from '../../src/scene/vessel';
import { madeIndex, madeMotion, madeRun } from './made';

describe('colours', () => {
  it('tell the pieces apart', () => {
    const colours = Array.from({ length: 50 }, (_, piece) => pieceColour(piece));
    expect(new Set(colours).size).toBe(50);
    for (const colour of colours) expect(colour).toMatch(/^#[0-9a-f]{6}$/);
  });

  it('of values end where the map ends', () => {
    expect(mapOffset(-5, 0, 10)).toBe(0);
    expect(mapOffset(5, 0, 10)).toBe(3 * 128);
    expect(mapOffset(99, 0, 10)).toBe(3 * 255);
    expect(mapOffset(1, 0, 0)).toBe(0);
    expect([...VIRIDIS.slice(-3)]).toEqual(channels('#fde725'));
  });
});

describe('ticks', () => {
  it('are round and within the range', () => {
    expect(ticks(0, 10.4, 5)).toEqual([0, 2, 4, 6, 8, 10]);
    expect(ticks(-0.5, 0.5, 4).map(tickText)).toEqual(['−0.4', '−0.2', '0', '0.2', '0.4']);
    expect(ticks(3, 3, 5)).toEqual([3]);
  });
});

describe('ranges', () => {
  // one value of 65535, the others at most half of it
  const values = Uint16Array.from({ length: 1200 }, (_, i) => (i === 5 ? 65535 : i * 27));
  const motion = madeMotion({
    nodes: 400,
    stress: { total: { label: 'total stress', values, largest: 100 } },
  });
  const run = madeRun({ motion });
  const moments = [{ frame: 0, next: 0, part: 0 }];
  const settings = { ...initialSettings(choicesFor([run])), colour: 'total' as const };

  it('leave out the largest two in a hundred', () => {
    const sorted = [...values].sort((a, b) => a - b);
    const expected = 100 * (sorted[Math.ceil(0.98 * 1200) - 1]! / 65535) ** 2;
    expect(mostOfStress(run, 'total')).toBeCloseTo(expected, 6);
  });

  it('span the run or the frame', () => {
    const finder = new RangeFinder([run]);
    expect(finder.find({ ...settings, range: 'run' }, moments).stress).toBe(100);
    const second = [{ frame: 1, next: 1, part: 0 }];
    const expected = 100 * ((799 * 27) / 65535) ** 2;
    expect(finder.find({ ...settings, range: 'frame' }, second).stress).toBeCloseTo(expected, 6);
  });

  it('are those of all runs', () => {
    const double = {
      ...motion,
      stress: { total: { label: 'total stress', values, largest: 200 } },
    };
    const finder = new RangeFinder([run, madeRun({ motion: double })]);
    const both = [moments[0]!, moments[0]!];
    expect(finder.find({ ...settings, range: 'run' }, both).stress).toBe(200);
  });

  it('make a legend in pascals and in the stress scale', () => {
    const [legend] = legendsOf(run, settings, { stress: 40, field: 0 }, LIGHT);
    expect(legend).toMatchObject({ title: 'total stress', unit: 'Pa', low: 0, high: 40 });
    expect(legend!.scaled!.factor * 40).toBeCloseTo(4, 9);
    const [large] = legendsOf(run, settings, { stress: 4e5, field: 0 }, LIGHT);
    expect(large).toMatchObject({ unit: 'kPa', high: 400 });
  });
});

describe('colours of groups', () => {
  const piece = { first: 0, nr: 2, ns: 2, closed: [false, false] as [boolean, boolean] };
  const cloth = {
    nodes: 12,
    pieces: [piece, { ...piece, first: 4 }, { ...piece, first: 8 }],
    groups: [
      { name: 'towels', pieces: 2 },
      { name: 'shirts', pieces: 1 },
    ],
  };
  const run = madeRun({ motion: madeMotion() });
  const settings = initialSettings(choicesFor([run]));
  const grouped = madeRun({ ...run, index: madeIndex({ cloth }) });

  it('can be chosen where there are several', () => {
    expect(choicesFor([grouped]).colours).toContain('group');
    expect(choicesFor([run]).colours).not.toContain('group');
  });

  it('are named, and show no stress', () => {
    const chosen = { ...settings, colour: 'group' };
    const names = namesOf(grouped, chosen);
    expect(names.map(({ name }) => name)).toEqual(['towels', 'shirts']);
    expect(names[1]!.colour).toBe(colourOf(cloth, 2, true));
    expect(colourOf(cloth, 1, true)).toBe(pieceColour(0));
    expect(colourOf(cloth, 1, false)).toBe(pieceColour(1));
    expect(legendsOf(grouped, chosen, { stress: 0, field: 0 }, LIGHT)).toEqual([]);
    expect(namesOf(grouped, settings)).toEqual([]);
  });
});

describe('solids at rest', () => {
  it('lose the triangles in the sides of the box', () => {
    const vertices = Float32Array.from([0, 0, 0, 1, 0, 0, 0, 1, 0, 0.5, 0.5, 0.5]);
    const index = {
      name: 'tub',
      moving: false,
      centre: [0, 0, 0] as [number, number, number],
      vertices: 0,
      triangles: 0,
    };
    const solid = { index, vertices, triangles: Uint32Array.from([0, 1, 2, 0, 1, 3]) };
    expect([...withoutBoxSides(madeIndex(), solid)]).toEqual([0, 1, 3]);
    const inner = { ...solid, vertices: vertices.map((x) => 0.2 + x / 2) };
    expect([...withoutBoxSides(madeIndex(), inner)]).toHaveLength(6);
  });
});
