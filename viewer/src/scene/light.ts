import * as THREE from 'three';
import type { RunIndex } from '../model/bundle';

/** A sky, a lamp above the box that casts shadows, and a weaker one beside the reader. */
export function lightUp(camera: THREE.Camera, scene: THREE.Scene, box: RunIndex['box']): void {
  const lower = new THREE.Vector3(...box.lower);
  const upper = new THREE.Vector3(...box.upper);
  const reach = upper.distanceTo(lower);
  const sky = new THREE.HemisphereLight('#ffffff', '#a09c94', 1.3);
  sky.position.set(0, 0, 1);
  const beside = new THREE.DirectionalLight('#ffffff', 0.8);
  beside.position.set(-0.6 * reach, 0.7 * reach, 0.3 * reach);
  beside.target.position.set(0, 0, -reach);
  camera.add(beside, beside.target);
  const above = lamp(reach);
  above.target.position.copy(lower).lerp(upper, 0.5);
  above.position.add(above.target.position);
  scene.add(sky, above, above.target);
}

function lamp(reach: number): THREE.DirectionalLight {
  const above = new THREE.DirectionalLight('#ffffff', 1.4);
  above.position.set(-0.45 * reach, -0.35 * reach, 1.2 * reach);
  above.castShadow = true;
  above.shadow.mapSize.set(1024, 1024);
  above.shadow.radius = 3;
  above.shadow.normalBias = 0.004 * reach;
  const { camera } = above.shadow;
  camera.left = camera.bottom = -0.55 * reach;
  camera.right = camera.top = 0.55 * reach;
  camera.near = 0.3 * reach;
  camera.far = 2.4 * reach;
  return above;
}
