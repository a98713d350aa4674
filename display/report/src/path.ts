// The order of visits as a line through the middles of micro-triangles: the visible part of it, as fine as can be seen.
import { child, type Corners, cornersOf, microOfIndex, type Order, whole } from "./curve";

/** A window on the base triangle in barycentrics: what may be visible. */
export interface Window {
  u0: number;
  u1: number;
  v0: number;
  v1: number;
}

export interface Line {
  /** Stretches of u, v, u, v, ...; between two of them the order runs outside the window. */
  stretches: number[][];
  /** The level whose micro-triangles the line goes through. */
  level: number;
}

/** The curve of the finest level up to n whose micro-triangles have sides of `least` barycentric units at least; row order,
 * which does not nest, of level n or, where that is too fine, not at all. */
export function line(n: number, order: Order, window: Window, least: number): Line {
  let level = n;
  while (level > 0 && 1 / 2 ** level < least) --level;
  if (order === "rows") return level < n ? { stretches: [], level: n } : { stretches: rows(n, window), level: n };
  const N = 2 ** level;
  const stretches: number[][] = [];
  let stretch: number[] | undefined;
  const visit = (c: Corners, depth: number): void => {
    const margin = depth === 0 ? 1 : 0;
    const [i0, i1] = [Math.min(c[0], c[2], c[4]) - margin, Math.max(c[0], c[2], c[4]) + margin];
    const [j0, j1] = [Math.min(c[1], c[3], c[5]) - margin, Math.max(c[1], c[3], c[5]) + margin];
    if (i1 < window.u0 * N || i0 > window.u1 * N || j1 < window.v0 * N || j0 > window.v1 * N) {
      stretch = undefined;
      return;
    }
    if (depth === 0) {
      if (!stretch) stretches.push((stretch = []));
      stretch.push((c[0] + c[2] + c[4]) / 3 / N, (c[1] + c[3] + c[5]) / 3 / N);
      return;
    }
    for (let digit = 0; digit < 4; ++digit) visit(child(c, digit), depth - 1);
  };
  visit(whole(level), level);
  return { stretches, level };
}

function rows(n: number, window: Window): number[][] {
  const N = 2 ** n;
  const stretches: number[][] = [];
  const first = Math.max(0, Math.floor((window.u0 + window.v0) * N) - 1);
  const last = Math.min(N - 1, Math.ceil((window.u1 + window.v1) * N));
  for (let row = first; row <= last; ++row) {
    const stretch: number[] = [];
    const from = Math.max(0, 2 * (Math.floor(window.v0 * N) - 1));
    const to = Math.min(2 * row, 2 * (Math.ceil(window.v1 * N) + 1));
    for (let column = from; column <= to; ++column) {
      const c = cornersOf(microOfIndex(row * row + column, n, "rows"));
      const u = (c[0] + c[2] + c[4]) / 3 / N, v = (c[1] + c[3] + c[5]) / 3 / N;
      if (u < window.u0 - 1 / N || u > window.u1 + 1 / N || v < window.v0 - 1 / N || v > window.v1 + 1 / N) continue;
      stretch.push(u, v);
    }
    if (stretch.length > 2) stretches.push(stretch);
  }
  return stretches;
}
