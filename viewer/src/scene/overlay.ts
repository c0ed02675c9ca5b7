import { drawRows } from './legend_rows';
import { ticks, tickText, type Legend, type Named } from './legend';
import type { Theme } from './theme';

/** What is written into a view and into its pictures. */
export interface Caption {
  title: string; // the run, where there are several; else empty
  time: string;
  notice: string; // such as that the run has ended; mostly empty
  names: Named[];
  legends: Legend[];
}

const FONT = 'system-ui, "Segoe UI", Roboto, "Liberation Sans", sans-serif';
const MARGIN = 10;
const BAR = 12;
/** Distance of the lines of a legend's text. */
const LINE = 14;
/** Views below this width [pixels] get smaller letters and flat legends. */
const NARROW = 520;

/** Writes a caption into a picture of `width` by `height`. */
export function drawCaption(
  context: CanvasRenderingContext2D,
  width: number,
  height: number,
  caption: Caption,
  theme: Theme,
): void {
  const narrow = width < NARROW;
  if (narrow) {
    context.scale(0.8, 0.8);
    [width, height] = [width / 0.8, height / 0.8];
  }
  context.textBaseline = 'middle';
  drawLabels(context, width, caption, theme);
  if (narrow) return drawRows(context, caption.legends, width, height, theme);
  const length = Math.min(0.38 * height, 190);
  let right = width - MARGIN;
  for (const legend of [...caption.legends].reverse())
    right = drawLegend(context, legend, right, height - MARGIN, length, theme) - 6;
}

function drawLabels(
  context: CanvasRenderingContext2D,
  width: number,
  { title, time, notice, names }: Caption,
  theme: Theme,
): void {
  let y = MARGIN;
  for (const [text, font] of [
    [title, `600 13px ${FONT}`],
    [time, `13px ${FONT}`],
    [notice, `italic 12px ${FONT}`],
  ] as const) {
    if (!text) continue;
    context.font = font;
    for (const line of wrapped(context, text, width - 2 * MARGIN - 12)) {
      const wide = Math.min(context.measureText(line).width, width - 2 * MARGIN - 12);
      panel(context, MARGIN, y, wide + 12, 20, theme);
      context.fillText(line, MARGIN + 6, y + 10.5, wide);
      y += 21;
    }
  }
  context.font = `13px ${FONT}`;
  for (const named of names) {
    drawName(context, named, y, width, theme);
    y += 21;
  }
}

function drawName(
  context: CanvasRenderingContext2D,
  { name, colour }: Named,
  y: number,
  width: number,
  theme: Theme,
): void {
  const most = width - 2 * MARGIN - 30;
  panel(context, MARGIN, y, Math.min(context.measureText(name).width, most) + 30, 20, theme);
  context.fillText(name, MARGIN + 24, y + 10.5, most);
  context.fillStyle = colour;
  context.fillRect(MARGIN + 6, y + 4, BAR, BAR);
}

/** The words of a text in lines that are at most `width` wide where a word alone is not wider. */
function wrapped(context: CanvasRenderingContext2D, text: string, width: number): string[] {
  const lines: string[] = [];
  for (const word of text.split(' ')) {
    const longer = lines.length > 0 ? `${lines.at(-1)} ${word}` : word;
    if (context.measureText(longer).width <= width) lines.splice(-1, 1, longer);
    else lines.push(word);
  }
  return lines;
}

export function panel(
  context: CanvasRenderingContext2D,
  x: number,
  y: number,
  width: number,
  height: number,
  theme: Theme,
): void {
  context.fillStyle = theme.panel;
  context.fillRect(x, y, width, height);
  context.fillStyle = theme.text;
  context.textAlign = 'left';
}

/** Draws one legend with its lower right corner at (right, bottom); returns its left edge. */
function drawLegend(
  context: CanvasRenderingContext2D,
  legend: Legend,
  right: number,
  bottom: number,
  length: number,
  theme: Theme,
): number {
  context.font = `12px ${FONT}`;
  const marks = ticks(legend.low, legend.high, 5).map((v) => ({ v, text: tickText(v) }));
  const scaled = scaledMarks(legend);
  const wide = widest(context, marks) + 6;
  const wideScaled = scaled.length > 0 ? Math.max(widest(context, scaled), 14) + 6 : 0;
  const heading = `${legend.title} [${legend.unit}]`;
  const inner = Math.max(wideScaled + BAR + wide + 4, context.measureText(heading).width);
  const left = right - inner - 14;
  const below = legend.open && legend.low < 0 ? LINE : 0; // room for what is below the bar
  const top = bottom - length - 35 - LINE;
  panel(context, left, top, right - left, bottom - top, theme);
  context.fillText(heading, left + 7, top + 12);
  const bar = left + 7 + wideScaled;
  const [high, low] = [top + 26 + LINE, bottom - 9 - below];
  paintBar(context, legend, bar, high, low, theme);
  const place = (v: number) =>
    low + ((v - legend.low) / (legend.high - legend.low || 1)) * (high - low);
  context.fillStyle = theme.text;
  for (const { v, text } of marks) tick(context, text, bar + BAR, place(v), 'left', theme);
  for (const { v, text } of scaled) tick(context, text, bar, place(v), 'right', theme);
  context.textAlign = 'left';
  if (legend.open) {
    context.fillText('and more', bar + BAR + 6, high - LINE);
    if (legend.low < 0) context.fillText('and more', bar + BAR + 6, low + LINE);
  }
  if (legend.scaled) {
    context.textAlign = 'right';
    context.fillText(legend.scaled.by, bar - 6, high - LINE);
  }
  return left;
}

function scaledMarks({ scaled, low, high }: Legend): { v: number; text: string }[] {
  if (!scaled) return [];
  return ticks(low * scaled.factor, high * scaled.factor, 4).map((v) => ({
    v: v / scaled.factor,
    text: tickText(v),
  }));
}

function widest(context: CanvasRenderingContext2D, marks: { text: string }[]): number {
  return Math.max(...marks.map(({ text }) => context.measureText(text).width));
}

function paintBar(
  context: CanvasRenderingContext2D,
  { map, open, low: from }: Legend,
  x: number,
  high: number,
  low: number,
  theme: Theme,
): void {
  const step = (low - high) / 256;
  for (let i = 0; i < 256; i++) {
    context.fillStyle = `rgb(${map[3 * i]}, ${map[3 * i + 1]}, ${map[3 * i + 2]})`;
    context.fillRect(x, low - (i + 1) * step, BAR, step + 0.5);
  }
  if (open) point(context, map, 765, [x, high, -9]);
  if (open && from < 0) point(context, map, 0, [x, low, 9]);
  context.strokeStyle = theme.edge;
  context.lineWidth = 1;
  context.strokeRect(x + 0.5, high + 0.5, BAR - 1, low - high - 1);
}

/** The bar's end in the colour at `offset` of the map, which tells that there is more. */
function point(
  context: CanvasRenderingContext2D,
  map: Legend['map'],
  offset: number,
  [x, y, reach]: [number, number, number],
): void {
  context.fillStyle = `rgb(${map[offset]}, ${map[offset + 1]}, ${map[offset + 2]})`;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x + BAR, y);
  context.lineTo(x + BAR / 2, y + reach);
  context.fill();
}

function tick(
  context: CanvasRenderingContext2D,
  text: string,
  x: number,
  y: number,
  side: 'left' | 'right',
  theme: Theme,
): void {
  const out = side === 'left' ? 1 : -1;
  context.strokeStyle = theme.text;
  context.beginPath();
  context.moveTo(x, Math.round(y) + 0.5);
  context.lineTo(x + 3 * out, Math.round(y) + 0.5);
  context.stroke();
  context.textAlign = side;
  context.fillText(text, x + 6 * out, y);
}
