// Which micro-triangles a point touches: two on an edge, up to six at a vertex. More than one is a tie.
import { type Micro } from "../../../report/src/curve";
import type { At } from "./steps";

/** All micro-triangles whose closed triangle holds the point. */
export function touching(at: At, level: number): Micro[] {
  const N = 2 ** level;
  const [a, b] = [at.ku, at.kv];
  const found: Micro[] = [];
  const [i0, j0] = [Math.floor(a / 4), Math.floor(b / 4)];
  for (let j = j0 - 1; j <= j0; ++j)
    for (let i = i0 - 1; i <= i0; ++i) {
      if (i < 0 || j < 0) continue;
      const [x, y] = [a - 4 * i, b - 4 * j];
      if (x > 4 || y > 4) continue;
      if (x + y <= 4 && i + j <= N - 1) found.push({ i, j, inverted: false });
      if (x + y >= 4 && i + j <= N - 2) found.push({ i, j, inverted: true });
    }
  return found;
}

/** What the point lies on. */
export function placeOf(at: At): "vertex" | "edge" | "inside" {
  const [a, b] = [at.ku % 4, at.kv % 4];
  if (a === 0 && b === 0) return "vertex";
  return a === 0 || b === 0 || (a + b) % 4 === 0 ? "edge" : "inside";
}
