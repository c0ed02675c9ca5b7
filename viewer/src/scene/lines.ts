import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import * as THREE from 'three';

/** Segments of constant width in pixels, written in place. */
export interface Lines {
  object: THREE.Group;
  ends: Float32Array; // [segment][x y z of the one end, x y z of the other]
  colours: Float32Array; // the same with red green blue, as light from 0 to 1
  /** Sends the first `count` segments to the screen. */
  send(count: number): void;
  /** Colour of the narrow rim of lines that lie above. */
  rim(colour: string): void;
}

/** `width` in pixels; lines `above` are drawn, in this order, over what was drawn before. */
export function buildLines(segments: number, width: number, above: boolean, order: number): Lines {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(new Float32Array(6 * Math.max(segments, 1)));
  geometry.setColors(new Float32Array(6 * Math.max(segments, 1)));
  const material = new LineMaterial({
    linewidth: width,
    vertexColors: true,
    depthTest: !above,
    transparent: above, // drawn after the water
  });
  const object = new THREE.Group();
  const edge = new LineMaterial({ linewidth: width + 2, depthTest: !above, transparent: above });
  if (above) object.add(strokes(geometry, edge, order));
  object.add(strokes(geometry, material, order + 0.5));
  const ends = buffer(geometry, 'instanceStart');
  const colours = buffer(geometry, 'instanceColorStart');
  return {
    object,
    ends: ends.array as Float32Array,
    colours: colours.array as Float32Array,
    rim: (colour) => void edge.color.set(colour),
    send(count) {
      object.visible = count > 0;
      geometry.instanceCount = count;
      ends.needsUpdate = colours.needsUpdate = true;
    },
  };
}

function strokes(geometry: LineSegmentsGeometry, material: LineMaterial, order: number) {
  const object = new LineSegments2(geometry, material);
  object.frustumCulled = false;
  object.renderOrder = order;
  return object;
}

function buffer(geometry: LineSegmentsGeometry, name: string): THREE.InstancedInterleavedBuffer {
  const attribute = geometry.getAttribute(name) as THREE.InterleavedBufferAttribute;
  return attribute.data as THREE.InstancedInterleavedBuffer;
}
