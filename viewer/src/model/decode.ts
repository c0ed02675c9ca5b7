import type { Bundle, Chunk } from './bundle';

/** The page's data are absent, damaged, or of another version; the message is for the reader. */
export class DataError extends Error {}

/** Reads the index from the element `washtub-data`; throws DataError where there is none. */
export function readBundle(page: Document): Bundle {
  const text = page.getElementById('washtub-data')?.textContent;
  if (!text) throw new DataError('This page holds no data. Make it with: washtub report DIR');
  let bundle: unknown;
  try {
    bundle = JSON.parse(text);
  } catch {
    throw new DataError('The data of this page are damaged: their index cannot be read.');
  }
  return checked(bundle);
}

function checked(bundle: unknown): Bundle {
  const { version, runs } = (bundle ?? {}) as Partial<Record<keyof Bundle, unknown>>;
  if (version !== 1)
    throw new DataError(
      `The data of this page are of version ${String(version)}; the page reads version 1. ` +
        'Make the page again with one version of washtub.',
    );
  if (!Array.isArray(runs) || runs.length === 0)
    throw new DataError('The data of this page are damaged: they name no run.');
  return bundle as Bundle;
}

/** Reads one chunk; chunks are decoded when asked for. */
export type ChunkReader = (chunk: Chunk) => Promise<Uint8Array>;

const TOO_OLD =
  'This browser is too old to read the data of this page. ' +
  'It needs Firefox 113, Chromium 80, Safari 16.4 or a later one.';

/**
 * Reads chunks from the elements `washtub-chunk-N`, each of them once: the element is taken out of
 * the page, so that its text takes no memory.
 */
export function chunkReader(page: Document): ChunkReader {
  return async (chunk) => {
    if (typeof DecompressionStream === 'undefined') throw new DataError(TOO_OLD);
    const element = page.getElementById(`washtub-chunk-${chunk}`);
    if (!element)
      throw new DataError(`The data of this page are damaged: part ${chunk} is missing.`);
    const text = element.textContent ?? '';
    element.remove();
    try {
      return await inflate(fromBase64(text));
    } catch {
      throw new DataError(`The data of this page are damaged: part ${chunk} cannot be read.`);
    }
  };
}

export function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text.trim());
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** Undoes deflate with zlib's header and checksum. */
export async function inflate(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Little-endian 16-bit numbers. */
export function toUint16(bytes: Uint8Array): Uint16Array {
  return numbers(
    bytes,
    2,
    (n) => new Uint16Array(n),
    (view, at) => view.getUint16(at, true),
  );
}

/** Little-endian 32-bit whole numbers. */
export function toUint32(bytes: Uint8Array): Uint32Array {
  return numbers(
    bytes,
    4,
    (n) => new Uint32Array(n),
    (view, at) => view.getUint32(at, true),
  );
}

/** Little-endian 32-bit floating-point numbers. */
export function toFloat32(bytes: Uint8Array): Float32Array {
  return numbers(
    bytes,
    4,
    (n) => new Float32Array(n),
    (view, at) => view.getFloat32(at, true),
  );
}

export function toInt8(bytes: Uint8Array): Int8Array {
  return new Int8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}

function numbers<T extends { [i: number]: number; length: number }>(
  bytes: Uint8Array,
  size: number,
  make: (length: number) => T,
  read: (view: DataView, at: number) => number,
): T {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const values = make(Math.floor(bytes.byteLength / size));
  for (let i = 0; i < values.length; i++) values[i] = read(view, i * size);
  return values;
}
