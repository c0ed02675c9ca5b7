import type { ClothIndex } from '../model/bundle';

/** Colours of pieces and values. Palettes are told apart by colour-blind readers as well. */

/** Paul Tol's "bright" and "muted" hues, in an order that keeps neighbours apart. */
const PIECES =
  '#4477aa #ee6677 #ccbb44 #228833 #66ccee #aa3377 #ddaa77 #44aa99 #9988dd #cc6633'.split(' ');

/** Colour of a piece, "#rrggbb"; hues repeat after ten pieces, lighter or darker. */
export function pieceColour(piece: number): string {
  const hue = PIECES[piece % PIECES.length]!;
  const round = Math.floor(piece / PIECES.length) % 5;
  return round === 0
    ? hue
    : mix(hue, round % 2 ? '#ffffff' : '#101018', [0, 0.38, 0.3, 0.6, 0.5][round]!);
}

/** Colour of a piece, or of its group. */
export function colourOf(cloth: ClothIndex, piece: number, grouped: boolean): string {
  return pieceColour(grouped ? groupOf(cloth, piece) : piece);
}

/** Number of the group that a piece belongs to. */
export function groupOf({ groups }: ClothIndex, piece: number): number {
  let before = 0;
  return groups.findIndex(({ pieces }) => piece < (before += pieces));
}

/** Red, green, blue from 0 to 255 of "#rrggbb". */
export function channels(colour: string): [number, number, number] {
  const n = Number.parseInt(colour.slice(1), 16);
  return [(n >> 16) & 255, (n >> 8) & 255, n & 255];
}

function mix(from: string, to: string, part: number): string {
  const [a, b] = [channels(from), channels(to)];
  const hex = a.map((v, i) =>
    Math.round(v + part * (b[i]! - v))
      .toString(16)
      .padStart(2, '0'),
  );
  return `#${hex.join('')}`;
}

/** A colour map: 256 colours, red green blue from 0 to 255, one after the other. */
export type ColourMap = Uint8Array;

/** matplotlib's viridis without its darkest end, which would hide shading. */
export const VIRIDIS = mapOf(
  '#46327e #3f4d8a #365c8d #2c738e #277f8e #1fa187 #2db27d #5ec962 #86d549 #c2df23 #fde725',
);

/** Pale to deep blue-green, for water on a light page; even in lightness. */
export const WATER = mapOf(
  '#e2eef4 #c9e2ec #b2d8e4 #8cc6d8 #62b1cb #3a98bb #217da8 #1a6190 #1b4674 #1a2c52',
);

/** Dark to pale: the same for a dark page. */
export const WATER_DARK = mapOf(
  '#161f29 #19334b #1b4a6c #1d638b #2b7ea6 #4c99bb #76b3cc #a2ccdc #cde4ed #f2fafd',
);

/** Blue over grey to red, for values of both signs. */
export const COOLWARM = mapOf(
  '#3b4cc0 #5977e3 #7b9ff9 #9ebeff #c0d4f5 #dddcdc #f2cbb7 #f7ac8e #ee8468 #d65244 #b40426',
);

/** Blue over near-black to red: the same for a dark page. */
export const COOLWARM_DARK = mapOf(
  '#9ecbff #5aa0f2 #3a78d0 #2c5596 #23375c #1c2028 #5a2a2c #963636 #d04a40 #f27a5a #ffc09e',
);

function mapOf(colours: string): ColourMap {
  const stops = colours.split(' ');
  const map = new Uint8Array(256 * 3);
  for (let i = 0; i < 256; i++) {
    const at = (i / 255) * (stops.length - 1);
    const stop = Math.min(Math.floor(at), stops.length - 2);
    map.set(channels(mix(stops[stop]!, stops[stop + 1]!, at - stop)), 3 * i);
  }
  return map;
}

/** Offset into a colour map of `value` in the range from `low` to `high`. */
export function mapOffset(value: number, low: number, high: number): number {
  const part = high > low ? (value - low) / (high - low) : 0;
  return 3 * Math.round(255 * Math.min(Math.max(part, 0), 1));
}
