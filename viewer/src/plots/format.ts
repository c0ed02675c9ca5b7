const prefixes: readonly [number, string][] = [
  [1e-6, 'µ'],
  [1e-3, 'm'],
  [1, ''],
  [1e3, 'k'],
  [1e6, 'M'],
  [1e9, 'G'],
];
const prefixable = /^((Pa|N|J|W)( m)?(\/m|\/s)?|m(\/s)?|s)$/;

/** How a quantity is shown: its value in SI units times `factor` is in `unit`. */
export interface Display {
  factor: number;
  unit: string;
}

/** "m^2" as "m²". */
export function prettyUnit(unit: string): string {
  const digits = '⁰¹²³⁴⁵⁶⁷⁸⁹';
  return unit.replace(/\^(-?)(\d)/g, (_, sign: string, d: string) => {
    return (sign ? '⁻' : '') + digits[Number(d)]!;
  });
}

/** The engineering prefix with which values up to `largest` (SI) read best. */
export function displayOf(unit: string, largest: number): Display {
  const size = Math.abs(largest);
  const plain = { factor: 1, unit: prettyUnit(unit) };
  if (!prefixable.test(unit) || !(size > 0) || !Number.isFinite(size)) return plain;
  if (size >= 0.5 && size < 2000) return plain;
  const usable = unit.startsWith('m') || unit === 's' ? prefixes.slice(0, 3) : prefixes;
  const best = usable.filter(([p]) => size >= 0.9999999 * p).at(-1) ?? usable[0]!;
  return { factor: 1 / best[0], unit: best[1] + plain.unit };
}

const minus = (text: string) => text.replace(/-/g, '−');

function superscript(exponent: number): string {
  return [...String(exponent)].map((c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(c)]!)).join('');
}

const orderOf = (x: number) => Math.floor(Math.log10(Math.abs(x)));

/** Rounds to the place 10^-decimals, which may lie left of the point. */
function atPlace(x: number, decimals: number): string {
  if (decimals >= 0) return x.toFixed(Math.min(decimals, 20));
  const unit = 10 ** -decimals;
  return (Math.round(x / unit) * unit).toFixed(0);
}

/** A number with so many significant digits; powers of ten only where it is very small or large. */
export function formatNumber(x: number, digits = 4): string {
  if (!Number.isFinite(x)) return '–';
  if (x === 0) return '0';
  const rounded = Number(x.toPrecision(digits));
  const order = orderOf(rounded);
  if (order >= -3 && order < 6) return minus(atPlace(rounded, digits - 1 - order));
  return minus((rounded / 10 ** order).toFixed(digits - 1)) + ` × 10${superscript(order)}`;
}

/** The same; 0 where it is nothing beside `largest`, the size of the values around it. */
export function formatBeside(x: number, largest: number, digits = 4): string {
  return formatNumber(Math.abs(x) < 1e-5 * largest ? 0 : x, digits);
}

/**
 * "168 ± 25": the half width has two significant digits and decides those of the mean; without one
 * the mean has four.
 */
export function formatInterval(mean: number, halfWidth: number | null): string {
  if (halfWidth === null || !(halfWidth > 0) || !Number.isFinite(mean)) return formatNumber(mean);
  const largest = Math.max(Math.abs(mean), halfWidth);
  const order = orderOf(largest);
  const power = order < -3 || order >= 6 ? order : 0;
  const half = Number((halfWidth / 10 ** power).toPrecision(2));
  const decimals = 1 - orderOf(half);
  const text = `${minus(atPlace(mean / 10 ** power, decimals))} ± ${atPlace(half, decimals)}`;
  return power === 0 ? text : `(${text}) × 10${superscript(power)}`;
}

/** Whether the half width of an interval exceeds the mean that it belongs to. */
export function isWide(mean: number, halfWidth: number | null): boolean {
  return halfWidth !== null && halfWidth > Math.abs(mean);
}

/** As `formatInterval`; where the half width exceeds the mean, both have three digits. */
export function formatMean(mean: number, halfWidth: number | null): string {
  if (!isWide(mean, halfWidth)) return formatInterval(mean, halfWidth);
  return `${formatBeside(mean, halfWidth!, 3)} ± ${formatNumber(halfWidth!, 3)}`;
}

/** "+12 %", "−3.5 %": always with its sign. */
export function formatPercent(percent: number): string {
  const sign = percent > 0 ? '+' : '';
  return `${sign}${formatNumber(percent, Math.abs(percent) >= 100 ? 3 : 2)} %`;
}

/** Decimal places that show a step such as 0.25 in full. */
function decimalsOf(step: number): number {
  let decimals = Math.max(0, -orderOf(step));
  const isWhole = () => Math.abs(step * 10 ** decimals - Math.round(step * 10 ** decimals)) < 1e-6;
  while (decimals < 8 && !isWhole()) ++decimals;
  return decimals;
}

/** Labels of an axis whose ticks lie `step` apart. */
export function formatTicks(ticks: readonly number[], step: number): string[] {
  const largest = Math.max(...ticks.map(Math.abs));
  if (orderOf(step) < -4 || largest >= 1e6) return ticks.map((tick) => formatNumber(tick, 3));
  const decimals = decimalsOf(step);
  return ticks.map((tick) => minus((tick + 0).toFixed(decimals)));
}

/** "stress [kPa]", "strain" where there is no unit. */
export function withUnit(name: string, unit: string): string {
  return unit === '' ? name : `${name} [${unit}]`;
}

/** "sigma_o" as "σₒ"; other symbols with an index o likewise. */
export function prettySymbol(symbol: string): string {
  return symbol.replace('sigma', 'σ').replace('tau', 'τ').replace(/_o$/, 'ₒ');
}
