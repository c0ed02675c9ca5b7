import type { Series } from './derived';
import type { RunTables } from './spec';

/** A curve that the catalogue wants where the run has what it takes. */
export interface Wanted {
  column: string;
  label: string;
  meaning?: string; // shown where the pointer rests on the label
  shown?: boolean; // false: listed in the legend but off at first
  smooth?: boolean; // drawn faintly, with a running mean over a twentieth of a cycle
  quantity?: string; // of the statistics, whose mean over the window belongs to the curve
  take?: (run: RunTables) => (Series & { end?: number; unit: string }) | null;
}

/** A plot of the catalogue. In a comparison each of its curves has a plot of its own. */
export interface Entry {
  section: string;
  title: string;
  name: string; // of the vertical axis
  curves: Wanted[];
  scale?: 'stress' | 'torque';
  logarithmic?: boolean;
  note?: string;
}
