/**
 * Renders a report's page frame by frame in Chromium and hands the pictures to ffmpeg, which makes
 * an H.264 movie of them. Started by `washtub movie`, which explains the options:
 *
 *   node movie.mjs '{"page": "report.html", "output": "wash.mp4", ...}'
 *
 * Ends with 1 or 2 and a sentence where it cannot be done, and with 130 where it was interrupted.
 */
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

/** Something that the user is told in one sentence; `code` is the exit code: 2 = wrong input. */
class Failure extends Error {
  constructor(message, code = 1) {
    super(message);
    this.code = code;
  }
}

const options = JSON.parse(process.argv[2] ?? '{}');

/** Chromium with WebGL, drawn by the processor where there is no graphics card. */
async function openBrowser() {
  const flags = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--hide-scrollbars'];
  if (process.getuid?.() === 0) flags.push('--no-sandbox');
  try {
    return await chromium.launch({
      executablePath: options.browser,
      args: flags,
      handleSIGINT: false,
      handleSIGTERM: false,
    });
  } catch (error) {
    throw new Failure(
      `${options.browser} does not start: ${error.message.split('\n')[0].replace(/^[\w.]+: /, '')}`,
    );
  }
}

/**
 * The report, with its data decoded and its view as asked for. Its window is small, since only the
 * pictures taken of it matter.
 */
async function openPage(browser) {
  const { colour, slice } = options;
  const page = await browser.newPage({
    viewport: { width: 480, height: 360 },
    reducedMotion: 'reduce',
  });
  await page.goto(pathToFileURL(options.page).href);
  await page
    .waitForFunction(() => window.washtub || document.querySelector('[role=alert]'), null, {
      timeout: 120_000,
    })
    .catch(() => {
      throw new Failure('the page of the report does not come up');
    });
  const trouble = await page.evaluate(() =>
    window.washtub?.frames > 0
      ? null
      : (document.querySelector('[role=alert]')?.textContent ?? 'there are no frames'),
  );
  if (trouble) throw new Failure(`the page of the report says: ${trouble}`);
  const wished = { ...(colour && { colour }), ...(slice && { slice }) };
  await page.evaluate((change) => window.washtub.set(change), wished);
  return page;
}

/** Times of the movie's pictures [s]: `speed` seconds of the run in each of its own. */
async function movieTimes(page) {
  const times = await page.evaluate(() => [...window.washtub.times]);
  const from = Math.max(options.from ?? times[0], times[0]);
  const to = Math.min(options.to ?? times.at(-1), times.at(-1));
  if (from > to)
    throw new Failure(
      `there is nothing from ${from} to ${to} s; the run has frames from ${times[0]} to ${times.at(-1)} s`,
      2,
    );
  const step = options.speed / options.fps;
  const count = Math.floor((to - from) / step + 1e-9) + 1;
  return Array.from({ length: count }, (_, i) => from + i * step);
}

function startEncoder() {
  const input = `-f image2pipe -framerate ${options.fps} -c:v mjpeg -i -`;
  const colours = '-colorspace bt709 -color_primaries bt709 -color_trc bt709 -color_range tv';
  const scale = 'scale=in_range=pc:out_range=tv:in_color_matrix=bt601:out_color_matrix=bt709';
  const output = `-c:v libx264 -crf 18 -preset medium ${colours} -movflags +faststart -f mp4`;
  const words = ['-loglevel', 'error', '-y', ...input.split(' '), '-vf', `${scale},format=yuv420p`];
  const child = spawn(options.encoder, [...words, ...output.split(' '), options.output], {
    stdio: ['pipe', 'ignore', 'pipe'],
  });
  process.once('exit', () => child.kill('SIGKILL'));
  let said = '';
  child.stderr.on('data', (text) => (said += text));
  child.stdin.on('error', () => {}); // told by the exit code
  const ended = once(child, 'close').then(([code]) => {
    if (code !== 0) throw new Failure(`ffmpeg failed: ${said.trim().split('\n').at(-1)}`);
  });
  ended.catch(() => {});
  return { stdin: child.stdin, ended };
}

/** A line on the progress: rewritten on a terminal, else at most every ten seconds. */
function progressLine(total) {
  const start = Date.now();
  let next = 0;
  return (done) => {
    const spent = (Date.now() - start) / 1000;
    if (spent < next && done < total) return;
    next = spent + (process.stderr.isTTY ? 0.5 : 10);
    const left = Math.round((spent / done) * (total - done));
    const line = `frame ${done} of ${total} (${Math.round((100 * done) / total)} %)  ${left} s to go`;
    const last = done === total ? '\n' : '';
    process.stderr.write(process.stderr.isTTY ? `\r${line}\x1b[K${last}` : `${line}\n`);
  };
}

/** The view at one time as JPEG. */
async function picture(page, time) {
  const { width, height } = options;
  const url = await page.evaluate(
    ([t, w, h]) => {
      window.washtub.show(t);
      return window.washtub.capture(w, h, 'image/jpeg');
    },
    [time, width, height],
  );
  return Buffer.from(url.slice(url.indexOf(',') + 1), 'base64');
}

async function makeMovie(browser) {
  const page = await openPage(browser);
  const times = await movieTimes(page);
  const progress = progressLine(times.length);
  const encoder = startEncoder();
  for (const [i, time] of times.entries()) {
    const image = await picture(page, time);
    if (!encoder.stdin.write(image))
      await Promise.race([once(encoder.stdin, 'drain'), encoder.ended]);
    progress(i + 1);
  }
  encoder.stdin.end();
  await encoder.ended;
}

for (const signal of ['SIGINT', 'SIGTERM']) process.once(signal, () => process.exit(130));
try {
  const browser = await openBrowser();
  try {
    await makeMovie(browser);
  } finally {
    await browser.close();
  }
} catch (error) {
  const said = error instanceof Failure ? error.message : error.message.split('\n')[0];
  process.stderr.write(`washtub: ${said}\n`);
  process.exitCode = error instanceof Failure ? error.code : 1;
}
