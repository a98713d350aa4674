// The cells of a level, asked of an index function one by one.
import { curveIndex, microAt } from "../../../report/src/curve";
import type { WrongCells } from "./messages";

/** Every cell's representative, as 4N u and 4N v: vertices, edges, both kinds of micro-triangles; 3N^2 + 3N + 1 of them. */
export function* representatives(level: number): Generator<[number, number]> {
  const N = 2 ** level;
  for (let j = 0; j <= N; ++j)
    for (let i = 0; i + j <= N; ++i) {
      yield [4 * i, 4 * j];
      if (i + j === N) continue;
      yield [4 * i + 2, 4 * j];
      yield [4 * i, 4 * j + 2];
      yield [4 * i + 2, 4 * j + 2];
      yield [4 * i + 1, 4 * j + 1];
      if (i + j < N - 1) yield [4 * i + 3, 4 * j + 3];
    }
}

/** The index that Vulkan's reference gives to the point ku / 4N, kv / 4N. */
export function rightIndex(ku: number, kv: number, level: number): number {
  const quarters = 4 * 2 ** level;
  const m = microAt(ku / quarters, kv / quarters, level);
  return curveIndex(m.i, m.j, m.inverted, level);
}

export function wrongCells(level: number, answer: (u: number, v: number) => number): WrongCells {
  const quarters = 4 * 2 ** level;
  const found: WrongCells = { level, cells: 0, wrong_cells: 0, wrong: [] };
  for (const [ku, kv] of representatives(level)) {
    ++found.cells;
    const right = rightIndex(ku, kv, level);
    const got = answer(ku / quarters, kv / quarters) >>> 0;
    if (got === right) continue;
    ++found.wrong_cells;
    found.wrong.push(ku, kv, right, got);
  }
  return found;
}
