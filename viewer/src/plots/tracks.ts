import uPlot from 'uplot';
import { pieceColour } from '../scene/colours';
import { findColumn } from '../model/csv';
import type { TimeAxis } from './axis';
import { pieceColumn, pieceCount } from './derived';
import { sampleAt } from './legend';
import type { Curve, RunTables } from './spec';

/** The (r, z) track of a piece's centre [m]. */
export interface Track {
  piece: number; // counted from 1
  r: Float64Array;
  z: Float64Array;
}

/** Tracks of all pieces; none in two dimensions, where nothing rises. */
export function tracksOf({ index, tracks }: RunTables): Track[] {
  if (!tracks || index.dimension === 2) return [];
  return Array.from({ length: pieceCount(tracks) }, (_, i) => i + 1).flatMap((piece) => {
    const r = pieceColumn(tracks, piece, 'r');
    const z = pieceColumn(tracks, piece, 'z');
    return r && z ? [{ piece, r, z }] : [];
  });
}

/** Corners of what the tracks fill, r from the axis on [m]. */
export function extentOf(tracks: readonly Track[]): { r: number; z: [number, number] } {
  let [r, low, high] = [0, Infinity, -Infinity];
  for (const track of tracks) {
    for (const x of track.r) if (Number.isFinite(x)) r = Math.max(r, x);
    for (const x of track.z)
      if (Number.isFinite(x)) [low, high] = [Math.min(low, x), Math.max(high, x)];
  }
  return { r, z: [low, high] };
}

/** Begin and end of the rows between two times. */
export function rowsBetween(times: Float64Array, from: number, to: number): [number, number] {
  const first = times.findIndex((time) => time >= from);
  const last = times.findLastIndex((time) => time <= to);
  return first < 0 ? [0, 0] : [first, last + 1];
}

type Point = (r: number, z: number) => [number, number];

function strokeTrack(
  context: CanvasRenderingContext2D,
  track: Track,
  [from, to]: [number, number],
  point: Point,
): void {
  context.strokeStyle = pieceColour(track.piece - 1);
  context.beginPath();
  for (let i = from; i < to; ++i) context.lineTo(...point(track.r[i]!, track.z[i]!));
  context.stroke();
}

/** Draws the whole tracks faintly: the ground on which the marks move. */
export function drawWhole(plot: uPlot, tracks: readonly Track[], times: Float64Array): void {
  const { left, top, width, height } = plot.bbox;
  const point: Point = (r, z) => [plot.valToPos(r, 'x', true), plot.valToPos(z, 'y', true)];
  plot.ctx.save();
  plot.ctx.beginPath();
  plot.ctx.rect(left, top, width, height);
  plot.ctx.clip();
  plot.ctx.lineWidth = uPlot.pxRatio;
  plot.ctx.globalAlpha = tracks.length > 1 ? 0.28 : 0.45;
  for (const track of tracks) strokeTrack(plot.ctx, track, [0, times.length], point);
  plot.ctx.restore();
}

/** Draws each piece's mark at the cursor's time and its track over the time before, `tail` [s]. */
export function drawMarks(
  plot: uPlot,
  canvas: HTMLCanvasElement,
  tracks: readonly Track[],
  times: Float64Array,
  axis: TimeAxis,
  tail: number,
): void {
  const context = fit(canvas);
  const point: Point = (r, z) => [plot.valToPos(r, 'x'), plot.valToPos(z, 'y')];
  const row = sampleAt({ times, until: null } as Curve, Math.min(axis.cursor, times.at(-1) ?? 0));
  if (row === null) return;
  const [from] = rowsBetween(times, times[row]! - tail, times[row]!);
  context.lineWidth = 1.5;
  for (const track of tracks) {
    strokeTrack(context, track, [from, row + 1], point);
    context.fillStyle = context.strokeStyle;
    context.beginPath();
    context.arc(...point(track.r[row]!, track.z[row]!), 4, 0, 2 * Math.PI);
    context.fill();
  }
}

/** Empties a canvas that fills its parent, at the screen's resolution. */
function fit(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const { clientWidth, clientHeight } = canvas.parentElement!;
  const ratio = devicePixelRatio;
  canvas.width = Math.round(clientWidth * ratio);
  canvas.height = Math.round(clientHeight * ratio);
  const context = canvas.getContext('2d')!;
  context.scale(ratio, ratio);
  return context;
}

/** Times of the rows of tracks.csv [s]. */
export function trackTimes({ tracks }: RunTables): Float64Array {
  return findColumn(tracks, 'time')?.values ?? new Float64Array();
}
