// The orders of the micro-triangles: the curve of the Vulkan specification, and rows from the w-corner.

/** A micro-triangle by its grid square; inverted: the upper half of the square. */
export interface Micro {
  i: number;
  j: number;
  inverted: boolean;
}

export type Order = "curve" | "rows";

/** Every other bit is a bit of x. Domain: x below 2^16. */
function spread(x: number): number {
  x = (x | (x << 8)) & 0x00ff00ff;
  x = (x | (x << 4)) & 0x0f0f0f0f;
  x = (x | (x << 2)) & 0x33333333;
  return (x | (x << 1)) & 0x55555555;
}

/** Index on the curve: iw = NOT(i+j), one less in the upper half of a square; b0 = NOT(i XOR iw), t = (i XOR j) AND b0,
 * f = XOR of t from above, b1 = ((f XOR i) AND NOT b0) OR t; b0 in the even bits, b1 in the odd ones.
 * Domain: a micro-triangle of level n in 0..16. Source: VK_EXT_opacity_micromap, appendix "Reference Code". */
export function curveIndex(i: number, j: number, inverted: boolean, n: number): number {
  const low = (1 << n) - 1;
  const iw = ~(i + j) - (inverted ? 1 : 0);
  const b0 = ~(i ^ iw) & low;
  const t = (i ^ j) & b0;
  let f = t ^ (t >>> 1);
  f ^= f >>> 2;
  f ^= f >>> 4;
  f ^= f >>> 8;
  const b1 = (((f ^ i) & ~b0) | t) & low;
  return (spread(b0) | (spread(b1) << 1)) >>> 0;
}

/** Index in row order: row squared, and the place in the row, from v = 0 up. */
export function rowIndex(i: number, j: number, inverted: boolean): number {
  const row = i + j + (inverted ? 1 : 0);
  return row * row + 2 * j + (inverted ? 1 : 0);
}

export const indexOf = (m: Micro, n: number, order: Order): number =>
  order === "curve" ? curveIndex(m.i, m.j, m.inverted, n) : rowIndex(m.i, m.j, m.inverted);

/** The micro-triangle that holds a point, as Vulkan's formula has it: a point on a grid line goes to the upper side, but at
 * the hypotenuse. Domain: u, v in [0, 1], exact multiples of 1/(4N) at least. */
export function microAt(u: number, v: number, n: number): Micro {
  const N = 2 ** n;
  let i = Math.floor(u * N);
  let j = Math.floor(v * N);
  const upper = u * N - i + (v * N - j) >= 1;
  i = Math.min(i, N - 1);
  j = Math.min(j, N - 1);
  const s = i + j;
  if (s >= N) i -= s - N + 1;
  return { i, j, inverted: upper && i + j < N - 1 };
}

/** Corners on the grid of level n: three pairs (i, j), in the order child 0, 2, 3 touch them. */
export type Corners = [number, number, number, number, number, number];

/** P = (w-corner, u-corner, v-corner); per digit, with Pab the midpoint of Pa and Pb:
 * 0: (P0, P01, P02)   1: (P02, P12, P01)   2: (P01, P1, P12)   3: (P12, P02, P2). */
export function child(c: Corners, digit: number): Corners {
  const [x0, y0, x1, y1, x2, y2] = c;
  const x01 = (x0 + x1) / 2, y01 = (y0 + y1) / 2;
  const x02 = (x0 + x2) / 2, y02 = (y0 + y2) / 2;
  const x12 = (x1 + x2) / 2, y12 = (y1 + y2) / 2;
  switch (digit) {
    case 0:
      return [x0, y0, x01, y01, x02, y02];
    case 1:
      return [x02, y02, x12, y12, x01, y01];
    case 2:
      return [x01, y01, x1, y1, x12, y12];
    default:
      return [x12, y12, x02, y02, x2, y2];
  }
}

export const whole = (n: number): Corners => [0, 0, 2 ** n, 0, 0, 2 ** n];

/** The micro-triangle that has these corners. */
function microOf(c: Corners): Micro {
  const i = Math.min(c[0], c[2], c[4]);
  const j = Math.min(c[1], c[3], c[5]);
  const atOrigin = [0, 2, 4].some((k) => c[k] === i && c[k + 1] === j);
  return { i, j, inverted: !atOrigin };
}

/** The micro-triangle that carries an index. Domain: index in [0, 4^n), n in 0..16. */
export function microOfIndex(index: number, n: number, order: Order): Micro {
  if (order === "rows") {
    const row = Math.floor(Math.sqrt(index));
    const column = index - row * row;
    const j = Math.floor(column / 2);
    const inverted = column % 2 === 1;
    return { i: row - j - (inverted ? 1 : 0), j, inverted };
  }
  let c = whole(n);
  for (let depth = n; depth-- > 0; ) c = child(c, Math.floor(index / 4 ** depth) % 4);
  return microOf(c);
}

/** Its corners, as a person would name them: the one at the square's own corner first. */
export function cornersOf(m: Micro): Corners {
  const { i, j } = m;
  return m.inverted ? [i + 1, j + 1, i, j + 1, i + 1, j] : [i, j, i + 1, j, i, j + 1];
}
