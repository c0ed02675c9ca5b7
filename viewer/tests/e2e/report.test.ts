import { readFileSync } from 'node:fs';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Settings } from '../../src/scene/settings';
import { changed, Data, launch, look, open, pageFile, type Opened } from './browser';

const PAGES = [
  ['3-D', pageFile('3D')],
  ['2-D', pageFile('2D')],
] as const;

describe.each(PAGES)('the report of a %s run', (_, file) => {
  const data = new Data(file);
  const run = data.bundle.runs[0]!;
  const { times } = run.frames;
  let browser: Browser;
  let opened: Opened;
  beforeAll(async () => {
    browser = await launch();
    opened = await open(browser, file);
  });
  afterAll(() => browser.close());
  const ask = <T>(question: () => T) => opened.page.evaluate(question);

  it('has the frames of the index', async () => {
    expect(await ask(() => window.washtub!.frames)).toBe(times.length);
    expect(await ask(() => window.washtub!.time())).toBe(times[0]);
    expect(await ask(() => window.washtub!.playing())).toBe(false);
  });

  it('draws more than a background', async () => {
    const { colours, drawn } = await look(opened.page);
    expect(colours).toBeGreaterThan(100);
    expect(drawn).toBeGreaterThan(0.2);
  });

  it('draws the first node of the cloth where the frame has it', async () => {
    const frame = Math.floor(times.length / 2);
    const drawn = await opened.page.evaluate((time) => {
      window.washtub!.show(time);
      return Array.from(window.washtub!.points(0).slice(0, 3));
    }, times[frame]!);
    const bytes = data.chunk(run.frames.positions!);
    const { lower, upper } = run.frames.span;
    const nodes = run.cloth!.nodes;
    for (let axis = 0; axis < run.dimension; axis++) {
      const axes = bytes.length / (2 * nodes * times.length);
      const q = bytes.readUInt16LE(2 * (frame * axes + axis) * nodes);
      const expected = lower[axis]! + (q / 65535) * (upper[axis]! - lower[axis]!);
      expect(drawn[axis]).toBeCloseTo(expected, 6);
    }
  });

  it('moves the cloth while it plays', async () => {
    await opened.page.keyboard.press('Home');
    const first = await ask(() => Array.from(window.washtub!.points(0).slice(0, 30)));
    await opened.page.keyboard.press('Space');
    expect(await ask(() => window.washtub!.playing())).toBe(true);
    await opened.page.waitForFunction((t) => window.washtub!.time() > t, times[2]!);
    await opened.page.keyboard.press('Space');
    expect(await ask(() => window.washtub!.playing())).toBe(false);
    await opened.page.evaluate(() => window.washtub!.show(window.washtub!.time()));
    const then = await ask(() => Array.from(window.washtub!.points(0).slice(0, 30)));
    expect(then).not.toEqual(first);
  });

  it('shows another picture at another time', async () => {
    await ask(() => window.washtub!.show(window.washtub!.times[0]!));
    const part = await changed(opened.page, { time: times.at(-1)! });
    expect(part).toBeGreaterThan(0.005);
  });

  it('goes where the slider is put', async () => {
    const target = Number((times[1]! + 0.6 * (times[2]! - times[1]!)).toFixed(4));
    await opened.page.locator('.scrub').fill(String(target));
    expect(await ask(() => window.washtub!.time())).toBeCloseTo(target, 9);
    const whole = run.dimension === 2; // the water is shown, so frames are not blended
    const shown = () => ask(() => window.washtub!.captions()[0]!.time);
    await expect.poll(shown).toContain((whole ? times[1]! : target).toFixed(3));
    expect(await opened.page.locator('.timeline .time').textContent()).toBe(await shown());
    const notice = await ask(() => window.washtub!.captions()[0]!.notice);
    expect(notice).toBe(whole ? '' : 'between frames');
  });

  it('obeys the keys', async () => {
    const { keyboard } = opened.page;
    const time = () => ask(() => window.washtub!.time());
    await keyboard.press('Home');
    await keyboard.press('ArrowRight');
    expect(await time()).toBe(times[1]);
    await keyboard.press('ArrowLeft');
    expect(await time()).toBe(times[0]);
    await keyboard.press('End');
    expect(await time()).toBe(times.at(-1));
    const set = () => ask(() => window.washtub!.settings());
    const before = await set();
    for (const key of ['c', 's', 't', 'q', 'a']) await keyboard.press(key);
    const after = await set();
    for (const name of ['colour', 'slice', 'trails', 'quantity', 'arrows'] as const)
      expect(after[name], name).not.toEqual(before[name]);
    await keyboard.press('?');
    expect(await opened.page.locator('dialog.keys').isVisible()).toBe(true);
    await keyboard.press('Escape');
    expect(await opened.page.locator('dialog.keys').isVisible()).toBe(false);
    await opened.page.evaluate((settings) => window.washtub!.set(settings), before);
  });

  it('has a legend that ends at the largest stress', async () => {
    await ask(() => window.washtub!.set({ colour: 'total', range: 'run' }));
    const [caption] = await ask(() => window.washtub!.captions());
    const legend = caption!.legends.find(({ title }) => title === 'total stress')!;
    const factor = { Pa: 1, kPa: 1e3, MPa: 1e6 }[legend.unit]!;
    const { values, largest } = run.frames.stress!.total;
    const bytes = data.chunk(values);
    let q = 0;
    for (let at = 0; at < bytes.length; at += 2) q = Math.max(q, bytes.readUInt16LE(at));
    expect((legend.high * factor) / (largest * (q / 65535) ** 2)).toBeCloseTo(1, 9);
  });

  it('colours by stress, and shows and hides the water', async () => {
    await ask(() => window.washtub!.set({ colour: 'piece', slice: 'off' }));
    const part = (settings: Partial<Settings>) => changed(opened.page, { settings });
    expect(await part({ colour: 'bending' })).toBeGreaterThan(0.002);
    expect(await part({ slice: 'horizontal', height: 0.5 })).toBeGreaterThan(0.02);
    expect(await part({ trails: 10 })).toBeGreaterThan(0.001);
  });

  it('saves the view as a PNG picture', async () => {
    const download = opened.page.waitForEvent('download');
    await opened.page.getByRole('button', { name: /Save the view/ }).click();
    const path = await (await download).path();
    expect((await download).suggestedFilename()).toMatch(/^.+-[\d.]+s\.png$/);
    const bytes = readFileSync(path);
    expect(bytes.subarray(1, 4).toString()).toBe('PNG');
    expect(bytes.length).toBeGreaterThan(20_000);
  });

  it('captures pictures of the size asked for', async () => {
    const url = await ask(() => window.washtub!.capture(640, 360));
    const bytes = Buffer.from(url.split(',')[1]!, 'base64');
    expect([bytes.readUInt32BE(16), bytes.readUInt32BE(20)]).toEqual([640, 360]);
  });

  it('draws letters and lines as large in large pictures', async () => {
    const shares = await opened.page.evaluate(async () => {
      const dark = async (width: number, height: number) => {
        const image = new Image();
        image.src = window.washtub!.capture(width, height);
        await image.decode();
        const canvas = new OffscreenCanvas(width, height).getContext('2d')!;
        canvas.drawImage(image, 0, 0);
        const label = canvas.getImageData(0, 0, width / 3, height / 20).data;
        return label.filter((level, i) => i % 4 === 0 && level < 100).length / label.length;
      };
      return [await dark(960, 540), await dark(1920, 1080)];
    });
    expect(shares[0]).toBeGreaterThan(0.001);
    expect(shares[1]! / shares[0]!).toBeGreaterThan(0.7); // 0.25, were they of one size
    expect(shares[1]! / shares[0]!).toBeLessThan(1.5);
  });

  it('tells what piece the pointer rests on', async () => {
    await ask(() => window.washtub!.set({ colour: 'piece', slice: 'off', cloth: true }));
    const view = opened.page.locator('.view').first();
    await view.scrollIntoViewIfNeeded();
    const box = (await view.boundingBox())!;
    const readout = view.locator('.readout');
    const found = async () => {
      for (let at = 0.1; at < 0.95; at += 0.02) {
        await opened.page.mouse.move(box.x + at * box.width, box.y + (0.7 - 0.3 * at) * box.height);
        await opened.page.waitForTimeout(220);
        if (await readout.isVisible()) return readout.textContent();
      }
      return '';
    };
    expect(await found()).toMatch(/^piece \d+( \(cloth [1-4]\))?: total stress [\d.e-]+ [kM]?Pa/);
    await opened.page.mouse.move(0, 0);
    await expect.poll(() => readout.isVisible()).toBe(false);
  });

  it('plots the values of history.csv', async () => {
    const [header, ...rows] = data.chunk(run.history!).toString().trim().split('\n');
    const columns = header!.split(',');
    const plot = await ask(() => window.washtub!.plots.titles()[0]!);
    const [column] = await opened.page.evaluate((p) => window.washtub!.plots.columns(p), plot);
    const at = columns.findIndex((name) => name.replace(/ \[.*\]$/, '') === column);
    expect(at).toBeGreaterThan(0);
    const row = Math.floor(rows.length / 2);
    const value = await opened.page.evaluate(
      ([p, c, i]) => window.washtub!.plots.value(p as string, c as string, i as number),
      [plot, column!, row],
    );
    expect(value).toBe(Number(rows[row]!.split(',')[at]));
  });

  it('tells how long it draws', async () => {
    const { update, whole } = await ask(() => window.washtub!.drawTime());
    expect(update).toBeGreaterThan(0);
    expect(whole).toBeGreaterThanOrEqual(update);
  });

  it('follows the dark theme', async () => {
    const corner = () => ask(() => Array.from(window.washtub!.pixels(0).slice(0, 3)));
    expect(Math.min(...(await corner()))).toBeGreaterThan(200);
    await opened.page.emulateMedia({ colorScheme: 'dark' });
    await expect.poll(async () => Math.max(...(await corner()))).toBeLessThan(60);
  });

  it('fits a narrow window', async () => {
    await opened.page.setViewportSize({ width: 400, height: 800 });
    const width = await ask(() => document.documentElement.scrollWidth);
    expect(width).toBeLessThanOrEqual(400);
  });

  it('neither complained nor asked the network for anything', () => {
    expect(opened.complaints).toEqual([]);
    expect(opened.requests).toEqual([]);
  });
});
