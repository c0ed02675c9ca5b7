import { existsSync, readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { inflateSync } from 'node:zlib';
import { chromium, type Browser, type BrowserContextOptions, type Page } from 'playwright-core';
import type { Bundle, Chunk } from '../../src/model/bundle';
import type { WashtubPage } from '../../src/page/api';
import type { Settings } from '../../src/scene/settings';

declare global {
  interface Window {
    washtub?: WashtubPage;
  }
}

/** The file of a page that tests/programs/report_page.sh has made. */
export function pageFile(which: '3D' | '2D' | 'COMPARE'): string {
  const file = process.env[`WASHTUB_PAGE_${which}`];
  if (!file) throw new Error(`WASHTUB_PAGE_${which} names no page; see tests/programs`);
  return file;
}

const EXECUTABLES = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];

/** Chromium, which draws with the processor. */
export function launch(): Promise<Browser> {
  const named = process.env.WASHTUB_CHROMIUM;
  return chromium.launch({
    executablePath: named ?? EXECUTABLES.find((path) => existsSync(path)) ?? EXECUTABLES[0]!,
    args: [
      '--no-sandbox',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      '--hide-scrollbars',
    ],
  });
}

/** A page with a report, and what it complained of or asked the network for. */
export interface Opened {
  page: Page;
  complaints: string[];
  requests: string[];
}

/** Opens the file of a report and waits until its data are decoded. */
export async function open(
  browser: Browser,
  file: string,
  options: BrowserContextOptions = {},
): Promise<Opened> {
  const page = await browser.newPage({ viewport: { width: 560, height: 600 }, ...options });
  const opened = watch(page);
  await page.goto(pathToFileURL(file).href);
  await page.waitForFunction(() => window.washtub !== undefined, null, { timeout: 30_000 });
  return opened;
}

/** Notes what a page complains of and asks for; reading its pixels back is slow on purpose. */
export function watch(page: Page): Opened {
  const complaints: string[] = [];
  const requests: string[] = [];
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('console', (message) => {
    const bad = message.type() === 'error' || message.type() === 'warning';
    if (bad && !message.text().includes('GPU stall due to ReadPixels'))
      complaints.push(message.text());
  });
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) requests.push(request.url());
  });
  return { page, complaints, requests };
}

/** The data of a report as they stand in its file, read without the page's own code. */
export class Data {
  readonly #html: string;
  readonly bundle: Bundle;

  constructor(readonly file: string) {
    this.#html = readFileSync(file, 'utf8');
    this.bundle = JSON.parse(this.#element('washtub-data')) as Bundle;
  }

  chunk(chunk: Chunk): Buffer {
    return inflateSync(Buffer.from(this.#element(`washtub-chunk-${chunk}`), 'base64'));
  }

  #element(id: string): string {
    const begin = this.#html.indexOf('>', this.#html.indexOf(`id="${id}"`)) + 1;
    return this.#html.slice(begin, this.#html.indexOf('</script>', begin));
  }
}

/** Number of different colours in a view, and the part of it that is not background. */
export function look(page: Page, view = 0): Promise<{ colours: number; drawn: number }> {
  return page.evaluate((number) => {
    const pixels = window.washtub!.pixels(number);
    const seen = new Map<number, number>();
    for (let i = 0; i < pixels.length; i += 4) {
      const colour = (pixels[i]! << 16) + (pixels[i + 1]! << 8) + pixels[i + 2]!;
      seen.set(colour, (seen.get(colour) ?? 0) + 1);
    }
    const background = Math.max(...seen.values());
    return { colours: seen.size, drawn: 1 - background / (pixels.length / 4) };
  }, view);
}

/** What to do before a picture is looked at. */
export interface Change {
  time?: number;
  settings?: Partial<Settings>;
}

/** Part of a view's picture that a change changes. */
export function changed(page: Page, change: Change): Promise<number> {
  return page.evaluate(({ time, settings }) => {
    const before = window.washtub!.pixels(0);
    if (settings) window.washtub!.set(settings);
    if (time !== undefined) window.washtub!.show(time);
    const after = window.washtub!.pixels(0);
    const differs = (level: number, i: number) => Math.abs(level - before[i]!) > 8;
    return after.filter(differs).length / after.length;
  }, change);
}
