import type uPlot from 'uplot';
import { download } from '../dom';
import type { Curve, TimePlotSpec } from './spec';
import { colourOf } from './theme';

const margin = 10; // [CSS pixel]
const titleHeight = 26;
const rowHeight = 20;
const swatch = 24;
const font = '13px system-ui, sans-serif';

interface Placed {
  curve: Curve;
  x: number;
  y: number;
}

/** Places the legend's entries in rows no wider than the picture. */
function placeLegend(
  context: CanvasRenderingContext2D,
  curves: Curve[],
  width: number,
): { entries: Placed[]; height: number } {
  let [x, y] = [margin, rowHeight / 2];
  const entries = curves.map((curve) => {
    const needed = swatch + 6 + context.measureText(curve.label).width + 16;
    if (x > margin && x + needed > width) [x, y] = [margin, y + rowHeight];
    const placed = { curve, x, y };
    x += needed;
    return placed;
  });
  return { entries, height: y + rowHeight / 2 };
}

function drawEntry(context: CanvasRenderingContext2D, { curve, x, y }: Placed): void {
  context.strokeStyle = colourOf(curve.colour);
  context.lineWidth = Math.max(curve.width, 2);
  context.setLineDash(curve.dash);
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x + swatch, y);
  context.stroke();
  context.fillText(curve.label, x + swatch + 6, y);
}

/** The plot with title and legend on a canvas of its own, as sharp as on the screen. */
export function pictureOf(plot: uPlot, title: string, curves: Curve[]): HTMLCanvasElement {
  const source = plot.ctx.canvas;
  const ratio = source.width / plot.width;
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d')!;
  context.font = font;
  const legend = placeLegend(context, curves, plot.width);
  canvas.width = source.width;
  canvas.height = Math.ceil(source.height + ratio * (titleHeight + legend.height + margin));
  context.fillStyle = colourOf('--paper');
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(source, 0, ratio * titleHeight);
  context.scale(ratio, ratio);
  context.fillStyle = colourOf('--ink');
  context.textBaseline = 'middle';
  context.font = `bold ${font}`;
  context.fillText(title, margin, titleHeight / 2 + 2);
  context.font = font;
  context.translate(0, titleHeight + plot.height);
  for (const entry of legend.entries) drawEntry(context, entry);
  return canvas;
}

/** Saves the plot as a PNG file. */
export function savePicture(plot: uPlot, spec: TimePlotSpec, runs: string[], name: string): void {
  const title = runs.length > 1 ? spec.title : `${spec.title} – ${runs[0]}`;
  const shown = spec.curves.filter((curve) => curve.shown && curve.with === null);
  pictureOf(plot, title, shown).toBlob((blob) => blob && download(`${name}.png`, blob));
}
