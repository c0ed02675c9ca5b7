import * as THREE from 'three';
import type { ClothIndex } from '../model/bundle';
import { positionsAt, stressAt } from '../model/between';
import type { LoadedRun, Motion } from '../model/run';
import { clothMaterial } from './cloth_material';
import { colourOf, mapOffset } from './colours';
import { linear } from './linear';
import type { ClothPart, Showing } from './part';
import { stressShown } from './settings';
import { Sheet } from './sheet';
import { partsFor } from './spline';

/** Points of all pieces together that a laptop draws 30 times a second. */
const POINTS = 36_000;

/** Colour of the first and last row of a piece against its inner rows: the hem. */
const HEM = 0.72;

/** The pieces as smooth surfaces in one geometry that is brought up to date in place. */
export function buildCloth(run: LoadedRun): ClothPart | null {
  const { motion } = run;
  const cloth = run.index.cloth;
  if (!motion || !cloth) return null;
  const sheets = sheetsOf(cloth);
  const geometry = geometryOf(sheets);
  const { material, glow } = clothMaterial();
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.castShadow = mesh.receiveShadow = true;
  const nodes = new Float32Array(3 * motion.nodes);
  const paint = painter(
    motion,
    cloth,
    sheets,
    geometry.getAttribute('color') as THREE.BufferAttribute,
  );
  return {
    object: mesh,
    surface: mesh,
    sheets,
    points: geometry.getAttribute('position').array as Float32Array,
    update(showing) {
      mesh.visible = showing.settings.cloth;
      if (!mesh.visible) return;
      glow.value = stressShown(showing.settings.colour) ? 0.6 : 0;
      positionsAt(motion, showing.moment, nodes);
      shape(sheets, nodes, geometry);
      paint(showing);
    },
  };
}

function sheetsOf(cloth: ClothIndex): Sheet[] {
  const parts = partsFor(cloth.nodes, POINTS);
  let point = 0;
  return cloth.pieces.map((piece) => {
    const sheet = new Sheet(piece, parts, point);
    point += sheet.points;
    return sheet;
  });
}

function geometryOf(sheets: readonly Sheet[]): THREE.BufferGeometry {
  const points = sheets.reduce((sum, sheet) => sum + sheet.points, 0);
  const geometry = new THREE.BufferGeometry();
  for (const name of ['position', 'normal', 'color']) {
    const attribute = new THREE.BufferAttribute(new Float32Array(3 * points), 3);
    geometry.setAttribute(name, attribute.setUsage(THREE.DynamicDrawUsage));
  }
  geometry.setIndex(sheets.flatMap((sheet) => sheet.triangles()));
  return geometry;
}

function shape(
  sheets: readonly Sheet[],
  nodes: Float32Array,
  geometry: THREE.BufferGeometry,
): void {
  const position = geometry.getAttribute('position') as THREE.BufferAttribute;
  const normal = geometry.getAttribute('normal') as THREE.BufferAttribute;
  for (const sheet of sheets)
    sheet.shape(nodes, position.array as Float32Array, normal.array as Float32Array);
  position.needsUpdate = normal.needsUpdate = true;
}

/** Paints by piece or group once, by stress each time. */
function painter(
  motion: Motion,
  cloth: ClothIndex,
  sheets: readonly Sheet[],
  attribute: THREE.BufferAttribute,
) {
  const colours = attribute.array as Float32Array;
  const stress = new Float32Array(motion.nodes);
  const values = new Float32Array(colours.length / 3);
  let painted = '';
  return ({ settings, moment, ranges, theme }: Showing): void => {
    const kind = stressShown(settings.colour);
    if (!kind) {
      if (painted === settings.colour) return;
      const grouped = settings.colour === 'group';
      sheets.forEach((sheet, i) => paintPiece(sheet, colourOf(cloth, i, grouped), colours));
    } else {
      stressAt(motion, kind, moment, stress);
      for (const sheet of sheets) sheet.spread(stress, values);
      paintValues(values, ranges.stress, theme.stress, colours);
    }
    painted = settings.colour;
    attribute.needsUpdate = true;
  };
}

function paintPiece(sheet: Sheet, hue: string, colours: Float32Array): void {
  const colour = new THREE.Color(hue);
  for (let point = 0; point < sheet.points; point++) {
    const shade = sheet.atHem(point) ? HEM : 1;
    const at = 3 * (sheet.point + point);
    colours[at] = shade * colour.r;
    colours[at + 1] = shade * colour.g;
    colours[at + 2] = shade * colour.b;
  }
}

function paintValues(
  values: Float32Array,
  largest: number,
  map: Uint8Array,
  colours: Float32Array,
): void {
  for (let point = 0; point < values.length; point++) {
    const offset = mapOffset(values[point]!, 0, largest);
    colours[3 * point] = linear[map[offset]!]!;
    colours[3 * point + 1] = linear[map[offset + 1]!]!;
    colours[3 * point + 2] = linear[map[offset + 2]!]!;
  }
}
