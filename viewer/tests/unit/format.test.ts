import { describe, expect, it } from 'vitest';
import type { Quantity, RunIndex } from '../../src/model/bundle';
import { withPlus } from '../../src/page/comparison';
import { footnotes, formatQuantity, windowText } from '../../src/page/summary';
import {
  displayOf,
  formatBeside,
  formatInterval,
  formatNumber,
  formatPercent,
  formatTicks,
  prettyUnit,
} from '../../src/plots/format';

describe('formatInterval', () => {
  it('gives the half width two digits, which decide those of the mean', () => {
    expect(formatInterval(167.703, 24.932)).toBe('168 ± 25');
    expect(formatInterval(11.0509, 1.6429)).toBe('11.1 ± 1.6');
    expect(formatInterval(68.535, 0.0963)).toBe('68.535 ± 0.096');
    expect(formatInterval(-3.14159, 0.2)).toBe('−3.14 ± 0.20');
  });

  it('rounds places left of the point', () => {
    expect(formatInterval(12345, 678)).toBe('12350 ± 680');
  });

  it('counts digits after rounding', () => {
    expect(formatInterval(5, 0.0996)).toBe('5.00 ± 0.10');
  });

  it('takes out one power of ten from small and large numbers', () => {
    expect(formatInterval(5.78e-4, 1.2e-5)).toBe('(5.78 ± 0.12) × 10⁻⁴');
    expect(formatInterval(2.5e7, 1e6)).toBe('(2.50 ± 0.10) × 10⁷');
  });

  it('shows four digits where there is no half width', () => {
    expect(formatInterval(32811.23, null)).toBe('32810');
    expect(formatInterval(2.16212, null)).toBe('2.162');
  });

  it('keeps a mean smaller than its half width', () => {
    expect(formatInterval(0.0004, 0.25)).toBe('0.00 ± 0.25');
  });
});

describe('formatNumber', () => {
  it('writes powers of ten only where they help', () => {
    expect(formatNumber(0)).toBe('0');
    expect(formatNumber(0.00123456)).toBe('0.001235');
    expect(formatNumber(0.000123456)).toBe('1.235 × 10⁻⁴');
    expect(formatNumber(-1234567)).toBe('−1.235 × 10⁶');
    expect(formatNumber(NaN)).toBe('–');
  });
});

describe('formatBeside', () => {
  it('shows 0 for what is nothing beside the largest', () => {
    expect(formatBeside(1.069e-9, 1000)).toBe('0');
    expect(formatBeside(0.1, 1000)).toBe('0.1000');
    expect(formatBeside(1.069e-9, 0)).toBe('1.069 × 10⁻⁹');
    expect(formatBeside(NaN, 1000)).toBe('–');
  });
});

describe('displayOf', () => {
  it('chooses prefixes for engineers', () => {
    expect(displayOf('Pa', 167703)).toEqual({ factor: 1e-3, unit: 'kPa' });
    expect(displayOf('m', 0.0573)).toEqual({ factor: 1 / 1e-3, unit: 'mm' });
    expect(displayOf('N m', 5.6)).toEqual({ factor: 1, unit: 'N m' });
    expect(displayOf('W/m', 901031)).toEqual({ factor: 1e-3, unit: 'kW/m' });
    expect(displayOf('N m/m', 5600).unit).toBe('kN m/m');
    expect(displayOf('J/m', 0.012).unit).toBe('mJ/m');
    expect(displayOf('m^2', 1e-4)).toEqual({ factor: 1, unit: 'm²' });
    expect(displayOf('', 1e-9)).toEqual({ factor: 1, unit: '' });
  });

  it('never shows kilometres', () => {
    expect(displayOf('m', 5e4).unit).toBe('m');
  });
});

describe('formatQuantity', () => {
  it('changes mean and half width alike', () => {
    const shown = formatQuantity({ mean: 167703, half_width: 24932, unit: 'Pa' });
    expect(shown).toEqual({ text: '168 ± 25', unit: 'kPa' });
  });
});

describe('an interval wider than its mean', () => {
  const wide = { mean: 352.4, half_width: 1731, unit: 'W' };

  it('leaves the mean three digits', () => {
    expect(formatQuantity(wide)).toEqual({ text: '352 ± 1730', unit: 'W' });
    expect(formatQuantity({ ...wide, mean: 1e-14 }).text).toBe('0 ± 1730');
  });

  it('has a footnote with the number of batches', () => {
    const quantity: Quantity = { ...wide, name: 'power', meaning: '', batches: 2, scaled: null };
    const text = '† Interval wider than the mean: too few cycles (2).';
    expect(footnotes([quantity], true)).toEqual([text]);
    expect(footnotes([{ ...quantity, half_width: 1 }], true)).toEqual([]);
    expect(footnotes([{ ...quantity, half_width: null }], true)[0]).toMatch(/^\* No interval/);
  });
});

describe('windowText', () => {
  const text = (averaged: [number, number], period: number) =>
    windowText({ averaged, scales: { period } } as RunIndex);

  it('names times and cycles, or says that they are not known', () => {
    expect(text([1, 3], 0.5)).toMatch(/^Over 1.000 s to 3.000 s, 4 cycles;/);
    expect(text([0, 0], 0.5)).toMatch(/not known/);
  });
});

describe('formatTicks', () => {
  it('shows the step in full', () => {
    expect(formatTicks([0, 2.5, 5], 2.5)).toEqual(['0.0', '2.5', '5.0']);
    expect(formatTicks([-0.25, 0], 0.25)).toEqual(['−0.25', '0.00']);
    expect(formatTicks([0, 100], 100)).toEqual(['0', '100']);
  });
});

describe('signs', () => {
  it('gives percent their sign and units their powers', () => {
    expect(formatPercent(12.34)).toBe('+12 %');
    expect(formatPercent(-3.51)).toBe('−3.5 %');
    expect(formatPercent(0)).toBe('0 %');
    expect(withPlus(formatInterval(12, 3.4))).toBe('+12.0 ± 3.4');
    expect(withPlus(formatInterval(5.78e-4, 1.2e-5))).toBe('(+5.78 ± 0.12) × 10⁻⁴');
    expect(prettyUnit('kg/m^3')).toBe('kg/m³');
    expect(prettyUnit('m^-1')).toBe('m⁻¹');
  });
});
