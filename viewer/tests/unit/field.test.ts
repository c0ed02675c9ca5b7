import { describe, expect, it } from 'vitest';
import { expansion, fieldFrame, quantitiesOf, quantityOf, wordsFor } from '../../src/model/field';
import { Sampler } from '../../src/scene/sampling';
import { madeField } from './made';

describe('field', () => {
  const velocity = Int8Array.from([127, 0, -127, 0, 127, 0]); // two cells: x, y, z
  const field = madeField([2, 1, 1], velocity, 4);

  it('expands numbers by their squares', () => {
    const table = expansion(4);
    expect(table[128 + 127]).toBe(4);
    expect(table[128 - 127]).toBe(-4);
    expect(table[128 + 64]).toBeCloseTo(4 * (64 / 127) ** 2, 5);
  });

  it('gives speed and components', () => {
    const out = new Float32Array(2);
    quantityOf(field, 'speed', 0, out);
    expect(out[0]).toBeCloseTo(4 * Math.sqrt(3), 5);
    expect(out[1]).toBe(0);
    quantityOf(field, 'y', 0, out);
    expect(out[0]).toBe(-4);
  });

  it('shows every scalar of the run by the name that its declaration gives', () => {
    const salt = { name: 'salt', label: 'salt content', unit: 'kg/m^3', meaning: '', values: 1 };
    const index = { ...field.index, scalars: [{ ...salt, largest: [9] }] };
    const salty = { ...field, index, scalars: { salt: Int8Array.from([127, -127]) } };
    const out = new Float32Array(2);
    quantityOf(salty, 'salt', 0, out);
    expect([...out]).toEqual([9, -9]);
    expect(quantitiesOf(salty)).toContain('salt');
    expect(wordsFor(salty, 'salt')).toEqual({ label: 'salt content', unit: 'kg/m^3' });
    expect(wordsFor(salty, 'speed').unit).toBe('m/s');
  });

  it('takes the frame not later where fewer carry the water', () => {
    const sparse = { ...field, times: [0, 2, 4] };
    expect([0, 1.9, 2, 3.9, 9].map((time) => fieldFrame(sparse, time))).toEqual([0, 0, 1, 1, 2]);
  });
});

describe('Sampler', () => {
  const field = madeField([4, 3, 2], new Int8Array(72), 1);
  const sampler = new Sampler(field);
  const values = Float32Array.from({ length: 24 }, (_, cell) => {
    const [i, j, k] = [cell % 4, Math.floor(cell / 4) % 3, Math.floor(cell / 12)];
    return 1 + 2 * (i + 0.5) - 3 * (j + 0.5) + 5 * (k + 0.5);
  });

  it('is exact for what is linear', () => {
    sampler.seek(1.3, 2.1, 0.9);
    expect(sampler.value(values)).toBeCloseTo(1 + 2.6 - 6.3 + 4.5, 5);
  });

  it('is constant beyond the outermost centres', () => {
    sampler.seek(0.1, 0.5, 0.5);
    expect(sampler.value(values)).toBeCloseTo(values[0]!, 5);
    sampler.seek(9, 9, 9);
    expect(sampler.value(values)).toBeCloseTo(values[23]!, 5);
  });
});
