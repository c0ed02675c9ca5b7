import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Bundle } from '../../src/model/bundle';
import { launch, look, pageFile } from './browser';

declare global {
  interface Window {
    graphics?: WEBGL_lose_context; // of the page, for a test
  }
}

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

  it('that loses the graphics says so and goes on when they are back', async () => {
    const page = await openChanged(
      (html) => html,
      (fresh) =>
        fresh.addInitScript(() => {
          const get = HTMLCanvasElement.prototype.getContext;
          HTMLCanvasElement.prototype.getContext = new Proxy(get, {
            apply: (target, canvas, given) => {
              const context = Reflect.apply(target, canvas, given) as RenderingContext | null;
              if (context instanceof WebGL2RenderingContext)
                Object.assign(window, { graphics: context.getExtension('WEBGL_lose_context') });
              return context;
            },
          });
        }),
    );
    await page.waitForFunction(() => window.washtub !== undefined);
    const notice = () => page.evaluate(() => window.washtub!.captions()[0]!.notice);
    await page.evaluate(() => window.graphics!.loseContext());
    await expect.poll(notice).toMatch(/taken the graphics away/);
    await page.evaluate(() => window.graphics!.restoreContext());
    await expect.poll(notice).toBe('');
    expect((await look(page)).colours).toBeGreaterThan(100);
  });
});
