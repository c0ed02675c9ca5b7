import type { Clock } from '../model/clock';
import type { Store } from '../model/store';
import type { Choices, Settings, SliceChoice } from '../scene/settings';
import type { Stage } from '../scene/stage';
import { button, make } from '../dom';
import { changeSpeed, togglePlaying } from './timeline';

/** A key, what it does in words, and the doing. */
interface Key {
  keys: string[]; // names as the browser gives them
  shown: string;
  meaning: string;
  press: (event: KeyboardEvent) => void;
}

interface Parts {
  clock: Clock;
  settings: Store<Settings>;
  choices: Choices;
  stage: Stage | null;
  save: () => void;
}

/** Listens to the keys of the page and returns the list of them, opened by `?`. */
export function buildKeys(parts: Parts): HTMLDialogElement {
  const dialog = make('dialog', 'keys');
  dialog.setAttribute('aria-label', 'Keys');
  const keys = [
    ...timeKeys(parts.clock),
    ...(parts.stage ? viewKeys(parts, parts.stage) : []),
    key(['?'], '?', 'show or hide these keys', () => toggle(dialog)),
  ];
  const rows = keys.map(({ shown, meaning }) =>
    make('tr', '', make('td', '', make('kbd', '', shown)), make('td', '', meaning)),
  );
  dialog.append(
    make('h2', '', 'Keys'),
    make('table', '', make('tbody', '', ...rows)),
    make('p', '', POINTER[parts.choices.plane ? 'plane' : 'space']),
    button('Close', 'Close', () => dialog.close()),
  );
  document.addEventListener('keydown', (event) => {
    const found = keys.find(({ keys: names }) => names.includes(event.key));
    if (!found || isTaken(event) || (dialog.open && event.key !== '?')) return;
    event.preventDefault();
    found.press(event);
  });
  return dialog;
}

const POINTER = {
  plane: 'In the view: drag to shift, wheel or pinch to zoom.',
  space:
    'In the view: drag to turn, drag with the right button or two fingers to shift, wheel or pinch to zoom.',
};

function toggle(dialog: HTMLDialogElement): void {
  if (dialog.open) dialog.close();
  else dialog.showModal();
}

/** Regions that the arrow keys scroll once they have the focus. */
const SCROLLED = '.table-scroll, pre';

/** Whether a key belongs to the element that has the focus, or to the browser. */
function isTaken(event: KeyboardEvent): boolean {
  const written = event.getModifierState('AltGraph') || (event.altKey && '[]'.includes(event.key));
  if ((event.ctrlKey || event.altKey || event.metaKey) && !written) return true;
  const at = event.target instanceof HTMLElement ? event.target : null;
  if (!at) return false;
  if (at.isContentEditable || at.matches('textarea, select')) return true;
  if (at instanceof HTMLInputElement && !['range', 'checkbox'].includes(at.type)) return true;
  if (at.matches('input[type=range]:not(.scrub)')) return event.key.length > 1; // moves the slider
  if (at.matches(SCROLLED) && (event.key.length > 1 || event.key === ' ')) return true;
  return event.key === ' ' && at.matches('button, summary, a, input[type=checkbox]');
}

function key(keys: string[], shown: string, meaning: string, press: Key['press']): Key {
  return { keys, shown, meaning, press };
}

function timeKeys(clock: Clock): Key[] {
  const go = (time: number) => clock.set({ time, playing: false });
  return [
    key([' '], 'space', 'play or pause', () => togglePlaying(clock)),
    key(['ArrowLeft'], '←', 'one frame back; with Shift ten', ({ shiftKey }) =>
      clock.step(shiftKey ? -10 : -1),
    ),
    key(['ArrowRight'], '→', 'one frame on; with Shift ten', ({ shiftKey }) =>
      clock.step(shiftKey ? 10 : 1),
    ),
    key(['Home'], 'Home', 'first frame', () => go(clock.begin)),
    key(['End'], 'End', 'last frame', () => go(clock.end)),
    key([','], ',', 'slower', () => changeSpeed(clock, -1)),
    key(['.'], '.', 'faster', () => changeSpeed(clock, 1)),
  ];
}

function viewKeys({ settings, choices, save }: Parts, stage: Stage): Key[] {
  return [
    ...(choices.cloth ? clothKeys(settings, choices) : []),
    ...(choices.quantities.length > 0 ? waterKeys(settings, choices) : []),
    ...(choices.plane ? [] : turningKeys(stage)),
    key(['r'], 'r', 'reset the view', () => stage.look('slanted')),
    key(['+', '='], '+', 'nearer', () => stage.zoom(1.2)),
    key(['-'], '−', 'farther', () => stage.zoom(1 / 1.2)),
    key(['p'], 'p', 'save the view as a picture', save),
  ];
}

function clothKeys(settings: Store<Settings>, choices: Choices): Key[] {
  const now = () => settings.value;
  return [
    key(['c'], 'c', 'next colouring: piece, group, stresses', () =>
      settings.set({ colour: after(choices.colours, now().colour) }),
    ),
    key(['l'], 'l', 'next range of the stress colours', () =>
      settings.set({ range: after(['most', 'run', 'frame'], now().range) }),
    ),
    key(['t'], 't', 'trails of the pieces: none, short, longer', () =>
      settings.set({ trails: after(choices.trails, now().trails) }),
    ),
    key(['h'], 'h', 'hide or show the cloth', () => settings.set({ cloth: !now().cloth })),
  ];
}

function waterKeys(settings: Store<Settings>, { plane, quantities }: Choices): Key[] {
  const now = () => settings.value;
  const ways: SliceChoice[] = plane
    ? ['off', 'horizontal']
    : ['off', 'vertical', 'horizontal', 'both'];
  const move = (by: number) => settings.set(moved(now(), by));
  return [
    key(['s'], 's', plane ? 'water: shown or not' : 'slice: off, vertical, horizontal, both', () =>
      settings.set({ slice: after(ways, now().slice) }),
    ),
    key(['q'], 'q', 'next quantity of the water', () =>
      settings.set({ quantity: after(quantities, now().quantity) }),
    ),
    key(['a'], 'a', 'arrows of the velocity', () => settings.set({ arrows: !now().arrows })),
    ...(plane
      ? []
      : [
          key(['['], '[', 'turn the vertical slice back, or lower the horizontal one', () =>
            move(-1),
          ),
          key([']'], ']', 'turn the vertical slice on, or raise the horizontal one', () => move(1)),
        ]),
  ];
}

/** The horizontal slice moves where it alone is shown, else the vertical one turns. */
function moved({ slice, angle, height }: Readonly<Settings>, by: number): Partial<Settings> {
  if (slice === 'horizontal') return { height: Math.min(Math.max(height + 0.025 * by, 0), 1) };
  return { angle: (angle + 5 * by + 180) % 180 };
}

function turningKeys(stage: Stage): Key[] {
  const step = Math.PI / 24;
  return [
    key(['1'], '1', 'view from the side', () => stage.look('side')),
    key(['2'], '2', 'view from the top', () => stage.look('top')),
    key(['j'], 'j', 'turn the view to the left', () => stage.turn(-step, 0)),
    key(['k'], 'k', 'turn the view to the right', () => stage.turn(step, 0)),
    key(['i'], 'i', 'view from higher up', () => stage.turn(0, -step)),
    key(['m'], 'm', 'view from lower down', () => stage.turn(0, step)),
  ];
}

function after<T>(list: readonly T[], value: T): T {
  return list[(list.indexOf(value) + 1) % list.length]!;
}
