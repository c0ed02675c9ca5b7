/**
 * Weights that refine a row of nodes by Catmull-Rom splines, which pass through the nodes. Point
 * i of the finer row is the sum over m = 0 ... 3 of weight[4 i + m] times node[4 i + m]; `slope`
 * gives the derivative by the node number.
 */
export interface Refinement {
  points: number;
  node: Uint16Array;
  weight: Float32Array;
  slope: Float32Array;
}

/** `parts` points per interval; a closed row ends where it began. */
export function refine(nodes: number, parts: number, closed: boolean): Refinement {
  if (nodes < 2) return single();
  const intervals = closed ? nodes : nodes - 1;
  const points = intervals * parts + 1;
  const rows: Refinement = {
    points,
    node: new Uint16Array(4 * points),
    weight: new Float32Array(4 * points),
    slope: new Float32Array(4 * points),
  };
  for (let i = 0; i < points; i++) {
    const interval = Math.min(Math.floor(i / parts), intervals - 1);
    fillPoint(rows, i, interval, i / parts - interval, nodes, closed);
  }
  return rows;
}

function single(): Refinement {
  const weight = Float32Array.of(1, 0, 0, 0);
  return { points: 1, node: new Uint16Array(4), weight, slope: new Float32Array(4) };
}

function fillPoint(
  rows: Refinement,
  point: number,
  interval: number,
  t: number,
  nodes: number,
  closed: boolean,
): void {
  const first = closed ? interval - 1 : Math.min(Math.max(interval - 1, 0), Math.max(nodes - 4, 0));
  const [weights, slopes] = catmullRom(t);
  for (let m = 0; m < 4; m++) {
    rows.node[4 * point + m] = closed
      ? (first + m + nodes) % nodes
      : Math.min(first + m, nodes - 1);
    if (closed) {
      rows.weight[4 * point + m] = weights[m]!;
      rows.slope[4 * point + m] = slopes[m]!;
    }
  }
  if (closed) return;
  for (let m = 0; m < 4; m++)
    for (const [node, share] of behindEnds(interval - 1 + m, nodes)) {
      rows.weight[4 * point + node - first]! += share * weights[m]!;
      rows.slope[4 * point + node - first]! += share * slopes[m]!;
    }
}

/** Weights of the four nodes about an interval at t in [0, 1], and their derivatives. */
function catmullRom(t: number): [number[], number[]] {
  const tt = t * t;
  const ttt = tt * t;
  return [
    [
      (-ttt + 2 * tt - t) / 2,
      (3 * ttt - 5 * tt + 2) / 2,
      (-3 * ttt + 4 * tt + t) / 2,
      (ttt - tt) / 2,
    ],
    [
      (-3 * tt + 4 * t - 1) / 2,
      (9 * tt - 10 * t) / 2,
      (-9 * tt + 8 * t + 1) / 2,
      (3 * tt - 2 * t) / 2,
    ],
  ];
}

/** A node beyond the ends of an open row as a sum of nodes: by a parabola through the last three. */
function behindEnds(node: number, nodes: number): [number, number][] {
  if (node >= 0 && node < nodes) return [[node, 1]];
  const end = node < 0 ? 0 : nodes - 1;
  const inward = node < 0 ? 1 : -1;
  if (nodes === 2)
    return [
      [end, 2],
      [end + inward, -1],
    ];
  return [
    [end, 3],
    [end + inward, -3],
    [end + 2 * inward, 1],
  ];
}

/** Points per interval that keep all pieces together below `limit` points, between 1 and 4. */
export function partsFor(nodes: number, limit: number): number {
  return Math.min(Math.max(Math.floor(Math.sqrt(limit / Math.max(nodes, 1))), 1), 4);
}
