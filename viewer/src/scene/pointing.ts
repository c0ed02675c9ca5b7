import * as THREE from 'three';
import { stressAt } from '../model/between';
import type { LoadedRun } from '../model/run';
import { groupOf } from './colours';
import { pascals } from './legend';
import type { Sheet } from './sheet';
import type { Showing } from './part';
import { stressShown } from './settings';

/** A point of the drawn cloth. */
export interface Hit {
  piece: number;
  node: number; // the nearest one
}

/** Which of the sheets has a point, and its nearest node. */
export function hitOf(sheets: readonly Sheet[], point: number): Hit | null {
  const piece = sheets.findIndex(
    (sheet) => point >= sheet.point && point < sheet.point + sheet.points,
  );
  return piece < 0 ? null : { piece, node: sheets[piece]!.nodeAt(point - sheets[piece]!.point) };
}

/** The number of the point that a ray meets first on a surface, null where `hiding` is nearer. */
export function pointOnSurface(
  ray: THREE.Raycaster,
  mesh: THREE.Mesh,
  hiding: readonly THREE.Object3D[],
): number | null {
  mesh.geometry.computeBoundingSphere();
  const [hit] = ray.intersectObject(mesh, false);
  if (!hit?.face) return null;
  const [before] = ray.intersectObjects([...hiding], true);
  return before && before.distance < hit.distance ? null : hit.face.a;
}

/** The number of the point that is nearest to a place in the picture, within `reach` [pixels]. */
export function pointNear(
  points: Float32Array,
  camera: THREE.Camera,
  place: THREE.Vector2, // from -1 to 1
  size: { width: number; height: number },
  reach: number,
): number | null {
  const at = new THREE.Vector3();
  let [nearest, least] = [-1, reach];
  for (let point = 0; 3 * point < points.length; point++) {
    at.fromArray(points, 3 * point).project(camera);
    const far = Math.hypot(
      ((at.x - place.x) * size.width) / 2,
      ((at.y - place.y) * size.height) / 2,
    );
    if (far < least) [nearest, least] = [point, far];
  }
  return nearest < 0 ? null : nearest;
}

/** As everywhere counted from 1; with its group where there are several. */
function pieceName({ index: { cloth } }: LoadedRun, piece: number): string {
  const group = cloth && cloth.groups.length > 1 ? cloth.groups[groupOf(cloth, piece)]?.name : '';
  return group ? `piece ${piece + 1} (${group})` : `piece ${piece + 1}`;
}

/** "piece 7 (towels): total stress 120 kPa (8.1 σₒ)": the stress of the node. */
export function hitText(run: LoadedRun, { piece, node }: Hit, showing: Showing): string {
  const name = pieceName(run, piece);
  const kind = stressShown(showing.settings.colour) ?? 'total';
  if (!run.motion?.stress[kind]) return name;
  const all = new Float32Array(run.motion.nodes);
  stressAt(run.motion, kind, showing.moment, all);
  return `${name}: ${kind} stress ${stressText(all[node]!, run.index.scales.stress)}`;
}

function stressText(stress: number, scale: number): string {
  const [unit, factor] = pascals(stress);
  const number = (value: number) => String(Number(value.toPrecision(3)));
  const scaled = scale > 0 ? ` (${number(stress / scale)} σₒ)` : '';
  return `${number(stress * factor)} ${unit}${scaled}`;
}
