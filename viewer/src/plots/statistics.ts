import type uPlot from 'uplot';
import type { Display } from './format';
import type { TimePlotSpec } from './spec';
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

/** Draws the means over the window as thin lines, and their intervals as bands about them. */
export function drawBands(plot: uPlot, spec: TimePlotSpec, display: Display): void {
  const y = (value: number) => plot.valToPos(value * display.factor, 'y', true);
  clipped(plot, (context) => {
    for (const band of spec.bands) {
      const left = plot.valToPos(band.from, 'x', true);
      const width = plot.valToPos(band.to, 'x', true) - left;
      context.fillStyle = context.strokeStyle = colourOf(band.colour);
      context.globalAlpha = 0.22;
      if (band.halfWidth !== null) {
        const top = y(band.mean + band.halfWidth);
        context.fillRect(left, top, width, y(band.mean - band.halfWidth) - top);
      }
      context.globalAlpha = 0.8;
      context.setLineDash([6, 4]);
      context.strokeRect(left, y(band.mean), width, 0);
    }
  });
}
