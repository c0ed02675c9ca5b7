import { deflateSync } from 'node:zlib';
import { describe, expect, it, vi } from 'vitest';
import {
  chunkReader,
  DataError,
  readBundle,
  toFloat32,
  toInt8,
  toUint16,
  toUint32,
} from '../../src/model/decode';

/** A page that holds these elements. */
function pageOf(elements: Record<string, string>): Document {
  const found = (id: string) =>
    id in elements ? { textContent: elements[id], remove: () => delete elements[id] } : null;
  return { getElementById: found } as unknown as Document;
}

const bundle = (change: object) =>
  pageOf({ 'washtub-data': JSON.stringify({ version: 1, runs: [{}], ...change }) });

describe('readBundle', () => {
  it('returns the index', () => {
    expect(readBundle(bundle({ program: 'washtub 1' })).program).toBe('washtub 1');
  });

  it('says that a page holds no data', () => {
    expect(() => readBundle(pageOf({}))).toThrow(/holds no data.*washtub report DIR/);
  });

  it('says that an index is damaged', () => {
    expect(() => readBundle(pageOf({ 'washtub-data': '{"version": 1,' }))).toThrow(/damaged/);
    expect(() => readBundle(bundle({ runs: [] }))).toThrow(/no run/);
  });

  it('names another version', () => {
    expect(() => readBundle(bundle({ version: 7 }))).toThrow(/version 7.*reads version 1/);
  });
});

describe('chunkReader', () => {
  const bytes = Buffer.from([1, 2, 3, 255]);
  const text = deflateSync(bytes).toString('base64');

  it('undoes base64 and deflate', async () => {
    const read = chunkReader(pageOf({ 'washtub-chunk-3': `\n${text}\n` }));
    expect([...(await read(3))]).toEqual([1, 2, 3, 255]);
  });

  it('takes out of the page what it has read', async () => {
    const elements = { 'washtub-chunk-0': text };
    await chunkReader(pageOf(elements))(0);
    expect(elements).toEqual({});
  });

  it('names the browsers that can read the data', async () => {
    vi.stubGlobal('DecompressionStream', undefined);
    const read = chunkReader(pageOf({ 'washtub-chunk-0': text }));
    await expect(read(0)).rejects.toThrow(/too old.*Firefox 113/);
    vi.unstubAllGlobals();
  });

  it('names a missing part', async () => {
    await expect(chunkReader(pageOf({}))(5)).rejects.toThrow(/part 5 is missing/);
  });

  it('names a damaged part', async () => {
    const cut = chunkReader(pageOf({ 'washtub-chunk-0': text.slice(0, 8) }));
    await expect(cut(0)).rejects.toThrow(DataError);
    const strange = chunkReader(pageOf({ 'washtub-chunk-0': '%%%' }));
    await expect(strange(0)).rejects.toThrow(/part 0 cannot be read/);
  });
});

describe('numbers', () => {
  /** Bytes that begin at an odd address. */
  const odd = (values: number[]) => new Uint8Array([0, ...values]).subarray(1);

  it('are little-endian at any address', () => {
    expect([...toUint16(odd([1, 2, 255, 255]))]).toEqual([513, 65535]);
    expect([...toUint32(odd([1, 0, 0, 1]))]).toEqual([16777217]);
    expect([...toFloat32(odd([0, 0, 192, 191]))]).toEqual([-1.5]);
    expect([...toInt8(odd([127, 128, 255]))]).toEqual([127, -128, -1]);
  });
});
