import { element } from './dom';
import { formatNumber, type Display } from './format';
import type { Curve } from './spec';
import { cssColour } from './theme';

/** Number of the sample of a curve that belongs to a time; null before the first and after the last. */
export function sampleAt(curve: Curve, time: number): number | null {
  const { times, until } = curve;
  const last = times.length - 1;
  if (last < 0) return null;
  const slack = last > 0 ? (times[last]! - times[0]!) / last : 0;
  if (time < times[0]! - slack || time > (until ?? times[last]! + slack)) return null;
  let low = 0;
  let high = last;
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if (times[middle]! <= time) low = middle;
    else high = middle - 1;
  }
  if (until !== null || low === last) return low;
  return time - times[low]! <= times[low + 1]! - time ? low : low + 1;
}

export interface Legend {
  element: HTMLElement;
  update(time: number): void;
}

/** Names of the curves with their values; each is a switch, and a double click leaves it alone. */
export function buildLegend(
  curves: Curve[],
  display: Display,
  setShown: (curve: number, shown: boolean) => void,
): Legend {
  const entries = curves.map((curve) => buildEntry(curve));
  const show = (i: number, shown: boolean) => {
    curves[i]!.shown = shown;
    entries[i]!.toggle.setAttribute('aria-pressed', String(shown));
    setShown(i, shown);
  };
  entries.forEach(({ toggle }, i) => {
    toggle.addEventListener('click', () => show(i, !curves[i]!.shown));
    toggle.addEventListener('dblclick', () => curves.forEach((_, k) => show(k, k === i)));
  });
  const items = entries.map(({ toggle }) => element('li', {}, toggle));
  const update = (time: number) =>
    entries.forEach(({ value }, i) => {
      const sample = sampleAt(curves[i]!, time);
      const known = sample === null ? NaN : curves[i]!.values[sample]!;
      const text = `${formatNumber(known * display.factor, 4)} ${display.unit}`.trim();
      if (value.textContent !== text) value.textContent = text;
    });
  return { element: element('ul', { class: 'plot-legend' }, ...items), update };
}

function buildEntry(curve: Curve) {
  const line = element('span', { class: 'swatch' });
  line.style.borderTopColor = cssColour(curve.colour);
  line.style.borderTopStyle = curve.dash.length > 0 ? 'dashed' : 'solid';
  line.style.borderTopWidth = `${Math.max(curve.width, 2)}px`;
  if (curve.faint) line.style.opacity = '0.45';
  const value = element('span', { class: 'plot-value' }, '–');
  const label = element('span', { class: 'plot-label' }, curve.label);
  const title = 'Show or hide; a double click shows this one alone';
  const toggle = element(
    'button',
    { type: 'button', title, 'aria-pressed': String(curve.shown) },
    line,
    label,
    value,
  );
  return { toggle, value };
}
