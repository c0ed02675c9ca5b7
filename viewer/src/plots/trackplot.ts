import uPlot from 'uplot';
import { csvLine } from '../model/csv';
import type { TimeAxis } from './axis';
import { cell } from './data';
import { button, download, element, fileName } from '../dom';
import { displayOf, formatTicks } from './format';
import { pictureOf } from './picture';
import type { RunTables } from './spec';
import { colourOf, onThemeChange } from './theme';
import { drawMarks, drawWhole, extentOf, trackTimes, tracksOf, type Track } from './tracks';

const font = '12px system-ui, sans-serif';
const frame = { left: 68, right: 12, top: 8, bottom: 44 }; // around the plotting area [CSS pixel]
const largestHeight = 420;

/** Height over distance from the axis of the pieces' centres, to scale; null where there is none. */
export function buildTrackPlot(run: RunTables, axis: TimeAxis, title: string): HTMLElement | null {
  const all = tracksOf(run);
  const times = trackTimes(run);
  if (all.length === 0 || times.length === 0) return null;
  let shown = all;
  const label = 'Height over distance from the axis';
  const place = element('div', { class: 'plot-canvas', role: 'img', 'aria-label': label });
  const overlay = element('canvas', { class: 'overlay' });
  const plot = new uPlot(
    optionsOf(run, all, () => drawWhole(plot, shown, times)),
    [[0], [0]],
    place,
  );
  const period = run.index.scales.period;
  const tail = period > 0 ? period : (times.at(-1)! - times[0]!) / 8;
  const update = () => drawMarks(plot, overlay, shown, times, axis, tail);
  plot.over.append(overlay);
  axis.onCursor(update);
  onThemeChange(() => plot.redraw(false, false));
  keepShape(plot, place, extentOfPlot(run, all), update);
  const choose = chooser(all, (tracks) => {
    shown = tracks;
    plot.redraw(false, false);
    update();
  });
  const name = fileName(run.index.name, 'tracks');
  const head = element(
    'figcaption',
    {},
    element('h4', {}, title),
    choose,
    button('CSV', 'Save the tracks as a table, in SI units', () =>
      download(`${name}.csv`, new Blob([csvOf(shown, times)], { type: 'text/csv' })),
    ),
    button('PNG', 'Save the tracks as a picture', () => savePicture(plot, overlay, run, name)),
  );
  const span = period > 0 ? 'the cycle before it' : 'the time before it';
  const note = `The dots are the pieces’ centres at the time of the clock or pointer, the strong lines ${span}, the faint ones the whole run.`;
  return element('figure', { class: 'plot' }, head, place, element('p', { class: 'note' }, note));
}

interface Extent {
  r: number;
  z: [number, number];
}

/** The half of the box that holds the tracks [m]. */
function extentOfPlot(run: RunTables, tracks: Track[]): Extent {
  const { lower, upper } = run.index.box;
  const { r, z } = extentOf(tracks);
  const half = Math.max(upper[0] - lower[0], upper[1] - lower[1]) / 2;
  return { r: Math.max(r, half), z: [Math.min(z[0], lower[2]), Math.max(z[1], upper[2])] };
}

/** Gives the plot the width of its place and one scale for both directions. */
function keepShape(
  plot: uPlot,
  place: HTMLElement,
  { r, z }: Extent,
  afterwards: () => void,
): void {
  new ResizeObserver(() => {
    const width = Math.floor(place.clientWidth);
    if (width < 100) return;
    const inner = width - frame.left - frame.right;
    const needed = (inner * (z[1] - z[0])) / r + frame.top + frame.bottom;
    const height = Math.round(Math.min(needed, largestHeight));
    const scale = (height - frame.top - frame.bottom) / (z[1] - z[0]);
    const used = Math.round(Math.min(width, scale * r + frame.left + frame.right));
    if (used !== plot.width || height !== plot.height) plot.setSize({ width: used, height });
    afterwards();
  }).observe(place);
}

function optionsOf(run: RunTables, tracks: Track[], draw: () => void): uPlot.Options {
  const { r, z } = extentOfPlot(run, tracks);
  return {
    width: 300,
    height: 200,
    legend: { show: false },
    cursor: { show: false },
    padding: [frame.top, frame.right, 0, 0],
    scales: { x: { time: false, range: () => [0, r] }, y: { range: () => z } },
    axes: [lengthAxis('r: distance from the axis', r, 26), lengthAxis('z: height', r, 50)],
    series: [{}, { show: false }],
    hooks: { draw: [draw] },
  };
}

function lengthAxis(label: string, largest: number, size: number): uPlot.Axis {
  const { factor, unit } = displayOf('m', largest);
  const line = { stroke: () => colourOf('--grid'), width: 1 };
  return {
    font,
    labelFont: font,
    stroke: () => colourOf('--ink'),
    grid: line,
    ticks: { ...line, size: 4 },
    label: `${label} [${unit}]`,
    size,
    labelSize: 18,
    gap: 3,
    values: (_, ticks, __, ___, step) =>
      formatTicks(
        ticks.map((tick) => tick * factor),
        step * factor,
      ),
  };
}

/** A list to choose one piece or all. */
function chooser(all: Track[], choose: (tracks: Track[]) => void): HTMLSelectElement {
  const options = all.map(({ piece }) => element('option', {}, `piece ${piece}`));
  const label = { 'aria-label': 'Pieces whose tracks are shown' };
  const select = element('select', label, element('option', {}, 'all pieces'), ...options);
  select.addEventListener('change', () => {
    const i = select.selectedIndex;
    choose(i === 0 ? all : [all[i - 1]!]);
  });
  return select;
}

function csvOf(tracks: Track[], times: Float64Array): string {
  const names = tracks.flatMap(({ piece }) => [`piece ${piece} r [m]`, `piece ${piece} z [m]`]);
  const rows = Array.from(times, (time, i) =>
    csvLine([time, ...tracks.flatMap(({ r, z }) => [cell(r[i]), cell(z[i])])]),
  );
  return [csvLine(['time [s]', ...names]), ...rows, ''].join('\n');
}

function savePicture(plot: uPlot, overlay: HTMLCanvasElement, run: RunTables, name: string): void {
  const canvas = pictureOf(plot, `Tracks of the pieces – ${run.index.name}`, []);
  const context = canvas.getContext('2d')!;
  const ratio = plot.ctx.canvas.width / plot.width;
  context.setTransform(1, 0, 0, 1, plot.bbox.left, plot.bbox.top + ratio * 26);
  context.drawImage(overlay, 0, 0);
  canvas.toBlob((blob) => blob && download(`${name}.png`, blob));
}
