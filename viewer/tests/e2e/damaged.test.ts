import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Bundle } from '../../src/model/bundle';
import { launch, pageFile } from './browser';

const file = pageFile('2D');

describe('a page', () => {
  const folder = mkdtempSync(join(tmpdir(), 'washtub-page-'));
  let browser: Browser;
  beforeAll(async () => (browser = await launch()));
  afterAll(async () => {
    await browser.close();
    rmSync(folder, { recursive: true });
  });

  /** Opens the report after a change of its text. */
  async function openChanged(
    change: (html: string) => string,
    prepare: (page: Page) => Promise<void> = async () => {},
    options: BrowserContextOptions = {},
  ): Promise<Page> {
    const path = join(folder, 'report.html');
    writeFileSync(path, change(readFileSync(file, 'utf8')));
    const page = await browser.newPage(options);
    await prepare(page);
    await page.goto(pathToFileURL(path).href);
    return page;
  }

  const alert = (page: Page) => page.getByRole('alert').first().textContent();

  it('without data says so', async () => {
    const page = await openChanged((html) => html.replaceAll('id="washtub-data"', 'id="nothing"'));
    expect(await alert(page)).toMatch(/holds no data/);
  });

  it('with damaged data says so', async () => {
    const page = await openChanged((html) =>
      html.replace(/(id="washtub-chunk-0">).{40}/, '$1' + 'A'.repeat(40)),
    );
    expect(await alert(page)).toMatch(/part 0 cannot be read/);
  });

  it('of another version says so', async () => {
    const page = await openChanged((html) => html.replace(/"version": ?1/, '"version": 9'));
    expect(await alert(page)).toMatch(/version 9/);
  });

  it('of a run without frames has its plots and says why there are no views', async () => {
    const page = await openChanged((html) =>
      html.replace(/(id="washtub-data">)(.*?)(<\/script>)/s, (_, begin, text, end) => {
        const bundle = JSON.parse(text as string) as Bundle;
        const none = { times: [], angles: {}, positions: null, stress: null, fields: null };
        for (const run of bundle.runs) Object.assign(run.frames, none);
        return `${begin}${JSON.stringify(bundle).replaceAll('<', '\\u003c')}${end}`;
      }),
    );
    expect(await alert(page)).toMatch(/No frames were kept/);
    expect(await page.locator('.plots canvas').count()).toBeGreaterThan(0);
    expect(await page.evaluate(() => window.washtub!.frames)).toBe(0);
  });

  it('without WebGL still has its plots and its time', async () => {
    const page = await openChanged(
      (html) => html,
      (fresh) =>
        fresh.addInitScript(() => {
          HTMLCanvasElement.prototype.getContext = new Proxy(
            HTMLCanvasElement.prototype.getContext,
            {
              apply: (target, canvas, [kind, ...rest]) =>
                String(kind).startsWith('webgl')
                  ? null
                  : (Reflect.apply(target, canvas, [kind, ...rest]) as unknown),
            },
          );
        }),
    );
    expect(await alert(page)).toMatch(/WebGL/);
    expect(await page.locator('.plots canvas').count()).toBeGreaterThan(0);
    await page.keyboard.press('End');
    expect(await page.evaluate(() => window.washtub!.time())).toBeGreaterThan(0);
  });
});
