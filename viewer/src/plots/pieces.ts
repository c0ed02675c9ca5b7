import { pieceColour } from '../scene/colours';
import { findColumn } from '../model/csv';
import { pieceColumn, pieceCount } from './derived';
import type { Curve, RunTables, Section, TimePlotSpec } from './spec';

const kinds = [
  { what: 'r', title: 'Radius of each piece', name: 'radius', unit: 'm' },
  { what: 'z', title: 'Height of each piece', name: 'height', unit: 'm' },
  { what: 'stress', title: 'Stress of each piece', name: 'stress', unit: 'Pa' },
];

function curvesOf(run: RunTables, number: number, what: string): Curve[] {
  const { tracks } = run;
  const times = findColumn(tracks, 'time')?.values;
  if (!tracks || !times) return [];
  const numbers = Array.from({ length: pieceCount(tracks) }, (_, i) => i + 1);
  return numbers.flatMap((piece) => {
    const values = pieceColumn(tracks, piece, what);
    const column = `piece ${piece} ${what}`;
    const style = {
      colour: pieceColour(piece - 1),
      dash: [],
      width: 1,
      until: null,
      shown: true,
      faint: false,
      with: null,
      band: null,
      meaning: '',
    };
    return values ? [{ ...style, column, label: String(piece), run: number, times, values }] : [];
  });
}

function plotsOf(run: RunTables, number: number, several: boolean): TimePlotSpec[] {
  const flat = run.index.dimension === 2;
  return kinds
    .filter(({ what }) => !(flat && what === 'z'))
    .map(({ what, title, name, unit }) => ({
      title: several ? `${title}, ${run.index.name}` : title,
      name,
      unit,
      scale: null,
      logarithmic: false,
      note: '',
      quantity: '',
      curves: curvesOf(run, number, what),
      bands: [],
      windows: [run.index.window],
    }))
    .filter(({ curves }) => curves.length > 0);
}

/** Radius, height and stress of every piece over time, in the colours of the views. */
export function pieceSection(runs: RunTables[]): Section | null {
  const plots = runs.flatMap((run, i) => plotsOf(run, i, runs.length > 1));
  return plots.length > 0 ? { title: 'Each piece of cloth', open: false, plots } : null;
}
