import { tickText, type Legend } from './legend';
import { panel } from './overlay';
import type { Theme } from './theme';

const HEIGHT = 20;
const BAR = 10;

/** Legends for narrow views: one row each at the lower edge, with the ends of the colours only. */
export function drawRows(
  context: CanvasRenderingContext2D,
  legends: readonly Legend[],
  width: number,
  height: number,
  theme: Theme,
): void {
  context.font = '12px system-ui, "Segoe UI", Roboto, "Liberation Sans", sans-serif';
  legends.forEach((legend, i) => {
    const top = height - (legends.length - i) * (HEIGHT + 1);
    panel(context, 0, top, width, HEIGHT, theme);
    drawRow(context, legend, width, top + HEIGHT / 2 + 0.5);
  });
}

function drawRow(
  context: CanvasRenderingContext2D,
  legend: Legend,
  width: number,
  middle: number,
): void {
  const name = `${legend.title} [${legend.unit}]`;
  const [low, high] = endTexts(legend);
  context.fillText(name, 6, middle);
  context.textAlign = 'right';
  context.fillText(high, width - 6, middle);
  const from = 6 + context.measureText(name).width + 12 + context.measureText(low).width + 5;
  const to = width - 6 - context.measureText(high).width - 5;
  context.fillText(low, from - 5, middle);
  context.textAlign = 'left';
  const step = (to - from) / 256;
  for (let i = 0; i < 256; i++) {
    context.fillStyle = `rgb(${legend.map.slice(3 * i, 3 * i + 3).join(', ')})`;
    context.fillRect(from + i * step, middle - BAR / 2, step + 0.5, BAR);
  }
}

/** The ends of the colours, and that there is more beyond them. */
function endTexts({ low, high, open, scaled }: Legend): [string, string] {
  const short = (value: number) => tickText(Number(value.toPrecision(3)));
  const beyond = scaled ? ` = ${short(high * scaled.factor)} ${scaled.by}` : '';
  return [
    `${open && low < 0 ? '≤ ' : ''}${short(low)}`,
    `${open ? '≥ ' : ''}${short(high)}${beyond}`,
  ];
}
