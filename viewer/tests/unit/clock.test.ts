import { describe, expect, it } from 'vitest';
import { Clock } from '../../src/model/clock';

describe('the clock', () => {
  it('starts at a pace that suits the span', () => {
    const pace = (end: number) => new Clock([0, end]).state.speed;
    expect([0.005, 0.5, 1, 6, 90].map(pace)).toEqual([0.001, 0.1, 1, 1, 1]);
    expect(pace(2000)).toBe(100);
    expect(new Clock([]).state.speed).toBe(1);
  });

  it('steps from frame to frame and stays within them', () => {
    const clock = new Clock([0, 1, 3]);
    clock.set({ time: 1.5 });
    clock.step(1);
    expect(clock.state.time).toBe(3);
    clock.step(5);
    expect(clock.state.time).toBe(3);
    clock.step(-1);
    expect(clock.state.time).toBe(1);
  });
});
