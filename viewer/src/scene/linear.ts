/** Light of each of the 256 levels of a screen colour (sRGB), from 0 to 1. */
export const linear = Float32Array.from({ length: 256 }, (_, level) => {
  const c = level / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
});
