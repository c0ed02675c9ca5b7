import { COOLWARM, COOLWARM_DARK, VIRIDIS, WATER, WATER_DARK, type ColourMap } from './colours';

/** Colours of the views and of what is written into them. */
export interface Theme {
  dark: boolean;
  background: string;
  text: string;
  faint: string; // of second-rank text
  panel: string; // behind text
  wall: string;
  edge: string;
  solid: string;
  water: string;
  arrow: string;
  stress: ColourMap;
  speed: ColourMap;
  signed: ColourMap;
}

export const LIGHT: Theme = {
  dark: false,
  background: '#f4f6f8',
  text: '#1c2530',
  faint: '#566372',
  panel: 'rgba(255, 255, 255, 0.78)',
  wall: '#d2dae1',
  edge: '#8b99a7',
  solid: '#aeb6be',
  water: '#7fb4dd',
  arrow: '#22303c',
  stress: VIRIDIS,
  speed: WATER,
  signed: COOLWARM,
};

export const DARK: Theme = {
  dark: true,
  background: '#14181d',
  text: '#e6ebf0',
  faint: '#9aa7b4',
  panel: 'rgba(20, 24, 29, 0.78)',
  wall: '#46525e',
  edge: '#75838f',
  solid: '#7d8791',
  water: '#3f78a8',
  arrow: '#e8eef4',
  stress: VIRIDIS,
  speed: WATER_DARK,
  signed: COOLWARM_DARK,
};

/** Calls `listener` with the theme that the reader's system asks for, now and when it changes. */
export function followTheme(listener: (theme: Theme) => void): void {
  const query = window.matchMedia('(prefers-color-scheme: dark)');
  const tell = () => listener(query.matches ? DARK : LIGHT);
  query.addEventListener('change', tell);
  tell();
}
