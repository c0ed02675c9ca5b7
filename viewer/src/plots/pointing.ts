import type uPlot from 'uplot';
import type { TimeAxis } from './axis';
import { element } from '../dom';

const smallestDrag = 4; // [CSS pixel]
const smallestStroke = 8; // of a finger that moves the clock [CSS pixel]
const noSelection = { left: 0, top: 0, width: 0, height: 0 };

/**
 * What pointer and wheel do over a time plot: hovering shows values, clicking and dragging set the
 * clock, dragging with Shift and the wheel with Shift or Ctrl zoom, a double click shows all. A
 * finger sets the clock when it is lifted or has moved sideways, so that one can scroll with it.
 */
export function followPointer(plot: uPlot, axis: TimeAxis): void {
  const area = plot.over;
  const timeAt = (event: MouseEvent) => {
    const left = event.clientX - area.getBoundingClientRect().left;
    return plot.posToVal(Math.min(Math.max(left, 0), area.clientWidth), 'x');
  };
  let dragFrom: number | null = null; // where a zoom began [s]
  let touchFrom: number | null = null; // where a finger was put down [CSS pixel]
  const setClock = (event: PointerEvent) => axis.clock.set({ time: timeAt(event), playing: false });
  area.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    area.setPointerCapture(event.pointerId);
    if (event.shiftKey) dragFrom = timeAt(event);
    else if (event.pointerType === 'touch') touchFrom = event.clientX;
    else setClock(event);
  });
  area.addEventListener('pointermove', (event) => {
    axis.hover = event.pointerType === 'touch' ? null : timeAt(event);
    if (dragFrom !== null) markSelection(plot, dragFrom, timeAt(event));
    else if (touchFrom !== null && Math.abs(event.clientX - touchFrom) < smallestStroke) return;
    else if (event.buttons & 1) setClock(event);
  });
  area.addEventListener('pointerup', (event) => {
    if (dragFrom !== null) zoomTo(plot, axis, dragFrom, timeAt(event));
    if (touchFrom !== null) setClock(event);
    dragFrom = touchFrom = null;
  });
  area.addEventListener('pointercancel', () => {
    plot.setSelect(noSelection, false);
    dragFrom = touchFrom = null;
  });
  area.addEventListener('pointerleave', () => (axis.hover = null));
  area.addEventListener('dblclick', () => axis.reset());
  area.addEventListener('wheel', (event) => zoomByWheel(axis, event, timeAt(event)), {
    passive: false,
  });
}

function markSelection(plot: uPlot, from: number, to: number): void {
  const [a, b] = [plot.valToPos(from, 'x'), plot.valToPos(to, 'x')];
  const height = plot.over.clientHeight;
  plot.setSelect({ left: Math.min(a, b), top: 0, width: Math.abs(b - a), height }, false);
}

function zoomTo(plot: uPlot, axis: TimeAxis, from: number, to: number): void {
  plot.setSelect(noSelection, false);
  const pixels = Math.abs(plot.valToPos(to, 'x') - plot.valToPos(from, 'x'));
  if (pixels >= smallestDrag) axis.show(Math.min(from, to), Math.max(from, to));
}

function zoomByWheel(axis: TimeAxis, event: WheelEvent, about: number): void {
  if (!event.ctrlKey && !event.shiftKey) return;
  event.preventDefault();
  const amount = event.deltaY || event.deltaX;
  axis.zoom(Math.exp(0.002 * Math.min(Math.max(amount, -200), 200)), about);
}

/** Upright lines at the clock's time and under the pointer, which move without a new drawing. */
export function addCursorLines(plot: uPlot, axis: TimeAxis): () => void {
  const clockLine = element('div', { class: 'clock-line' });
  const hoverLine = element('div', { class: 'hover-line' });
  plot.over.append(clockLine, hoverLine);
  const place = (line: HTMLElement, time: number | null) => {
    const [from, to] = axis.range;
    line.hidden = time === null || time < from || time > to;
    if (!line.hidden) line.style.transform = `translateX(${plot.valToPos(time!, 'x')}px)`;
  };
  return () => {
    place(clockLine, axis.clock.state.time);
    place(hoverLine, axis.hover);
  };
}
