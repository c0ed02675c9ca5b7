import { element } from '../dom';
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

/** Which curves are shown after one is singled out: it alone, or all where it is alone already. */
export function isolated(curves: readonly Pick<Curve, 'shown'>[], i: number): boolean[] {
  const alone = curves.every(({ shown }, k) => shown === (k === i));
  return curves.map((_, k) => alone || k === i);
}

export interface Legend {
  element: HTMLElement;
  update(time: number): void;
}

/**
 * Names of the curves with their values. Each is a switch; a double click, or Shift + Enter, leaves
 * it alone, and shows all where it is alone already.
 */
export function buildLegend(
  curves: Curve[],
  valueText: (value: number) => string,
  setShown: (curve: number, shown: boolean) => void,
): Legend {
  const entries = curves.map((curve) => buildEntry(curve));
  const show = (i: number, shown: boolean) => {
    curves[i]!.shown = shown;
    entries[i]!.toggle.setAttribute('aria-pressed', String(shown));
    setShown(i, shown);
  };
  const isolate = (i: number) =>
    isolated(curves, i).forEach((shown, k) => curves[k]!.shown !== shown && show(k, shown));
  entries.forEach(({ toggle }, i) => {
    toggle.addEventListener('click', () => show(i, !curves[i]!.shown));
    toggle.addEventListener('dblclick', () => isolate(i));
    toggle.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' || !event.shiftKey) return;
      event.preventDefault();
      isolate(i);
    });
  });
  const items = entries.map(({ toggle }) => element('li', {}, toggle));
  const update = (time: number) =>
    entries.forEach(({ value }, i) => {
      const sample = sampleAt(curves[i]!, time);
      const known = sample === null ? NaN : curves[i]!.values[sample]!;
      const text = valueText(known);
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
  const use = 'Show or hide; a double click or Shift + Enter shows this one alone, and again all';
  const title = curve.meaning === '' ? use : `${curve.label}: ${curve.meaning}. ${use}`;
  const toggle = element(
    'button',
    { type: 'button', title, 'aria-pressed': String(curve.shown) },
    line,
    label,
    value,
  );
  return { toggle, value };
}
