import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { Data, launch, look, open, pageFile, type Opened } from './browser';

const file = pageFile('COMPARE');

describe('a comparison', () => {
  const { runs } = new Data(file).bundle;
  let browser: Browser;
  let opened: Opened;
  beforeAll(async () => {
    browser = await launch();
    opened = await open(browser, file);
  });
  afterAll(() => browser.close());

  it('shows each run, and none is blank', async () => {
    const captions = await opened.page.evaluate(() => window.washtub!.captions());
    expect(captions.map(({ title }) => title)).toEqual(runs.map(({ name }) => name));
    for (const view of runs.keys())
      expect((await look(opened.page, view)).colours).toBeGreaterThan(100);
  });

  it('turns all cameras with one', async () => {
    const directions = () => opened.page.evaluate(() => window.washtub!.directions());
    const before = await directions();
    const canvas = opened.page.locator('.view canvas').first();
    await canvas.scrollIntoViewIfNeeded();
    const box = (await canvas.boundingBox())!;
    await opened.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await opened.page.mouse.down();
    await opened.page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2 + 20);
    await opened.page.mouse.up();
    const after = await directions();
    expect(after[0]).not.toEqual(before[0]);
    for (const [i, run] of runs.entries())
      if (run.dimension === runs[0]!.dimension)
        after[i]!.forEach((x, axis) => expect(x).toBeCloseTo(after[0]![axis]!, 9));
  });

  it('has one range of colours', async () => {
    await opened.page.evaluate(() => window.washtub!.set({ colour: 'total' }));
    const captions = await opened.page.evaluate(() => window.washtub!.captions());
    const ends = captions.map(({ legends }) => legends[0]!.high);
    expect(new Set(ends).size).toBe(1);
  });

  it('spans the longest run and says where one has ended', async () => {
    const ends = runs.map(({ frames }) => frames.times.at(-1)!);
    const captions = await opened.page.evaluate(() => {
      window.washtub!.show(window.washtub!.times.at(-1)!);
      return window.washtub!.captions();
    });
    expect(await opened.page.evaluate(() => window.washtub!.time())).toBe(Math.max(...ends));
    captions.forEach(({ notice }, i) =>
      expect(notice.includes('ended')).toBe(ends[i]! < Math.max(...ends) - 1e-6),
    );
  });

  it('neither complained nor asked the network for anything', () => {
    expect(opened.complaints).toEqual([]);
    expect(opened.requests).toEqual([]);
  });
});
