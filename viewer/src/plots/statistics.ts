import type uPlot from 'uplot';
import type { Display } from './format';
import type { MeanBand, TimePlotSpec } from './spec';
import { colourOf } from './theme';

/** Draws within the plot's area only. */
function clipped(plot: uPlot, draw: (context: CanvasRenderingContext2D) => void): void {
  const { left, top, width, height } = plot.bbox;
  plot.ctx.save();
  plot.ctx.beginPath();
  plot.ctx.rect(left, top, width, height);
  plot.ctx.clip();
  draw(plot.ctx);
  plot.ctx.restore();
}

/** Shades the statistics windows. */
export function drawWindows(plot: uPlot, spec: TimePlotSpec): void {
  const { top, height } = plot.bbox;
  clipped(plot, (context) => {
    context.fillStyle = colourOf('--window');
    for (const [from, to] of spec.windows) {
      const left = plot.valToPos(from, 'x', true);
      context.fillRect(left, top, plot.valToPos(to, 'x', true) - left, height);
    }
  });
}

/** The bands whose curves are seen. */
function seen({ bands }: TimePlotSpec): MeanBand[] {
  return bands.filter(({ curve }) => curve.shown);
}

/**
 * Fills the means' 95 % intervals, behind the curves. One that is wider than the plot would tell
 * nothing and hide the curves, so it is left out.
 */
export function drawIntervals(plot: uPlot, spec: TimePlotSpec, { factor }: Display): void {
  const y = (value: number) => plot.valToPos(value * factor, 'y', true);
  clipped(plot, (context) => {
    for (const { curve, mean, halfWidth, from, to } of seen(spec)) {
      if (halfWidth === null) continue;
      const [left, top] = [plot.valToPos(from, 'x', true), y(mean + halfWidth)];
      const height = y(mean - halfWidth) - top;
      if (!(height <= plot.bbox.height)) continue;
      context.fillStyle = colourOf(curve.colour);
      context.globalAlpha = 0.22;
      context.fillRect(left, top, plot.valToPos(to, 'x', true) - left, height);
    }
  });
}

/** Shades the bands about curves, where both ends of a stretch are known. */
export function drawBands(plot: uPlot, spec: TimePlotSpec, { factor }: Display): void {
  const y = (value: number) => plot.valToPos(value * factor, 'y', true);
  clipped(plot, (context) => {
    for (const { times, values, band, colour, shown } of spec.curves) {
      if (!band || !shown) continue;
      const x = Array.from(times, (time) => plot.valToPos(time, 'x', true));
      context.fillStyle = colourOf(colour);
      context.globalAlpha = 0.16;
      for (let i = 1; i < times.length; ++i) {
        const corners = [
          [x[i - 1]!, y(values[i - 1]! - band[i - 1]!)],
          [x[i - 1]!, y(values[i - 1]! + band[i - 1]!)],
          [x[i]!, y(values[i]! + band[i]!)],
          [x[i]!, y(values[i]! - band[i]!)],
        ] as const;
        if (corners.some(([, height]) => !Number.isFinite(height))) continue;
        context.beginPath();
        for (const [across, down] of corners) context.lineTo(across, down);
        context.fill();
      }
    }
  });
}

/** Draws the means over the window as dashed lines over the curves, set off from them. */
export function drawMeans(plot: uPlot, spec: TimePlotSpec, { factor }: Display): void {
  const ratio = plot.ctx.canvas.width / plot.width;
  clipped(plot, (context) => {
    for (const { curve, mean, from, to } of seen(spec)) {
      const y = plot.valToPos(mean * factor, 'y', true);
      const line = (colour: string, width: number, alpha: number, dash: number[]) => {
        context.globalAlpha = alpha;
        context.strokeStyle = colourOf(colour);
        context.lineWidth = width * ratio;
        context.setLineDash(dash.map((length) => length * ratio));
        context.beginPath();
        context.moveTo(plot.valToPos(from, 'x', true), y);
        context.lineTo(plot.valToPos(to, 'x', true), y);
        context.stroke();
      };
      line('--paper', 4, 0.6, []);
      line(curve.colour, 2.25, 1, [7, 6]);
    }
  });
}
