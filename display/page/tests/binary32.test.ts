// Functions judged in binary32: what each operation becomes, and which formulas that shows to be wrong.
import assert from "node:assert/strict";
import { test } from "node:test";

import { curveIndex } from "../../report/src/curve";
import { scope } from "../../../delivery/wasm/package/binary32.mjs";
import { CannotRound, inBinary32 } from "../../../delivery/wasm/package/rewrite.mjs";
import { examples } from "../src/judge/examples";
import { notAsked } from "../src/judge/not_asked";

type Index = (level: number, u: number, v: number) => number;
const ran = (text: string): any => new Function(...Object.keys(scope), inBinary32(text, "script"))(...Object.values(scope));
const plainly = (text: string): any => new Function(text)();

const { fround } = Math;
const next = (x: number, steps: number): number => {
  const words = new Int32Array(Float32Array.of(x).buffer);
  words[0]! += steps;
  return new Float32Array(words.buffer)[0]!;
};

/** The right index. Domain: numbers whose last bit is 2^-40 or more: doubles have room for their sums. */
function right(level: number, u: number, v: number): number {
  const N = 2 ** level;
  const i = Math.min(Math.floor(u * N), N - 1), j = Math.min(Math.floor(v * N), N - 1);
  const upper = u * N - i + (v * N - j) >= 1;
  if (i + j >= N) return curveIndex(N - 1 - j, j, false, level);
  return curveIndex(i, j, upper && i + j < N - 1, level);
}

/** Pairs of floats at and beside the diagonals of levels 1 to 5. */
function* pairs(): Generator<[number, number, number]> {
  let state = 1;
  const draw = (below: number): number => (state = (state * 48271) % 2147483647) % below;
  for (let level = 1; level <= 5; ++level)
    for (let k = 0; k < 4000; ++k) {
      const N = 2 ** level;
      const i = draw(N), j = draw(N - i), f = fround((1 + draw(2 ** 22)) / 2 ** 22);
      const u = fround((i + f) / N), v = next(fround((j + 1 - f) / N), draw(5) - 2);
      if (u > 0 && v > 2 ** -12 && u > 2 ** -12 && u + v <= 1) yield [level, u, v];
    }
}
function wrongPairs(index: Index): number {
  let wrong = 0;
  for (const [level, u, v] of pairs()) if (index(level, u, v) !== right(level, u, v)) ++wrong;
  return wrong;
}

test("operations are rounded, those on whole numbers are not", () => {
  assert.equal(ran("return 0.1 + 0.2"), fround(fround(0.1) + fround(0.2)));
  assert.equal(ran("return 1 / 3"), fround(1 / 3));
  assert.equal(ran("return 16777216 + 1.5"), 16777218);
  assert.equal(ran("return 8388608.5 + 8388608.5"), 16777216); // a whole sum of parts is rounded as well
  assert.equal(ran("return 2 ** 31 + 2 ** 31 + 1"), 4294967297);
  assert.equal(ran("return (0xffffffff * 3) >>> 0"), (0xffffffff * 3) >>> 0);
  assert.equal(ran("return 1e39 - 1e39"), NaN);
  assert.equal(ran("return Math.sqrt(4097 * 4097 - 2)"), 4097); // the root that misplaces an index of row order
  assert.equal(ran("return Math.PI - 3"), fround(fround(Math.PI) - 3));
  assert.equal(ran("return +'0.1'"), fround(0.1));
  assert.equal(ran("let x = 0.1; x += 0.2; x *= x; return x"), fround(fround(fround(0.1) + fround(0.2)) ** 2));
  assert.equal(ran("let x = 0.1; const y = x++; return x - y"), fround(fround(fround(0.1) + 1) - fround(0.1)));
  assert.equal(ran("const a = [1 / 3]; let k = 0; a[k++] *= 3; return [a[0], k].join()"), "1,1");
  assert.equal(ran("class A { #p = 0.1; get() { return this.#p += 0.2; } } return new A().get()"), fround(fround(0.1) + fround(0.2)));
  assert.equal(ran("let calls = 0; const o = { x: 1 }, at = () => (++calls, o); at().x += (o.x = 5, 2); return [o.x, calls].join()"), "3,1");
});

test("all else is as it was: texts, big integers, lines that end without a semicolon, keys, defaults", () => {
  for (const text of [
    "return 'a' + 1 + [2]",
    "return String(2n ** 70n + 1n)",
    "let k = 1\nconst a = k\nk += 2\n++k\nk++\nreturn [a, k].join()",
    "const { x = 0.5, 0.25: y } = { 0.25: 3 }; return [x, y].join()",
    "const f = ({ x }, y = 0.5) => x * y; return f({ x: 4 })",
    "let s = 0; for (let k = 0, n = 5; k < n; ++k) s += k; return s",
    "return (0.5).toFixed(2) + 0.5.toFixed(1) + `${1 / 4}`",
    "let a = 1; const o = [2, 4]; o[a = 0, 1] += (a++, 3); return (a, o[1]) + (o[0], a) * +(a, '7')",
    "const f = function* () { const x = 1 + (yield 2); return x * 2; }; const g = f(); g.next(); return g.next(3).value",
    "let x = 2; x **= (x, 3); return -(x ** 2) % 5",
    "let t; try { null.x } catch ({ name }) { t = name } return t",
    "const o = { a: [1, 2] }; o.a[1]--; o.b ??= 7; o?.a.push(3); return JSON.stringify(o)",
    "return [3, 1, 2].sort((a, b) => a - b).map((x) => x << 1).reduce((a, b) => a + b)",
  ])
    assert.deepEqual(ran(text), plainly(text), text);
});

test("what cannot be rounded is refused, with its line", () => {
  const refused = (text: string, words: RegExp): void =>
    assert.throws(() => inBinary32(text, "script"), (error: unknown) => error instanceof CannotRound && words.test(error.message), text);
  refused("let k = 1;\nreturn eval('k / 3');", /^line 2: eval: the arithmetic of text/);
  refused("return new Function('return 1 / 3')();", /^line 1: Function: /);
  refused("const a = 1;\n\nreturn a +* 2;", /^line 3: SyntaxError: /);
  refused("class A extends B { f() { super.x += 1; } }", /^line 1: super[.]x: write it as/);
});

test("formulas that only rounding makes wrong are wrong in binary32, and right in doubles", () => {
  const judged = (words: string): [number, number] => {
    const code = `${examples.find((e) => e.language === "JavaScript" && e.words === words)!.code}\nreturn index;`;
    return [wrongPairs(ran(code)), wrongPairs(plainly(code))];
  };
  assert.deepEqual(judged("right: Vulkan's reference, exact on floats"), [0, 0]);
  const byW = judged("wrong on floats: by w = 1 - u - v");
  assert.ok(byW[0] > 500 && byW[1] === 0, byW.join());
  const published = judged("as published: Vulkan's reference, which rounds");
  assert.ok(published[0] > 20 && published[1] === 0, published.join());
  // The same w, by assignments.
  const assigned = examples.find((e) => e.words.includes("by w"))!.code.replace("const w = 1 - u - v;", "let w = 1; w -= u; w -= v;");
  assert.ok(assigned.includes("w -= v"));
  assert.equal(wrongPairs(ran(`${assigned}\nreturn index;`)), byW[0]);
});

test("a verdict says what was not asked", () => {
  assert.deepEqual(notAsked(5, true), ["levels 6 to 16", "all other floats: of each level a million were drawn"]);
  assert.match(notAsked(5, false)[1]!, /floats beside the grid's points/);
  assert.equal(notAsked(15, true)[0], "level 16");
  assert.equal(notAsked(16, true).length, 1);
});
