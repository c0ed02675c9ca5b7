import type { RunIndex } from '../model/bundle';
import type { Table } from '../model/csv';

/** A run with its tables read. */
export interface RunTables {
  index: RunIndex;
  history: Table | null;
  tracks: Table | null;
}

/** One line of a plot: SI values over the times of its run [s]. */
export interface Curve {
  column: string; // its name in history.csv, or one like it for what is computed here
  label: string; // in the legend
  meaning: string; // of the column, or ""
  run: number; // number of the run
  times: Float64Array;
  values: Float64Array;
  colour: string; // CSS colour, or the name of a custom property such as "--curve-0"
  dash: number[]; // [] for an unbroken line
  width: number; // [CSS pixel]
  faint: boolean; // stands back behind its running mean
  until: number | null; // steps, each value up to the next one and the last until then [s]
  shown: boolean;
  with: Curve | null; // the one whose entry in the legend switches this one, too
  band: Float64Array | null; // half width about each value, shaded
}

/** Mean of a curve's quantity over the window with its 95 % interval, SI. */
export interface MeanBand {
  curve: Curve; // seen together with it
  mean: number;
  halfWidth: number | null;
  from: number; // [s]
  to: number; // [s]
}

export interface TimePlotSpec {
  title: string; // unique on the page
  name: string; // of the vertical axis, without its unit
  unit: string; // SI
  scale: { size: number; symbol: string } | null; // what a second axis divides by, as 1 sigma_o
  logarithmic: boolean;
  note: string; // a sentence under the plot, or ""
  quantity: string; // of the statistics that belongs to its first curve, or ""
  curves: Curve[];
  bands: MeanBand[];
  windows: [number, number][]; // of the statistics [s], without repetition
}

export interface Section {
  title: string;
  open: boolean;
  plots: TimePlotSpec[];
}
