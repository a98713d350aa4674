// The page's curve, by what it must be and not by how it is computed.
import assert from "node:assert/strict";
import { test } from "node:test";

import { cornersOf, curveIndex, indexOf, type Micro, microAt, microOfIndex, rowIndex } from "../src/curve";

function* micros(n: number): Generator<Micro> {
  const N = 2 ** n;
  for (let j = 0; j < N; ++j)
    for (let i = 0; i + j < N; ++i) {
      yield { i, j, inverted: false };
      if (i + j + 1 < N) yield { i, j, inverted: true };
    }
}

const vertices = (m: Micro): string[] => {
  const c = cornersOf(m);
  return [0, 2, 4].map((k) => `${c[k]},${c[k + 1]}`);
};

for (const order of ["curve", "rows"] as const)
  test(`each index of levels 0..6 belongs to one micro-triangle, in order ${order}`, () => {
    for (let n = 0; n <= 6; ++n) {
      const seen = new Set<number>();
      for (const m of micros(n)) {
        const k = indexOf(m, n, order);
        assert.ok(k >= 0 && k < 4 ** n && Number.isInteger(k));
        seen.add(k);
        assert.deepEqual(microOfIndex(k, n, order), m);
      }
      assert.equal(seen.size, 4 ** n);
    }
  });

test("consecutive micro-triangles share an edge, but (4^n - 1)/3 pairs, which share a vertex", () => {
  for (let n = 1; n <= 6; ++n) {
    let vertex = 0;
    for (let k = 0; k + 1 < 4 ** n; ++k) {
      const a = vertices(microOfIndex(k, n, "curve"));
      const shared = vertices(microOfIndex(k + 1, n, "curve")).filter((v) => a.includes(v)).length;
      assert.ok(shared === 1 || shared === 2, `level ${n}, ${k}: ${shared}`);
      if (shared === 1) ++vertex;
    }
    assert.equal(vertex, (4 ** n - 1) / 3);
  }
});

test("the index divided by 4 is that of the level above", () => {
  for (let n = 0; n < 6; ++n)
    for (const m of micros(n + 1)) {
      // A point inside it, and the micro-triangle of the level above that holds the point.
      const N = 2 ** (n + 1);
      const inside = m.inverted ? 0.75 : 0.25;
      const above = microAt((m.i + inside) / N, (m.j + inside) / N, n);
      assert.equal(Math.floor(indexOf(m, n + 1, "curve") / 4), indexOf(above, n, "curve"));
    }
});

test("the curve goes from the w-corner to the v-corner, and rows from w up", () => {
  for (let n = 0; n <= 16; ++n) {
    assert.equal(curveIndex(0, 0, false, n), 0);
    assert.equal(curveIndex(0, 2 ** n - 1, false, n), 4 ** n - 1);
    assert.equal(rowIndex(0, 2 ** n - 1, false), 4 ** n - 1);
  }
});

test("points on grid lines go where the counterexamples of the README say", () => {
  const at = (u: number, v: number, n: number) => indexOf(microAt(u, v, n), n, "curve");
  assert.equal(at(3 / 8, 3 / 8, 2), 6);
  assert.equal(at(3 / 8, 1 / 4, 3), 22);
  assert.equal(at(3 / 8, 5 / 16, 3), 22);
  // On the hypotenuse there is nobody above.
  assert.equal(at(1, 0, 4), at(1 - 1 / 64, 1 / 128, 4));
  assert.equal(at(0, 1, 4), 4 ** 4 - 1);
});
