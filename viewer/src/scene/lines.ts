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

/**
 * Lines `above` are drawn, in this order, over what was drawn before, with a rim. Others are hidden
 * by what lies before them but for a part `behind`, from 0 to 1, of their strength.
 */
export type Layer = { above: true; order: number } | { above?: false; behind: number };

/** `width` in pixels. */
export function buildLines(segments: number, width: number, layer: Layer): Lines {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(new Float32Array(6 * Math.max(segments, 1)));
  geometry.setColors(new Float32Array(6 * Math.max(segments, 1)));
  const edge = new LineMaterial({ linewidth: width + 2, depthTest: false, transparent: true });
  const object = new THREE.Group();
  object.add(
    ...(layer.above ? above(geometry, edge, width, layer) : within(geometry, width, layer)),
  );
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

/** Drawn after the water, each line over its rim. */
function above(
  geometry: LineSegmentsGeometry,
  edge: LineMaterial,
  linewidth: number,
  { order }: { order: number },
): LineSegments2[] {
  const options = { linewidth, vertexColors: true, depthTest: false, transparent: true };
  return [
    strokes(geometry, edge, order),
    strokes(geometry, new LineMaterial(options), order + 0.5),
  ];
}

/** Drawn in space, and faintly once more where something hides them. */
function within(
  geometry: LineSegmentsGeometry,
  linewidth: number,
  { behind }: { behind: number },
): LineSegments2[] {
  const open = new LineMaterial({ linewidth, vertexColors: true });
  const hidden = new LineMaterial({
    linewidth,
    vertexColors: true,
    transparent: true,
    opacity: behind,
    depthFunc: THREE.GreaterDepth,
    depthWrite: false,
  });
  return [strokes(geometry, open, 0), strokes(geometry, hidden, 4)];
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
