import * as THREE from 'three';
import { positionsAt, stressAt } from '../model/between';
import type { LoadedRun } from '../model/run';
import { colourOf, mapOffset } from './colours';
import { linear } from './linear';
import { buildLines, type Lines } from './lines';
import type { ClothPart, Showing } from './part';
import { stressShown } from './settings';
import { Sheet } from './sheet';
import { partsFor } from './spline';

/** Width of a thread [pixels]. */
const WIDTH = 3;
const POINTS = 36_000;

/** Cloth of two-dimensional runs: threads as lines of constant width. */
export function buildThreads(run: LoadedRun): ClothPart | null {
  const { motion } = run;
  const cloth = run.index.cloth;
  if (!motion || !cloth) return null;
  const parts = partsFor(cloth.nodes, POINTS);
  let points = 0;
  const sheets = cloth.pieces.map((piece) => {
    const sheet = new Sheet(piece, parts, points);
    points += sheet.points;
    return sheet;
  });
  const lines = buildLines(points - sheets.length, WIDTH, { above: true, order: 3 });
  const nodes = new Float32Array(3 * motion.nodes);
  const places = new Float32Array(3 * points);
  const normals = new Float32Array(3 * points);
  const colours = threadColours(run, sheets, points);
  return {
    object: lines.object,
    surface: null,
    sheets,
    points: places,
    update(showing) {
      lines.object.visible = showing.settings.cloth;
      if (!lines.object.visible) return;
      positionsAt(motion, showing.moment, nodes);
      for (const sheet of sheets) sheet.shape(nodes, places, normals);
      join(sheets, places, lines.ends);
      join(sheets, colours(showing), lines.colours);
      lines.rim(showing.theme.background);
      lines.send(points - sheets.length);
    },
  };
}

/** Copies three numbers of each point to the segments that end there. */
function join(sheets: readonly Sheet[], from: Float32Array, to: Lines['ends']): void {
  let segment = 0;
  for (const { point, points } of sheets)
    for (let i = point; i + 1 < point + points; i++, segment++)
      for (let axis = 0; axis < 6; axis++) to[6 * segment + axis] = from[3 * i + axis]!;
}

function threadColours(run: LoadedRun, sheets: readonly Sheet[], points: number) {
  const colours = new Float32Array(3 * points);
  const stress = new Float32Array(run.motion!.nodes);
  const values = new Float32Array(points);
  return ({ settings, moment, ranges, theme }: Showing): Float32Array => {
    const kind = stressShown(settings.colour);
    if (!kind) {
      const grouped = settings.colour === 'group';
      sheets.forEach((sheet, piece) => {
        const { r, g, b } = new THREE.Color(colourOf(run.index.cloth!, piece, grouped));
        for (let i = sheet.point; i < sheet.point + sheet.points; i++)
          colours.set([r, g, b], 3 * i);
      });
      return colours;
    }
    stressAt(run.motion!, kind, moment, stress);
    for (const sheet of sheets) sheet.spread(stress, values);
    for (let i = 0; i < points; i++) {
      const offset = mapOffset(values[i]!, 0, ranges.stress);
      for (let c = 0; c < 3; c++) colours[3 * i + c] = linear[theme.stress[offset + c]!]!;
    }
    return colours;
  };
}
