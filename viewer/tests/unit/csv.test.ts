import { describe, expect, it } from 'vitest';
import { csvLine, findColumn, parseHeader, parseTable } from '../../src/model/csv';

describe('parseHeader', () => {
  it('takes name and unit apart', () => {
    expect(parseHeader('kinetic energy [J/m]')).toEqual({ name: 'kinetic energy', unit: 'J/m' });
    expect(parseHeader('courant')).toEqual({ name: 'courant', unit: '' });
    expect(parseHeader('slip []')).toEqual({ name: 'slip', unit: '' });
  });
});

describe('parseTable', () => {
  it('keeps every digit', () => {
    const table = parseTable('time [s],stress [Pa]\n0,1.06908465e-06\n0.00785398163,-3811.0182\n');
    expect(table.rows).toBe(2);
    expect([...findColumn(table, 'time')!.values]).toEqual([0, 0.00785398163]);
    expect([...findColumn(table, 'stress')!.values]).toEqual([1.06908465e-6, -3811.0182]);
  });

  it('drops a last line that was cut off, though all its cells are there', () => {
    const table = parseTable('time [s],stress [Pa]\n0,12\n1,345\n2,6');
    expect([...findColumn(table, 'time')!.values]).toEqual([0, 1]);
  });

  it('drops lines of another length', () => {
    expect(parseTable('a,b\n1,2\n3\n4,5,6\n7,8\n').rows).toBe(2);
  });

  it('takes an empty cell for no number, and keeps the row', () => {
    const table = parseTable('a,b\n1,\n2,3\n');
    expect([...findColumn(table, 'a')!.values]).toEqual([1, 2]);
    expect([...findColumn(table, 'b')!.values]).toEqual([NaN, 3]);
  });

  it('reads lines that end as on Windows, and numbers that are none', () => {
    const table = parseTable('a,b\r\n1,nan\r\n');
    expect(findColumn(table, 'b')!.values[0]).toBeNaN();
    expect(findColumn(table, 'a')!.values[0]).toBe(1);
  });

  it('has no rows where there is only a header, cut or not', () => {
    expect(parseTable('time [s],stress [Pa]').rows).toBe(0);
    expect(parseTable('').rows).toBe(0);
    expect(findColumn(parseTable('a\n'), 'b')).toBeNull();
  });
});

describe('csvLine', () => {
  it('quotes what would break the line', () => {
    expect(csvLine(['a', 1.5, ''])).toBe('a,1.5,');
    expect(csvLine(['a, b', 'say "c"', 'd\ne'])).toBe('"a, b","say ""c""","d\ne"');
  });
});
