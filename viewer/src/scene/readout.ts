import type { Clock } from '../model/clock';
import type { View } from './view';

/** The pointer's rest before the readout appears [ms]. */
const REST = 150;

/** Tells what piece the pointer rests on, and its stress there; not while the run plays. */
export function followPointer(view: View, clock: Clock): void {
  const box = document.createElement('div');
  box.className = 'readout';
  box.hidden = true;
  view.element.append(box);
  let waiting = 0;
  const hide = () => {
    clearTimeout(waiting);
    box.hidden = true;
  };
  const tell = (event: PointerEvent) => {
    const frame = view.element.getBoundingClientRect();
    const [x, y] = [event.clientX - frame.left, event.clientY - frame.top];
    const text = view.pointed(x, y);
    if (!text) return;
    box.textContent = text;
    box.hidden = false;
    const right = Math.min(x + 14, frame.width - box.offsetWidth - 4);
    box.style.left = `${Math.max(right, 4)}px`;
    box.style.top = `${y > 40 ? y - 32 : y + 18}px`;
  };
  view.element.addEventListener('pointermove', (event) => {
    hide();
    if (event.buttons === 0 && event.pointerType !== 'touch' && !clock.state.playing)
      waiting = window.setTimeout(tell, REST, event);
  });
  for (const name of ['pointerdown', 'pointerleave', 'wheel'] as const)
    view.element.addEventListener(name, hide, { passive: true });
  clock.subscribe(hide);
}
