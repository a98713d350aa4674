// The order of states, and what a permutation of corners makes of it, by the native program.
import assert from "node:assert/strict";
import { test } from "node:test";

import { curveIndex, permutation, withMicromaps, write } from "@mmverify/gltf-transform";

import { baked, inFolder, io, judged, native, primitivesOf, read } from "./scene.mjs";

const orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
const levels = [0, 1, 2, 3, 4, 5];
/** A number as C's %a prints it. */
function hexadecimal(text) {
  const [, whole, fraction = "", exponent] = /^0x([01])\.?([0-9a-f]*)p([+-]\d+)$/.exec(text);
  return parseInt(whole + fraction, 16) * 2 ** (Number(exponent) - 4 * fraction.length);
}

test("the index is the specification's, at a point of each micro-triangle", () => {
  for (const level of levels) {
    const cases = native(["gen", "index", "--level", String(level), "--cells", "interior"]).stdout;
    const answers = cases.trim().split("\n").map((line) => {
      if (line.startsWith("#")) return line;
      const [number, u, v] = line.split(" "), [x, y] = [u, v].map((text) => hexadecimal(text) * 2 ** level);
      const i = Math.floor(x), j = Math.floor(y);
      return `${number} ${curveIndex(i, j, x - i + y - j > 1, level)}`;
    });
    const { code, text } = native(["check", "index", "--level", String(level), "--cells", "interior"], answers.join("\n") + "\n");
    assert.equal(code, 0, text);
  }
});

test("permutations of corners are a group's: each has its inverse, and one after another is their product", () => {
  for (const level of levels)
    for (const p of orders) {
      const of = permutation(level, p);
      assert.deepEqual([...of].sort((a, b) => a - b), [...of.keys()]);
      if (p === orders[0]) assert.deepEqual([...of], [...of.keys()]);
      for (const q of orders) {
        const product = permutation(level, q.map((c) => p[c]));
        assert.deepEqual([...product], [...permutation(level, q).map((k) => of[k])], `level ${level}: ${p} then ${q}`);
      }
    }
});

/** Permutes the corners of every triangle. */
const turnAll = (order) => (document) => {
  for (const primitive of primitivesOf(document)) {
    const array = primitive.getIndices().getArray();
    primitive.getIndices().setArray(array.map((_, k) => array[k - (k % 3) + order[k % 3]]));
  }
};
for (const level of levels)
  test(`maps of level ${level} fit triangles whose corners are permuted in each of the six ways`, async () => {
    const file = baked(level);
    for (const order of orders) {
      const document = await read(file), to = inFolder("turned.glb");
      await document.transform(withMicromaps(turnAll(order)));
      await write(io, to, document);
      const { validate, check, text } = judged(to);
      assert.deepEqual([validate, check], [0, 0], `${order}: ${text}`);
    }
    // A map of level 0 looks the same from every corner.
    if (level === 0) return;
    const document = await read(file), to = inFolder("not_turned.glb");
    await document.transform(turnAll(orders[1]));
    await write(io, to, document);
    assert.equal(judged(to).check, 1);
  });
