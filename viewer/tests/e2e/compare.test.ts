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

  it('captures all views at one scale', async () => {
    const { page } = opened;
    const differing = await page.evaluate(async () => {
      const { cloth, slice } = window.washtub!.settings();
      window.washtub!.set({ cloth: false, slice: 'off' });
      window.washtub!.show(window.washtub!.times[0]!);
      const views = window.washtub!.captions().length;
      const [width, height] = [240, 400]; // narrower than on the screen
      const image = new Image();
      image.src = window.washtub!.capture(width * views, height);
      await image.decode();
      const canvas = new OffscreenCanvas(width * views, height).getContext('2d', {
        willReadFrequently: true,
      })!;
      canvas.drawImage(image, 0, 0);
      // without the water and the cloth, all but the name is the same
      const part = (view: number) => canvas.getImageData(view * width, 60, width, height - 60).data;
      const [first, second] = [part(0), part(1)];
      const differs = (level: number, i: number) => Math.abs(level - second[i]!) > 24;
      window.washtub!.set({ cloth, slice });
      return first.filter(differs).length / first.length;
    });
    if (runs[0]!.dimension === runs[1]!.dimension) expect(differing).toBeLessThan(0.01);
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

  it('turns and zooms all by the same steps with the keys', async () => {
    const { page } = opened;
    const directions = () => page.evaluate(() => window.washtub!.directions());
    await page.keyboard.press('r');
    const [start] = await directions();
    await page.keyboard.press('k');
    const turned = await directions();
    const azimuth = ([x, y]: number[]) => Math.atan2(y!, x!);
    if (runs.every(({ dimension }) => dimension === 3))
      for (const direction of turned)
        expect(Math.abs(azimuth(direction) - azimuth(start!))).toBeCloseTo(Math.PI / 24, 6);
    await page.keyboard.press('r');
  });

  it('has one range of colours', async () => {
    await opened.page.evaluate(() => window.washtub!.set({ colour: 'total' }));
    const captions = await opened.page.evaluate(() => window.washtub!.captions());
    const ends = captions.map(({ legends }) => legends[0]!.high);
    expect(new Set(ends).size).toBe(1);
  });

  it('spans the longest run and says where one has ended', async () => {
    const ends = runs.map(({ frames }) => frames.times.at(-1)!);
    expect(Math.min(...ends)).toBeLessThan(Math.max(...ends));
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
