import uPlot from 'uplot';
import type { TimeAxis } from './axis';
import { alignedData, csvOf, displayFor, isLogarithmic, largestOf } from './data';
import { button, download, element, fileName } from '../dom';
import { formatBeside, formatTicks, withUnit, type Display } from './format';
import { buildLegend } from './legend';
import { savePicture } from './picture';
import { addCursorLines, followPointer } from './pointing';
import { drawBands, drawIntervals, drawMeans, drawWindows } from './statistics';
import type { Curve, TimePlotSpec } from './spec';
import { colourOf, onThemeChange } from './theme';

const height = 190; // of a plot with its axes [CSS pixel]
const secondAxis = 66; // width with its label [CSS pixel]
const font = '12px system-ui, sans-serif';

/** What the plots of a page share. */
export interface PlotPage {
  axis: TimeAxis;
  runs: string[]; // names
  scaled: boolean; // whether some plot has a second axis, for which the others keep room
}

/** A plot with its title, buttons and legend, as wide as its place. */
export function buildTimePlot(spec: TimePlotSpec, { axis, runs, scaled }: PlotPage): HTMLElement {
  const display = displayFor(spec);
  const label = `${spec.title}: ${spec.name} over time`;
  const place = element('div', { class: 'plot-canvas', role: 'img', 'aria-label': label });
  const plot = new uPlot(
    optionsOf(spec, axis, display, scaled),
    alignedData(spec, display.factor),
    place,
  );
  const listed = spec.curves.filter((curve) => curve.with === null);
  const legend = buildLegend(listed, valueText(spec, display), (i, show) =>
    spec.curves.forEach((curve, k) => {
      if (curve !== listed[i] && curve.with !== listed[i]) return;
      curve.shown = show;
      plot.setSeries(k + 1, { show });
    }),
  );
  const moveLines = addCursorLines(plot, axis);
  const update = () => {
    moveLines();
    legend.update(axis.cursor);
  };
  followPointer(plot, axis);
  axis.onCursor(update);
  plot.hooks.draw!.push(moveLines);
  followRange(plot, axis);
  onThemeChange(() => plot.redraw(false, false));
  keepWidth(plot, place, update);
  update();
  const name = fileName(runs.length > 1 ? 'comparison' : runs[0]!, spec.title);
  const head = element(
    'figcaption',
    {},
    element('h4', {}, spec.title),
    button('CSV', `Save ${spec.title} as a table, in SI units`, () =>
      download(`${name}.csv`, new Blob([csvOf(spec, runs)], { type: 'text/csv' })),
    ),
    button('PNG', `Save ${spec.title} as a picture`, () => savePicture(plot, spec, runs, name)),
  );
  const note = spec.note ? element('p', { class: 'note' }, spec.note) : null;
  return element('figure', { class: 'plot' }, head, place, legend.element, note);
}

/** Values in the plot's unit; those that are nothing beside the others read 0. */
function valueText(spec: TimePlotSpec, { factor, unit }: Display): (value: number) => string {
  const largest = isLogarithmic(spec) ? 0 : largestOf(spec);
  return (value) => {
    const number = formatBeside(value * factor, largest * factor);
    return `${number} ${unit}`.trim();
  };
}

/** Draws anew when the time shown changes; out of sight not before it comes into sight. */
function followRange(plot: uPlot, axis: TimeAxis): void {
  let seen = true;
  let stale = false;
  const draw = () => {
    const [min, max] = axis.range;
    stale = false;
    plot.setScale('x', { min, max });
  };
  axis.onRange(() => {
    stale = true;
    if (seen) draw();
  });
  new IntersectionObserver((entries) => {
    seen = entries.at(-1)!.isIntersecting;
    if (seen && stale) draw();
  }).observe(plot.root);
  addEventListener('beforeprint', () => stale && draw());
}

/** Follows the width of its place, in both directions. */
function keepWidth(plot: uPlot, place: HTMLElement, afterwards: () => void): void {
  new ResizeObserver(() => {
    const width = Math.floor(place.clientWidth);
    if (width < 50 || width === plot.width) return;
    plot.setSize({ width, height });
    afterwards();
  }).observe(place);
}

function optionsOf(
  spec: TimePlotSpec,
  axis: TimeAxis,
  display: Display,
  scaled: boolean,
): uPlot.Options {
  const scales: uPlot.Scales = {
    x: { time: false, range: () => axis.range },
    y: { distr: isLogarithmic(spec) ? 3 : 1 },
  };
  const axes = [timeAxis(), valueAxis(withUnit(spec.name, display.unit), 3, 'y')];
  if (spec.scale) {
    const size = spec.scale.size * display.factor;
    scales.scaled = {
      from: 'y',
      range: (_, min, max) => [(min ?? 0) / size, (max ?? 1) / size],
    };
    axes.push(valueAxis(`in ${spec.scale.symbol}`, 1, 'scaled'));
  }
  return {
    width: 300,
    height,
    legend: { show: false },
    cursor: { show: false },
    padding: [8, spec.scale ? 4 : scaled ? secondAxis + 4 : 18, 0, 0],
    scales,
    axes,
    series: [{}, ...spec.curves.map(seriesOf)],
    hooks: {
      drawAxes: [
        (plot) => drawWindows(plot, spec),
        (plot) => drawBands(plot, spec, display),
        (plot) => drawIntervals(plot, spec, display),
      ],
      draw: [(plot) => drawMeans(plot, spec, display)],
    },
  };
}

function seriesOf(curve: Curve): uPlot.Series {
  return {
    stroke: () => colourOf(curve.colour),
    width: curve.width,
    alpha: curve.faint ? 0.45 : 1,
    dash: curve.dash,
    show: curve.shown,
    points: { show: curve.times.length < 2 },
    ...(curve.until === null ? {} : { paths: uPlot.paths.stepped!({ align: 1 }) }),
  };
}

function baseAxis(): uPlot.Axis {
  const line = { stroke: () => colourOf('--grid'), width: 1 };
  return {
    font,
    labelFont: font,
    stroke: () => colourOf('--ink'),
    grid: line,
    ticks: { ...line, size: 4 },
  };
}

function timeAxis(): uPlot.Axis {
  return {
    ...baseAxis(),
    label: 'time [s]',
    size: 26,
    labelSize: 18,
    gap: 3,
    values: (_, ticks, __, ___, step) => formatTicks(ticks, step),
  };
}

function valueAxis(label: string, side: 1 | 3, scale: string): uPlot.Axis {
  const base = baseAxis();
  return {
    ...base,
    label,
    side,
    scale,
    size: side === 3 ? (_, labels) => widthOf(labels) : secondAxis - 18,
    labelSize: 18,
    gap: 3,
    grid: side === 3 ? base.grid! : { show: false },
    values: (plot, ticks, _, __, step) =>
      plot.scales[scale]!.distr === 3 ? decades(ticks) : formatTicks(ticks, step),
  };
}

/** Room for the labels of an upright axis; mostly the same, so that the plots' times align. */
function widthOf(labels: readonly (string | null)[] | null): number {
  const longest = Math.max(0, ...(labels ?? []).map((label) => label?.length ?? 0));
  return Math.max(50, 7 * longest + 8);
}

/** Labels of a logarithmic axis: only at the powers of ten. */
function decades(ticks: readonly (number | null)[]): (string | null)[] {
  return ticks.map((tick) => {
    const order = tick === null ? NaN : Math.log10(tick);
    return Math.abs(order - Math.round(order)) < 1e-6 ? `1e${Math.round(order)}` : null;
  });
}
