// The parts of the page, by what they must be and not by how they are computed.
import assert from "node:assert/strict";
import { test } from "node:test";

import { cornersOf, curveIndex, indexOf, microOfIndex } from "../../report/src/curve";
import { pointsOf, wrongAnswers } from "../src/judge/answers_text";
import { smallLevels, whyNotHere } from "../src/laws/law";
import { digits, formula } from "../src/learn/formula";
import { leaf, stateByRule, states } from "../src/learn/half_covered";
import { coordinates } from "../src/learn/order_ground";
import { rowPlace } from "../src/learn/rows";
import { representatives, rightIndex, wrongCells } from "../src/program/cells";
import { Table } from "../src/program/table";
import { readMaps } from "../src/scene/read_maps";
import { atLevel, microOf, microStep, orderStep, quarterStep } from "../src/walk/steps";
import { placeOf, touching } from "../src/walk/touching";

test("a level has 3N^2 + 3N + 1 cells, each once", () => {
  for (let n = 0; n <= 5; ++n) {
    const N = 2 ** n;
    const all = [...representatives(n)].map(([ku, kv]) => `${ku} ${kv}`);
    assert.equal(all.length, 3 * N * N + 3 * N + 1);
    assert.equal(new Set(all).size, all.length);
  }
});

test("a right function has no wrong cells, one that is wrong at a vertex has one", () => {
  const right = (u: number, v: number) => rightIndex(u * 32, v * 32, 3);
  assert.deepEqual(wrongCells(3, right).wrong, []);
  const once = wrongCells(3, (u, v) => (u === 0.5 && v === 0.25 ? 0 : right(u, v)));
  assert.equal(once.cells, 217);
  assert.deepEqual(once.wrong, [16, 8, rightIndex(16, 8, 3), 0]);
});

test("a point touches as many micro-triangles as its place says", () => {
  const n = 3, N = 8;
  for (const [ku, kv] of representatives(n)) {
    const at = { ku, kv };
    const all = touching(at, n);
    const border = ku === 0 || kv === 0 || ku + kv === 4 * N;
    const place = placeOf(at);
    if (place === "inside") assert.equal(all.length, 1);
    if (place === "edge") assert.equal(all.length, border ? 1 : 2);
    if (place === "vertex") assert.ok(border ? all.length === 1 || all.length === 3 : all.length === 6);
    // The one that the reference chooses is among them, and so is figure 4's in row order.
    const among = (k: number, order: "curve" | "rows") => all.some((m) => indexOf(m, n, order) === k);
    assert.ok(among(rightIndex(ku, kv, n), "curve"));
    assert.ok(among(rowPlace(at, n).index, "rows"), `${ku} ${kv}`);
  }
});

test("Vulkan's formula, written out, ends at the curve's index, and its digits are the path down", () => {
  for (let n = 0; n <= 4; ++n)
    for (const [ku, kv] of representatives(n)) {
      const index = rightIndex(ku, kv, n);
      const steps = formula({ ku, kv }, n);
      const bits = (name: string) => (n === 0 ? "" : steps.find((s) => s.name === name)!.value);
      const [b0, b1] = [bits("b0"), bits("b1")];
      const spelled = [...b0].reduce((x, bit, k) => 4 * x + 2 * Number(b1[k]) + Number(bit), 0);
      assert.equal(spelled, index);
      assert.equal(steps.at(-1)!.value, String(index));
      const path = digits({ ku, kv }, n);
      assert.equal(path.reduce((x, d) => 4 * x + d, 0), index);
      // What is said of b0, t and b1.
      path.forEach((d, k) => {
        assert.equal(b0[k], d % 2 === 1 ? "1" : "0");
        assert.equal(b1[k], d >= 2 ? "1" : "0");
        assert.equal(bits("t")[k], d === 3 ? "1" : "0");
      });
    }
});

test("the leaf's states hold for points of each micro-triangle", () => {
  const slope = Math.sqrt(3) / 2;
  for (let n = 0; n <= 5; ++n) {
    const seen = new Set<number>();
    for (let k = 0; k < 4 ** n; ++k) {
      const m = microOfIndex(k, n, "curve");
      const c = cornersOf(m), N = 2 ** n;
      let on = 0, off = 0;
      for (let a = 0; a <= 12; ++a)
        for (let b = 0; a + b <= 12; ++b) {
          const w = [a / 12, b / 12, (12 - a - b) / 12];
          const u = (w[0]! * c[0] + w[1]! * c[2] + w[2]! * c[4]) / N, v = (w[0]! * c[1] + w[1]! * c[3] + w[2]! * c[5]) / N;
          if (Math.hypot(u + v / 2 - leaf.x, v * slope - leaf.y) < leaf.r) ++on;
          else ++off;
        }
      const state = stateByRule(m, n);
      seen.add(state);
      if (state === states.opaque) assert.equal(off, 0);
      if (state === states.transparent) assert.equal(on, 0);
      if (on > 0 && off > 0) assert.ok(state === states.unknownOpaque || state === states.unknownTransparent);
    }
    if (n >= 3) assert.equal(seen.size, 4);
  }
});

test("steps stay on the triangle and reach all of it", () => {
  const n = 3;
  const reach = (step: typeof microStep, start: { ku: number; kv: number }, key: (at: { ku: number; kv: number }) => string) => {
    const seen = new Map([[key(start), start]]);
    for (const at of seen.values())
      for (const arrow of ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"]) {
        const next = step(at, arrow, n)!;
        assert.ok(next.ku >= 0 && next.kv >= 0 && next.ku + next.kv <= 32);
        if (!seen.has(key(next))) seen.set(key(next), next);
      }
    return seen.size;
  };
  const indexAt = (at: { ku: number; kv: number }) => String(rightIndex(at.ku, at.kv, n));
  assert.equal(reach(microStep, { ku: 1, kv: 1 }, indexAt), 64);
  assert.equal(reach(quarterStep, { ku: 0, kv: 0 }, (at) => `${at.ku} ${at.kv}`), (33 * 34) / 2);
  assert.equal(quarterStep({ ku: 0, kv: 0 }, "x", n), null);
  let at = { ku: 1, kv: 1 };
  for (let k = 1; k < 64; ++k) {
    at = orderStep(at, 1, n, "curve");
    const m = microOf(at, n);
    assert.equal(curveIndex(m.i, m.j, m.inverted, n), k);
  }
  assert.deepEqual(orderStep(at, 1, n, "curve"), at);
  assert.deepEqual(atLevel(atLevel({ ku: 5, kv: 6 }, 3, 5), 5, 3), { ku: 5, kv: 6 });
  assert.equal(coordinates({ ku: 6, kv: 4 }, 2), "u 3/8, v 1/4, w 3/8");
});

test("a table answers what it has and names what it lacks", () => {
  const table = new Table([{ level: 1, u: Float32Array.of(0.25), v: Float32Array.of(0.5), index: Uint32Array.of(77) }]);
  assert.equal(table.answer(1, 0.25, 0.5), 77);
  assert.deepEqual(table.missing(), []);
  assert.equal(table.answer(1, 0, 0), 0);
  table.answer(1, 0, 0);
  assert.deepEqual(table.missing(), [{ level: 1, u: Float32Array.of(0), v: Float32Array.of(0) }]);
});

test("answers as text: comments and nonsense are passed over, wrong ones are found", () => {
  const points = "# mmverify index level 1 cases 3\n0 0x0p+0 0x0p+0\n1 0x1p-1 0x0p+0\n2 0x1p-3 0x1p-3\n";
  assert.deepEqual(pointsOf(points).get(1), { u: 0.5, v: 0 });
  const found = wrongAnswers(points, "# mine\n0 0\n1 3\n2 zero\n9 1\n", 1);
  assert.deepEqual(found, { level: 1, cells: 3, wrong_cells: 1, wrong: [4, 0, 2, 3] });
});

test("laws of a prover and laws without a fast tier are not for a page", () => {
  const law = { law: "a.b", topic: "a", statement: "", source: "", domain: "", method: "exhaustive", subjects: [], companion: null, tiers: { fast: { levels: "2..9", expected_seconds: 1 }, long: null }, mutants: [] };
  assert.equal(whyNotHere(law), null);
  assert.equal(smallLevels(law), "2..4");
  assert.equal(smallLevels({ ...law, tiers: { fast: { levels: "5..5", expected_seconds: 1 }, long: null } }), "5..5");
  assert.equal(smallLevels({ ...law, tiers: { fast: { levels: "all levels", expected_seconds: 1 }, long: null } }), null);
  assert.match(whyNotHere({ ...law, method: "induction" })!, /z3/);
  assert.match(whyNotHere({ ...law, tiers: { fast: null, long: { levels: "0..16" } } })!, /long tier/);
});

test("what is no .glb has no micromaps, and no bytes make the reader throw", () => {
  assert.deepEqual(readMaps(new Uint8Array()), []);
  assert.deepEqual(readMaps(new TextEncoder().encode("not a scene, but longer than a header")), []);
  const header = new DataView(new ArrayBuffer(28));
  header.setUint32(0, 0x46546c67, true);
  header.setUint32(12, 0xffffffff, true);
  header.setUint32(16, 0x4e4f534a, true);
  assert.deepEqual(readMaps(new Uint8Array(header.buffer)), []);
});
