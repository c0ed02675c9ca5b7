import type { Store } from '../model/store';
import { stressShown } from '../scene/settings';
import type { Choices, RangeChoice, Settings, SliceChoice } from '../scene/settings';
import { button, make, select, slider, tick } from '../dom';

/** What the buttons do beyond changing the settings. */
export interface Actions {
  reset(): void;
  side(): void;
  top(): void;
  save(): void;
  keys(): void;
}

const RANGES: [RangeChoice, string][] = [
  ['most', '98 % of the run'],
  ['run', 'whole run'],
  ['frame', 'this frame'],
];
const SLICES: [SliceChoice, string][] = [
  ['off', 'off'],
  ['vertical', 'vertical'],
  ['horizontal', 'horizontal'],
  ['both', 'both'],
];

/** Choices of what the views show. */
export function buildToolbar(
  settings: Store<Settings>,
  choices: Choices,
  actions: Actions,
): HTMLElement {
  return make(
    'div',
    'toolbar',
    ...(choices.cloth ? [clothGroup(settings, choices)] : []),
    ...(choices.quantities.length > 0 ? [waterGroup(settings, choices)] : []),
    viewGroup(choices, actions),
  );
}

function clothGroup(settings: Store<Settings>, choices: Choices): HTMLElement {
  const colour = select(
    'colour by',
    choices.colours.map((value) => [value, choices.words[value] ?? value] as const),
    (value) => settings.set({ colour: value }),
  );
  const range = select('colours span', RANGES, (value) => settings.set({ range: value }));
  const trails = select(
    'trails',
    choices.trails.map((length) => [String(length), trailText(length, choices.period)] as const),
    (value) => settings.set({ trails: Number(value) }),
  );
  const shown = tick('cloth', (on) => settings.set({ cloth: on }));
  settings.subscribe((now) => {
    colour.select.value = now.colour;
    range.select.value = now.range;
    range.element.hidden = stressShown(now.colour) === null;
    trails.select.value = String(now.trails);
    shown.input.checked = now.cloth;
  });
  return make('div', 'group', shown.element, colour.element, range.element, trails.element);
}

/** Length of a trail in cycles where there is a period [s], else in seconds. */
function trailText(length: number, period: number): string {
  if (length === 0) return 'none';
  if (!(period > 0)) return `${Number(length.toPrecision(3))} s`;
  const cycles = Math.round((2 * length) / period) / 2;
  return cycles === 0.5 ? '½ cycle' : `${cycles} ${cycles === 1 ? 'cycle' : 'cycles'}`;
}

function waterGroup(settings: Store<Settings>, choices: Choices): HTMLElement {
  const slice = select(
    choices.plane ? 'water' : 'slice',
    choices.plane ? [SLICES[0]!, ['horizontal', 'shown']] : SLICES,
    (value) => settings.set({ slice: value }),
  );
  const quantity = select(
    'shows',
    choices.quantities.map((value) => [value, choices.words[value] ?? value] as const),
    (value) => settings.set({ quantity: value }),
  );
  const angle = slider('angle', [0, 180, 1], (value) => settings.set({ angle: value }));
  const height = slider('height', [0, 1, 0.005], (value) => settings.set({ height: value }));
  const [angleNow, heightNow] = [make('output', 'value'), make('output', 'value')];
  angleNow.setAttribute('aria-live', 'off');
  heightNow.setAttribute('aria-live', 'off');
  angle.element.append(angleNow);
  height.element.append(heightNow);
  const arrows = tick('arrows', (on) => settings.set({ arrows: on }));
  settings.subscribe((now) => {
    const off = now.slice === 'off';
    slice.select.value = now.slice;
    quantity.select.value = now.quantity;
    angle.input.value = String(now.angle);
    angle.input.setAttribute('aria-valuetext', `${now.angle} degrees from x`);
    height.input.value = String(now.height);
    const heightText = choices.depth
      ? `${(100 * choices.depth * now.height).toFixed(1)} cm`
      : `${Math.round(100 * now.height)} %`;
    height.input.setAttribute('aria-valuetext', `${heightText} above the floor`);
    angleNow.textContent = `${now.angle}°`;
    heightNow.textContent = heightText;
    arrows.input.checked = now.arrows;
    quantity.element.hidden = arrows.element.hidden = off;
    angle.element.hidden = choices.plane || off || now.slice === 'horizontal';
    height.element.hidden = choices.plane || off || now.slice === 'vertical';
  });
  return make(
    'div',
    'group',
    ...[slice, quantity, angle, height, arrows].map(({ element }) => element),
  );
}

function viewGroup(choices: Choices, actions: Actions): HTMLElement {
  const sides = choices.plane
    ? []
    : [
        button('Side', 'View from the side (1)', () => actions.side()),
        button('Top', 'View from the top (2)', () => actions.top()),
      ];
  return make(
    'div',
    'group',
    button('Reset view', 'Reset the view (r)', () => actions.reset()),
    ...sides,
    button('Save picture', 'Save the view as a PNG picture (p)', () => actions.save()),
    button('Keys', 'Show the keys (?)', () => actions.keys()),
  );
}
