import { describe, expect, it } from 'vitest';
import type { Legend } from '../../src/scene/legend';
import { drawCaption } from '../../src/scene/overlay';
import { LIGHT } from '../../src/scene/theme';

interface Text {
  text: string;
  x: number;
  y: number;
  align: string;
}

/** Notes the texts that are written into it; a letter is 7 wide. */
function noting(): { texts: Text[]; context: CanvasRenderingContext2D } {
  const texts: Text[] = [];
  const own = {
    textAlign: 'left',
    measureText: (text: string) => ({ width: 7 * text.length }),
    fillText: (text: string, x: number, y: number) =>
      void texts.push({ text, x, y, align: own.textAlign }),
  };
  const rest = { get: (from: object, name: string) => Reflect.get(from, name) ?? (() => {}) };
  return { texts, context: new Proxy(own, rest) as unknown as CanvasRenderingContext2D };
}

function written(width: number, title: string, legends: Legend[]): Text[] {
  const { texts, context } = noting();
  drawCaption(
    context,
    width,
    500,
    { title, time: 't = 0 s', notice: '', names: [], legends },
    LIGHT,
  );
  return texts;
}

const signed: Legend = {
  title: 'vorticity',
  unit: '1/s',
  low: -10,
  high: 10,
  map: LIGHT.stress,
  scaled: null,
  open: true,
};
const scaled: Legend = {
  ...signed,
  title: 'total stress',
  low: 0,
  scaled: { by: 'σₒ', factor: 0.1 },
};

describe('captions', () => {
  it('name what colours stand for, one below the other', () => {
    const { texts, context } = noting();
    const names = ['towels', 'shirts'].map((name) => ({ name, colour: '#4477aa' }));
    const caption = { title: '', time: 't = 0 s', notice: '', names, legends: [] };
    drawCaption(context, 800, 500, caption, LIGHT);
    expect(texts.map(({ text }) => text)).toEqual(['t = 0 s', 'towels', 'shirts']);
    expect(texts[2]!.y - texts[1]!.y).toBe(21);
  });

  it('keep the lines of a legend apart', () => {
    for (const legend of [signed, scaled]) {
      const texts = written(800, '', [legend]).filter(({ x }) => x > 400);
      for (const a of texts)
        for (const b of texts)
          if (a !== b && a.align === b.align && Math.abs(a.x - b.x) < 60)
            expect(Math.abs(a.y - b.y), `${a.text} and ${b.text}`).toBeGreaterThanOrEqual(13);
      for (const { y } of texts) expect(y).toBeLessThanOrEqual(500 - 10 - 6);
    }
  });

  it('wrap long titles', () => {
    const words = Array.from({ length: 30 }, (_, i) => `word${i}`);
    const texts = written(600, words.join(' '), []).map(({ text }) => text);
    const lines = texts.slice(0, texts.indexOf('t = 0 s'));
    expect(lines.join(' ')).toBe(words.join(' '));
    expect(lines.length).toBeGreaterThan(2);
    for (const line of lines) expect(7 * line.length).toBeLessThanOrEqual(600 - 32);
    expect(written(600, 'short', []).map(({ text }) => text)).toEqual(['short', 't = 0 s']);
  });
});
