import type { Field } from '../model/field';

/**
 * Share of solids in each cell of a field's frame, from 0 to 1, smoothed over the cells about it,
 * so that the line at a half follows the solids and not the edges of the cells.
 */
export function smoothMask({ index, cells, solid }: Field, frame: number): Float32Array {
  let mask: Float32Array = Float32Array.from(
    solid.subarray(frame * cells, (frame + 1) * cells),
    (q) => q / 255,
  );
  const [nx, ny, nz] = index.cells;
  for (const [count, stride] of [
    [nx, 1],
    [ny, nx],
    [nz, nx * ny],
  ] as const)
    for (let pass = 0; pass < 2 && count > 1; pass++) mask = spread(mask, count, stride);
  return mask;
}

/** Each value with a quarter of its two neighbours along one axis and half of itself. */
function spread(mask: Float32Array, count: number, stride: number): Float32Array {
  const out = new Float32Array(mask.length);
  for (let cell = 0; cell < mask.length; cell++) {
    const at = Math.floor(cell / stride) % count;
    const before = mask[at > 0 ? cell - stride : cell]!;
    const after = mask[at + 1 < count ? cell + stride : cell]!;
    out[cell] = (before + 2 * mask[cell]! + after) / 4;
  }
  return out;
}

/** How far a place with this share of solids is open, from 0 to 1: sharp at a little below a half. */
export function opening(share: number): number {
  return Math.min(Math.max(16 * (0.42 - share) + 0.5, 0), 1);
}
