// Small parts: numbers in print, ticks, the front, cases, answers, rows of the table.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { mipRows, planLevelRows, planRow } from "../src/attribute_plans";
import { test } from "node:test";

import { answersOf } from "../src/answers";
import { beyondWords, countRows, measures, packedBytes, timedSeries } from "../src/attributes";
import { coordinate, differsAt, indexOfCase, mapOf, pointOf, squareOf } from "../src/cases";
import type { Rendered, RenderPath, Result, Run, SceneAttributes, Verdict } from "../src/data";
import { bytes, grouped, plural, powerOfTen, ranges, seconds, short } from "../src/format";
import { front } from "../src/front";
import { plotLook } from "../src/looks";
import { line } from "../src/path";
import { paint, toPixel, toPoint } from "../src/raster";
import { blendRows, callsByLevel, differingPixels, differingWords, rayRows } from "../src/rays";
import { pathRows, pathVerdict, pathWords } from "../src/render_path";
import { linearTicks, logTicks } from "../src/ticks";
import { below } from "../src/trade";
import { groups, levelsText } from "../src/verdicts";

test("numbers in print", () => {
  assert.equal(grouped(1234567), "1,234,567");
  assert.equal(grouped(999), "999");
  assert.equal(short(0), "0");
  assert.equal(short(0.01234), "0.0123");
  assert.equal(short(12.345), "12.3");
  assert.equal(short(123456), "123,456");
  assert.equal(short(1.5e9), "1.50e9");
  assert.equal(short(2.5e-7), "2.50e-7");
  assert.equal(seconds(0.0123), "12.3 ms");
  assert.equal(seconds(1234), "20.6 min");
  assert.equal(bytes(999), "999 B");
  assert.equal(bytes(1536), "1.54 kB");
  assert.equal(plural(1, "row"), "1 row");
  assert.equal(plural(1500, "row"), "1,500 rows");
  assert.equal(ranges([0, 1, 2, 4, 7, 8]), "0..2, 4, 7..8");
  assert.equal(ranges([]), "");
  assert.equal(powerOfTen(-7), "10⁻⁷");
});

test("ticks lie in the range and are round", () => {
  assert.deepEqual(linearTicks(0, 10, 5), [0, 2, 4, 6, 8, 10]);
  assert.deepEqual(linearTicks(0.5, 3.2, 10, true), [1, 2, 3]);
  assert.deepEqual(logTicks(0.5, 2000, 8), [1, 10, 100, 1000]);
  assert.deepEqual(logTicks(1, 20, 8), [1, 2, 5, 10, 20]);
  for (const t of logTicks(3.1, 3.2, 5)) assert.ok(t >= 3.1 && t <= 3.2);
  assert.ok(logTicks(1e-12, 1e6, 5).length <= 7);
});

test("what plots draw, too, has its colour there", () => {
  const source = (file: string) => readFileSync(`${process.env["MMVERIFY_SOURCE"]}/bench/${file}`, "utf8");
  // The page's colours are darker where white paper asks for it; the order is the palette's.
  const palette = ["blue", "vermilion", "green", "purple", "orange"];
  const scene = source("scene/attribute_picture.cpp"), bench = source("attribute/picture.cpp");
  const hue = (name: string) => palette[plotLook(name)!.colour]!;
  for (const name of ["faces", "vertices", "vertices, the nearest"])
    assert.match(scene, new RegExp(`\\.name = "${name}", \\.colour = ${hue(name)},`));
  assert.match(bench, new RegExp(`starts_with\\("W"\\) \\? ${hue("W-minor")} : order\\.starts_with\\("U"\\) \\? ${hue("U-major, batched")} : ${hue("Bird")};`));
  assert.match(bench, new RegExp(`Remap::cramer, ${hue("3x3 by Cramer")}}, {Remap::two_equations, ${hue("two equations")}}, {Remap::pattern, ${hue("pattern")}}, {Remap::ours, ${hue("ours, locates too, batched")}}`));
  assert.equal(hue("faces, packed"), hue("faces"));
  assert.notEqual(plotLook("faces, packed")!.shape, plotLook("faces")!.shape);
  assert.notDeepEqual(plotLook("vertices, Bird"), plotLook("vertices, W-minor"));
  assert.equal(plotLook("facets"), undefined);
});

test("the front is what nothing beats", () => {
  const p = (x: number, y: number) => ({ x, y });
  assert.deepEqual(front([p(3, 1), p(1, 3), p(2, 2), p(2.5, 2), p(4, 1)]), [p(1, 3), p(2, 2), p(3, 1)]);
  assert.deepEqual(front([p(1, 1), p(1, 1), p(1, 2)]), [p(1, 1), p(1, 1)]);
  assert.deepEqual(front([]), []);
  // Against the definition, on points that collide.
  const places = Array.from({ length: 200 }, (_, k) => p((k * 7919) % 13, (k * 104729) % 11));
  const beaten = (a: { x: number; y: number }) => places.some((b) => b.x <= a.x && b.y <= a.y && (b.x < a.x || b.y < a.y));
  const set = new Set(front(places));
  for (const a of places) assert.equal(set.has(a), !beaten(a));
});

test("a floor lies a decade below what there is", () => {
  assert.equal(below(0.003), 1e-4);
  assert.equal(below(0.001), 1e-4);
});

test("cases", () => {
  assert.deepEqual(pointOf("e:u=3/8,v=5/16"), { u: 0.375, v: 0.3125, uText: "3/8", vText: "5/16" });
  assert.equal(pointOf("u=0,v=1")?.v, 1);
  assert.equal(coordinate("0x1.8p-2"), 0.375);
  assert.equal(coordinate("0x1p+0"), 1);
  assert.equal(coordinate("0.25"), 0.25);
  assert.equal(coordinate("1/0"), Infinity);
  assert.equal(pointOf("u=1/0,v=0"), null);
  assert.equal(pointOf("texels=u8:2x2:00"), null);
  assert.equal(indexOfCase("k=22"), 22);
  assert.equal(mapOf("4-state:0123", 1), "0123");
  assert.equal(mapOf("4-state:0123", 2), null);
  assert.equal(squareOf("TCO".repeat(85) + "T")?.side, 16);
  assert.equal(squareOf("TCO"), null);
  assert.equal(differsAt("state 3 1"), 3);
  assert.equal(differsAt("ok"), null);
});

test("answers: a cell's representative says which cell it is", () => {
  // Level 1, in eighths: a vertex, edges of three directions, both kinds of micro-triangles.
  const wrong = [4, 0, 3, 1, 2, 0, 0, 1, 0, 2, 0, 2, 2, 2, 1, 0, 1, 1, 0, 3, 3, 3, 1, 2];
  const a = answersOf({ level: 1, cells: 19, wrong_cells: 6, wrong });
  assert.deepEqual(a.vertices, [{ i: 1, j: 0, right: 3, got: 1 }]);
  assert.deepEqual(
    a.edges.map((e) => [e.i0, e.j0, e.i1, e.j1]),
    [[0, 0, 1, 0], [0, 0, 0, 1], [1, 0, 0, 1]],
  );
  assert.deepEqual([...a.inside.values()], [{ right: 0, got: 3 }, { right: 1, got: 2 }]);
  assert.ok(a.all && a.known(0, 0));
  const part = answersOf({ level: 3, cells: 217, wrong_cells: 9, wrong: [], window: [4, 12, 0, 8] });
  assert.deepEqual([part.all, part.known(1, 0), part.known(2, 1), part.known(0, 0), part.known(3, 0), part.known(1, 2)], [false, true, true, false, false, false]);
});

test("pixels and points are each other's inverse", () => {
  const view = { x: 0.4, y: 0.3, scale: 777 };
  const [x, y] = toPixel(view, 640, 480, 0.25, 0.5);
  const [u, v] = toPoint(view, 640, 480, x, y);
  assert.ok(Math.abs(u - 0.25) < 1e-12 && Math.abs(v - 0.5) < 1e-12);
});

test("each pixel of the picture has the micro-triangle that holds its middle", () => {
  const [w, h] = [200, 180];
  const view = { x: 0.5, y: 0.43, scale: 190 };
  for (const level of [0, 1, 3, 10]) {
    const N = 2 ** level;
    const fills = [1, 2, 3, 4, 5].map((ink) => ({ pattern: "plain" as const, paper: ink, ink }));
    const kind = (i: number, j: number, inverted: boolean) => (i + 2 * j + (inverted ? 1 : 0)) % 5;
    const pixels = new Uint32Array(w * h).fill(99);
    paint(pixels, w, h, view, level, 1, fills, kind);
    let outside = 0;
    for (let y = 0; y < h; ++y)
      for (let x = 0; x < w; ++x) {
        const [u, v] = toPoint(view, w, h, x + 0.5, y + 0.5);
        const got = pixels[y * w + x]!;
        if (u < 0 || v < 0 || u + v > 1) {
          ++outside;
          assert.equal(got, 0);
          continue;
        }
        const i = Math.floor(u * N), j = Math.floor(v * N);
        const upper = u * N - i + v * N - j >= 1;
        assert.equal(got, kind(i, j, upper) + 1, `level ${level} at ${x}, ${y}`);
      }
    assert.ok(outside > 0);
  }
});

test("the line visits every micro-triangle once where all are in sight, and is coarser where they are too fine", () => {
  const all = { u0: 0, u1: 1, v0: 0, v1: 1 };
  for (const order of ["curve", "rows"] as const) {
    const found = line(4, order, all, 0.01);
    assert.equal(found.level, 4);
    assert.equal(found.stretches.reduce((sum, s) => sum + s.length / 2, 0), order === "curve" ? 256 : 255);
  }
  assert.equal(line(10, "curve", all, 1 / 64).level, 6);
  const part = line(10, "curve", { u0: 0.3, u1: 0.31, v0: 0.3, v1: 0.31 }, 1e-4);
  const points = part.stretches.reduce((sum, s) => sum + s.length / 2, 0);
  assert.ok(points >= 200 && points < 800, `${points}`);
});

test("a group is as weak as its weakest level", () => {
  const result = (level: number, verdict: Verdict): Result => ({
    law: "index.nested", topic: "index", subject: "step", level, method: "exhaustive", domain: "cells", verdict,
    cases_expected: 7, cases_run: verdict === "not_applicable" ? 0 : 7, mismatches: 0, counterexample: null, seconds: 1,
    by_kind: { vertex: { cases: 7, mismatches: 0 }, edge: { cases: 0, mismatches: 0 }, interior: { cases: 0, mismatches: 0 } },
    digest: "0123456789abcdef",
  });
  const run = (...verdicts: Verdict[]): Run => ({
    file: 0,
    name: "a.json",
    content: {
      schema: "mmverify.result/1",
      tool: { version: "0", compiler: "", flags: "", cpu: "", threads: 1, seed: 1, spec_hash: "" },
      results: verdicts.map((v, level) => result(level, v)),
    },
  });
  assert.equal(groups([run("proved", "refuted", "checked")])[0]!.verdict, "refuted");
  assert.equal(groups([run("proved", "checked")])[0]!.verdict, "checked");
  assert.equal(groups([run("proved", "not_applicable")])[0]!.verdict, "proved");
  assert.equal(groups([run("not_applicable", "not_applicable")])[0]!.verdict, "not_applicable");
  assert.equal(levelsText(groups([run("proved", "proved", "proved")])[0]!), "0..2");
});

test("attribute maps: counts, packed bytes, the level beyond the textures", () => {
  const maps = (level: number, set: string, n: number, packed?: number) => {
    const at = (values: number) => ({
      maps: n, constant: 1, bytes: 4 * values * n, of_textures: 1, rmse: 1, unseen: 0, nearest_rmse: 2,
      ...(packed === undefined ? {} : { packed: { plain: 9, bytes: packed, of_plain: packed / 9, entropy: 1, zstd: 1, worst_error: 0, rms_error: 0 } }),
    });
    return { set, level, faces: at(4 ** level), vertices: at(((2 ** level + 1) * (2 ** level + 2)) / 2) };
  };
  const total = (level: number) => ({ level, faces: { bytes: 1, of_textures: 1 }, vertices: { bytes: 1, of_textures: 1 } });
  const run: SceneAttributes = {
    schema: "mmverify.bench/1", topic: "scene_attributes",
    tool: { version: "0", compiler: "c", flags: "", cpu: "", averaging: "light and directions", spec_hash: "0" },
    file: "a.glb", triangles: 2000, images: 2, texture_bytes: 64, far: 0, beyond_textures: { faces: 2, faces_found: "reckoned", vertices: 17, vertices_found: "reckoned" },
    sets: ["baseColor", "normal"].map((set) => ({ set, triangles: 2000, images: 1, texture_bytes: 32, shown: 1 })),
    rows: [maps(0, "baseColor", 10, 5), maps(1, "baseColor", 1999, 6), maps(0, "normal", 7, 8), maps(1, "normal", 2000)],
    totals: [total(0), total(1)],
  };
  assert.deepEqual(countRows(run)[0], ["baseColor", "faces", "2,000", "10..1,999", "1,990..1", "1..1"]);
  assert.equal(countRows(run).length, 4);
  // Of the two measures RMSE alone is known here; the other set has its own times.
  const of = (map_ns: number) => ({ texture_ns: 8, map_ns, map_to_texture: map_ns / 8 });
  assert.deepEqual(timedSeries(run, "baseColor", measures[1]!), []);
  run.times = [["baseColor", 0, "faces"], ["baseColor", 0, "vertices, Bird"], ["baseColor", 1, "faces"], ["normal", 0, "faces"]].map(
    ([set, level, maps], k) => ({ set, level, maps, points: 5, scattered: of(100), along: of(k + 1) }) as NonNullable<SceneAttributes["times"]>[number]);
  assert.deepEqual(timedSeries(run, "baseColor", measures[0]!), []);
  assert.deepEqual(
    timedSeries(run, "baseColor", measures[1]!).map((s) => [s.name, s.marks.map((m) => [m.x, m.y, m.words[1]])]),
    [["faces", [[1, 1, "1 ns, 0.125 of the texture's"], [3, 1, "3 ns, 0.375 of the texture's"]]], ["vertices, Bird", [[2, 1, "2 ns, 0.25 of the texture's"]]]],
  );
  assert.equal(packedBytes(run, 0, "faces"), 5 + 8);
  assert.equal(packedBytes(run, 1, "faces"), undefined);
  assert.match(beyondWords(run, "faces"), /^Maps of faces would take more than the textures from level 2 on, if they stayed as many as at level 1\.$/);
  assert.match(beyondWords(run, "vertices"), /^Maps of vertices would take less than the textures at all levels up to 16/);
  run.beyond_textures.faces = 1;
  assert.equal(beyondWords(run, "faces"), "Maps of faces take more than the textures from level 1 on.");
});

test("plans and mips of attributes: a row each, and nothing where nothing is known", () => {
  const plan = { set: "baseColor", kind: "faces", wanted: 2, triangles: 2000, special: 1500, palette: 3, maps: 400, shared: 100, not_kept: 1, value_bytes: 1612, bytes: 11612 } as const;
  assert.deepEqual(planRow(plan), ["faces", "2", "1,500", "400", "1", "11,612", "", "", "", "", "", "", ""]);
  assert.deepEqual(
    planRow({ ...plan, rmse: 1.5, flip: 0.25, uniform: { level: 1, rmse: 1.25, bytes: 23224, plan_to_it: 0.5 }, equal_rmse: { bytes: 46448, plan_to_it: 0.25 } }).slice(6),
    ["1.5", "0.25", "1", "23,224", "0.5", "0.25", ""],
  );
  const at = (kind: "faces" | "vertices", level: number, planned: number) => ({ set: "baseColor", kind, wanted: 2, level, lowest: planned, planned, decimated: 0, maps: planned });
  const run = { plans: [plan, { ...plan, kind: "vertices" }], plan_levels: [at("vertices", 1, 7), at("faces", 1, 5), at("faces", 0, 6), at("vertices", 0, 8)] } as unknown as SceneAttributes;
  assert.deepEqual(planLevelRows(run, "baseColor"), { levels: [0, 1], rows: [["faces", "2", "1,500", "6", "5"], ["vertices", "2", "1,500", "8", "7"]] });
  assert.deepEqual(planLevelRows(run, "normal"), { levels: [], rows: [] });
  const maps = (level: number) => ({ level, values_per_texel: 0.5, rmse: 2, interior_rmse: 3 });
  assert.deepEqual(mipRows({ set: "normal", mip: 1, border: 0, texture: { rmse: 1, flip: 0.5, border_rmse: 4 }, faces: maps(2), vertices: maps(3) }), [
    ["1", "texture", "0.25", "1", "0.5", "4", ""], ["1", "faces, level 2", "0.5", "2", "", "", "3"], ["1", "vertices, level 3", "0.5", "2", "", "", "3"],
  ]);
});

test("rays: a line a method, flat where it has no level; one level draws none", () => {
  const row = (method: string, level: number | undefined, any_hit: number) => ({
    method, ...(level === undefined ? {} : { level, predicted: 0.5, even: 0.25 }), candidates: 40, ignored: 40 - any_hit, opaque: 0, any_hit,
    any_hit_a_ray: any_hit / 20, known: 1 - any_hit / 40, texels: 4 * any_hit, bytes: 100, differing: 0, ms: 1, cpu_ms: 1, times_texture: 1,
  }) as Rendered["rows"][number];
  const run: Rendered = {
    schema: "mmverify.bench/1", topic: "render",
    tool: { version: "0", compiler: "c", flags: "", cpu: "", embree: "Embree 3", width: 4, height: 4, camera: 0, seed: 1, threads: 0, spec_hash: "0" },
    file: "a.glb", triangles: 2, placed: 2, tested: 2, tested_placed: 2, unplanned: 0, rays: 16, shadow_rays: 4,
    rows: [row("texture", undefined, 40), row("flat", 1, 20), row("flat", 2, 10)],
  };
  assert.deepEqual(callsByLevel(run).map((s) => [s.name, s.dashed, s.marks.map((m) => [m.x, m.y])]), [["texture", true, [[1, 2], [2, 2]]], ["flat", false, [[1, 1], [2, 0.5]]]]);
  assert.deepEqual(rayRows(run)[1]!.slice(0, 3), ["flat", "1", "20"]);
  assert.deepEqual(callsByLevel({ ...run, rows: run.rows.slice(0, 2) }), []);
  assert.equal(differingWords(run), "No pixel of any method differs from the texture's.");
  assert.equal(differingWords({ ...run, rows: run.rows.slice(0, 1) }), "Nothing was held against the texture.");
  const blend = { method: "flat", level: 2, by: "fixed", candidates: 40, ignored: 10, fixed: 20, any_hit: 10, saved: 0.75, texels: 40, differing: 5, spoiled: 3, cpu_ms: 1, times_texture: 1.5 } as const;
  const blended: Rendered = { ...run, rows: [...run.rows, { ...run.rows[1]!, differing: 2 }], blends: [blend] };
  assert.equal(differingPixels(blended), 7);
  assert.equal(differingWords(blended), "7 pixels differ from the texture's, 5 of them where hits blend.");
  assert.deepEqual(blendRows(blended), [["flat", "2", "fixed function", "10", "20", "10", "75 %", "3", "1.5", "5"]]);
});

test("a path of cameras is refuted where a pixel differs, and compares nothing where no ray met a map", () => {
  const run: RenderPath = {
    schema: "mmverify.bench/1", topic: "render_path",
    tool: { version: "0", compiler: "c", flags: "", cpu: "", spec_hash: "0", embree: "Embree 3", width: 4, height: 4, cameras: 1, seed: 1, shadows: "no", threads: 0 },
    file: "a.glb", law: "traverse.same_image", verdict: "checked", tested: 2, tested_placed: 2, frames: 1, pixels: 16, differing: 0,
    cameras: [{ camera: 1, tries: 1, rays: 16, shadow_rays: 0, met: 3, any_hit: 3 }],
    rows: [{ method: "flat", level: 1, frames: 1, pixels: 16, met: 3, ignored: 1, opaque: 1, any_hit: 1, differing: 0 }],
    spreads: [{
    method: "texture", any_hit_a_ray_mean: 1, any_hit_a_ray_least: 1, any_hit_a_ray_most: 1, any_hit_a_ray_deviation: 0,
    times_texture_mean: 1, times_texture_least: 1, times_texture_most: 1, times_texture_deviation: 0,
  }],
  };
  const row = run.rows[0]!;
  assert.equal(pathVerdict(run), "checked");
  assert.match(pathWords(run), /1 camera, 1 frame of 4 x 4, 16 pixels .* without shadow rays, .* No pixel differs\.$/);
  assert.equal(pathVerdict({ ...run, rows: [{ ...row, met: 0 }] }), "not_applicable");
  assert.equal(pathVerdict({ ...run, rows: [] }), "not_applicable");
  const wrong: RenderPath = { ...run, verdict: "refuted", differing: 1, rows: [{ ...row, differing: 1 }] };
  assert.equal(pathVerdict(wrong), "refuted");
  assert.match(pathWords(wrong), / 1 pixel differs\.$/);
  assert.deepEqual(pathRows(wrong), [["flat", "1", "1", "16", "3", "1", "1", "1", "1"]]);
});
