// A round leaf on the triangle: what each micro-triangle may be called, exactly.
import { cornersOf, type Micro } from "../../../report/src/curve";
import { slope } from "../../../report/src/raster";

/** Middle and radius, in the plane in which the base triangle has sides of 1. */
export const leaf = { x: 0.53, y: 0.3, r: 0.247 };

export type State = 0 | 1 | 2 | 3;
export const states = { transparent: 0, opaque: 1, unknownTransparent: 2, unknownOpaque: 3 } as const;

const plane = (u: number, v: number): [number, number] => [u + v / 2, v * slope];

/** How far the leaf's middle is from the segment. */
function toSegment([ax, ay]: [number, number], [bx, by]: [number, number]): number {
  const [dx, dy] = [bx - ax, by - ay];
  const t = Math.max(0, Math.min(1, ((leaf.x - ax) * dx + (leaf.y - ay) * dy) / (dx * dx + dy * dy)));
  return Math.hypot(ax + t * dx - leaf.x, ay + t * dy - leaf.y);
}

function cornersIn(m: Micro, level: number): [number, number][] {
  const N = 2 ** level;
  const c = cornersOf(m);
  return [0, 2, 4].map((k) => plane(c[k]! / N, c[k + 1]! / N));
}

/** Whether the middle of the micro-triangle is on the leaf. */
export function centreOnLeaf(m: Micro, level: number): boolean {
  const corners = cornersIn(m, level);
  const [x, y] = [0, 1].map((k) => corners.reduce((sum, c) => sum + c[k]! / 3, 0)) as [number, number];
  return Math.hypot(x - leaf.x, y - leaf.y) < leaf.r;
}

/** Opaque: all of it is on the leaf. Transparent: none. Else unknown, on the side of its middle. */
export function stateByRule(m: Micro, level: number): State {
  const corners = cornersIn(m, level);
  if (corners.every(([x, y]) => Math.hypot(x - leaf.x, y - leaf.y) <= leaf.r)) return states.opaque;
  const nearest = Math.min(...corners.map((c, k) => toSegment(c, corners[(k + 1) % 3]!)));
  const [a, b, c] = corners as [[number, number], [number, number], [number, number]];
  const side = (p: [number, number], q: [number, number]): number => (q[0] - p[0]) * (leaf.y - p[1]) - (q[1] - p[1]) * (leaf.x - p[0]);
  const signs = [side(a, b), side(b, c), side(c, a)];
  const holds = signs.every((s) => s >= 0) || signs.every((s) => s <= 0);
  if (nearest >= leaf.r && !holds) return states.transparent;
  return centreOnLeaf(m, level) ? states.unknownOpaque : states.unknownTransparent;
}

export const stateByCentre = (m: Micro, level: number): State => (centreOnLeaf(m, level) ? states.opaque : states.transparent);
