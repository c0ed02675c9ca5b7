import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { RunIndex } from '../model/bundle';

export type Side = 'slanted' | 'side' | 'top';

/** A camera that the pointer turns, shifts and brings nearer; plane runs are seen from the top. */
export interface Eye {
  camera: THREE.PerspectiveCamera | THREE.OrthographicCamera;
  moved(listener: () => void): void;
  look(from: Side): void;
  fit(width: number, height: number): void;
  copy(other: Eye): void;
  turn(azimuth: number, polar: number): void; // [rad]
  zoom(factor: number): void;
  target: THREE.Vector3;
  side: Side | null; // from where it looks at the whole, null once the reader has moved it
}

const FROM: Record<Side, THREE.Vector3> = {
  slanted: new THREE.Vector3(0.36, -1, 0.8).normalize(),
  side: new THREE.Vector3(0, -1, 0.02).normalize(),
  top: new THREE.Vector3(0, -0.0005, 1).normalize(),
};

/** `box` holds all that is to be seen. */
export function buildEye(box: RunIndex['box'], dimension: 2 | 3, element: HTMLElement): Eye {
  const bounds = new THREE.Box3(new THREE.Vector3(...box.lower), new THREE.Vector3(...box.upper));
  const centre = bounds.getCenter(new THREE.Vector3());
  const size = bounds.getSize(new THREE.Vector3());
  const reach = size.length() / 2;
  const camera =
    dimension === 2
      ? new THREE.OrthographicCamera(-1, 1, 1, -1, 0.01 * reach, 20 * reach)
      : new THREE.PerspectiveCamera(26, 1, 0.02 * reach, 60 * reach);
  camera.up.set(0, dimension === 2 ? 1 : 0, dimension === 2 ? 0 : 1);
  const controls = controlsOf(camera, element, reach);
  let aspect = 1;
  const look = (side: Side) => {
    eye.side = dimension === 2 ? 'top' : side;
    controls.target.copy(centre);
    camera.zoom = 1;
    const way = dimension === 2 ? new THREE.Vector3(0, 0, 1) : FROM[eye.side];
    place(camera, controls.target, size, way, aspect);
    camera.updateProjectionMatrix();
    controls.update();
  };
  const fit = (width: number, height: number) => {
    aspect = width / Math.max(height, 1);
    frame(camera, size, aspect);
    if (eye.side) look(eye.side);
  };
  const eye: Eye = {
    camera,
    side: dimension === 2 ? 'top' : 'slanted',
    target: controls.target,
    moved: (listener) => controls.addEventListener('change', listener),
    look,
    fit,
    copy: (other) => {
      eye.side = other.side;
      camera.position.copy(other.camera.position);
      camera.zoom = other.camera.zoom;
      controls.target.copy(other.target);
      camera.updateProjectionMatrix();
      controls.update();
    },
    turn: (azimuth, polar) => {
      eye.side = null;
      const arm = new THREE.Spherical().setFromVector3(armOf(camera, controls.target));
      arm.theta += azimuth;
      arm.phi = Math.min(Math.max(arm.phi + polar, 0.01), 0.98 * Math.PI);
      const way = new THREE.Vector3().setFromSpherical(arm);
      camera.position.copy(controls.target).add(new THREE.Vector3(way.x, -way.z, way.y));
      controls.update();
    },
    zoom: (factor) => {
      eye.side = null;
      if (camera instanceof THREE.OrthographicCamera) camera.zoom *= factor;
      else camera.position.lerp(controls.target, 1 - 1 / factor);
      camera.updateProjectionMatrix();
      controls.update();
    },
  };
  controls.addEventListener('start', () => (eye.side = null));
  return eye;
}

/** From the target to the camera, turned so that y is up, as THREE.Spherical wants it. */
function armOf(camera: THREE.Camera, target: THREE.Vector3): THREE.Vector3 {
  const arm = camera.position.clone().sub(target);
  return new THREE.Vector3(arm.x, arm.z, -arm.y);
}

function controlsOf(camera: THREE.Camera, element: HTMLElement, reach: number): OrbitControls {
  const controls = new OrbitControls(camera, element);
  controls.enableDamping = false;
  controls.minDistance = 0.1 * reach;
  controls.maxDistance = 20 * reach;
  if (camera instanceof THREE.OrthographicCamera) {
    controls.enableRotate = false;
    controls.mouseButtons.LEFT = THREE.MOUSE.PAN;
    controls.touches.ONE = THREE.TOUCH.PAN;
  }
  return controls;
}

/** Puts the camera so that the whole box is seen along `way`, as large as it may be. */
function place(
  camera: THREE.PerspectiveCamera | THREE.OrthographicCamera,
  target: THREE.Vector3,
  size: THREE.Vector3,
  way: THREE.Vector3,
  aspect: number,
): void {
  if (camera instanceof THREE.OrthographicCamera) {
    camera.position.copy(target).addScaledVector(way, 3 * size.length());
    return;
  }
  const up = Math.tan((camera.fov * Math.PI) / 360);
  const right = new THREE.Vector3(-way.y, way.x, 0).normalize();
  const over = way.clone().cross(right);
  const [farRight, shiftRight] = fitAlong(right, way, size, up * aspect);
  const [farOver, shiftOver] = fitAlong(over, way, size, up);
  target.addScaledVector(right, shiftRight).addScaledVector(over, shiftOver);
  camera.position.copy(target).addScaledVector(way, 1.05 * Math.max(farRight, farOver));
}

/** Distance and sideways shift that hold a box of this size within a slope of `slope`. */
function fitAlong(
  side: THREE.Vector3,
  way: THREE.Vector3,
  size: THREE.Vector3,
  slope: number,
): [number, number] {
  const most = [-Infinity, -Infinity] as [number, number];
  for (let corner = 0; corner < 8; corner++) {
    const sign = (bit: number) => (corner & bit ? 0.5 : -0.5);
    const at = new THREE.Vector3(sign(1), sign(2), sign(4)).multiply(size);
    most[0] = Math.max(most[0], at.dot(way) + at.dot(side) / slope);
    most[1] = Math.max(most[1], at.dot(way) - at.dot(side) / slope);
  }
  return [(most[0] + most[1]) / 2, (slope * (most[0] - most[1])) / 2];
}

/** Fits the projection to a picture of this aspect. */
function frame(
  camera: THREE.PerspectiveCamera | THREE.OrthographicCamera,
  size: THREE.Vector3,
  aspect: number,
): void {
  if (camera instanceof THREE.PerspectiveCamera) camera.aspect = aspect;
  else {
    const half = 0.52 * Math.max(size.y, size.x / aspect);
    camera.left = -0.52 * size.x; // room that is left is at the right, for the legends
    camera.right = camera.left + 2 * half * aspect;
    camera.top = half;
    camera.bottom = -half;
  }
  camera.updateProjectionMatrix();
}
