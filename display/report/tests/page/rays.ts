// What `render` found wrong is seen at the head of the page and in its tables. The results are written here, as no run of
// ours is wrong and not every machine has Embree.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import type { Rendered, RenderPath, Views } from "../../src/data";
import { folder, open, run } from "./browser";

const tool = { version: "0", compiler: "c", flags: "f", cpu: "p", spec_hash: "0".repeat(64), embree: "Embree 3.13", width: 8, height: 4, seed: 1, threads: 1 };

const path = (differing: number): RenderPath => ({
  schema: "mmverify.bench/1", topic: "render_path", tool: { ...tool, cameras: 1, shadows: "yes" },
  file: "fence.glb", law: "traverse.same_image", verdict: differing > 0 ? "refuted" : "checked", tested: 2, tested_placed: 2, frames: 2, pixels: 64, differing,
  cameras: [{ camera: 1, tries: 1, rays: 32, shadow_rays: 5, met: 9, any_hit: 9 }],
  rows: [
    { method: "flat", level: 2, frames: 1, pixels: 32, met: 9, ignored: 3, opaque: 3, any_hit: 3, differing },
    { method: "vq2", frames: 1, pixels: 32, met: 9, ignored: 2, opaque: 2, any_hit: 5, differing: 0 },
  ],
  spreads: [{
    method: "texture", any_hit_a_ray_mean: 1, any_hit_a_ray_least: 1, any_hit_a_ray_most: 1, any_hit_a_ray_deviation: 0,
    times_texture_mean: 1, times_texture_least: 1, times_texture_most: 1, times_texture_deviation: 0,
  }],
});

const rendered = (differing: number, blended: number): Rendered => {
  const row = { candidates: 9, ignored: 0, opaque: 0, any_hit: 9, any_hit_a_ray: 0.25, known: 0, texels: 36, bytes: 64, differing: 0, ms: 1, cpu_ms: 1, times_texture: 1 };
  const blend = { candidates: 9, ignored: 3, fixed: 0, any_hit: 6, saved: 0.333, texels: 24, spoiled: 7, cpu_ms: 1, times_texture: 1.5 };
  return {
    schema: "mmverify.bench/1", topic: "render", tool: { ...tool, camera: 0, blend: "max" },
    file: "fence.glb", triangles: 2, placed: 2, tested: 2, tested_placed: 2, unplanned: 0, rays: 32, shadow_rays: 4,
    rows: [{ method: "texture", ...row }, { method: "flat", level: 2, ...row, differing }],
    blends: [{ method: "flat", level: 2, by: "shader", ...blend, differing: blended }, { method: "flat", level: 2, by: "fixed", ...blend, fixed: 3, any_hit: 3, differing: 0 }],
  };
};

const views: Views = {
  schema: "mmverify.bench/1", topic: "views", tool: { ...tool, rays: 1, shading: "lit", camera: 0 },
  file: "house.glb", triangles: 9, textured_triangles: 5, textured_pixels: 20,
  rows: [{ from: "faces", level: 2, flip: 0.125, textured_flip: 0.25, textured_rmse: 12.5, picture: "gone.png" }],
};

async function made(name: string, ...results: object[]) {
  const files = results.map((result, k) => {
    const file = `${name}-${k}.json`;
    writeFileSync(join(folder, file), JSON.stringify(result));
    return file;
  });
  run("report", ...files, "-o", `${name}.html`);
  return open(`${name}.html`);
}

test("a refuted path of cameras is seen at the head and in its table", async () => {
  const page = await made("path", path(9));
  assert.match((await page.textContent(".summary"))!, /1 result:.*1 ✗refuted/);
  assert.doesNotMatch((await page.textContent("#rays"))!, /No pixel differs/);
  assert.match((await page.textContent("#rays h3"))!, /✗refuted traverse\.same_image on fence\.glb/);
  assert.match((await page.textContent("#rays p"))!, /1 camera, 2 frames of 8 x 4, 64 pixels .* 9 pixels differ\./);
  assert.equal(await page.textContent("#rays td .wrong"), "9");
  assert.match((await page.textContent("header details"))!, /render --cameras/);
  await page.context().close();
});

test("a path that holds is checked, and one whose rays met no map was not compared", async () => {
  const held = await made("held", path(0));
  assert.match((await held.textContent(".summary"))!, /1 ≈checked/);
  assert.match((await held.textContent("#rays p"))!, /No pixel differs\./);
  await held.context().close();
  const empty = path(0);
  const vacuous = await made("vacuous", { ...empty, rows: empty.rows.map((r) => ({ ...r, met: 0 })) });
  assert.match((await vacuous.textContent(".summary"))!, /1 –not applicable/);
  assert.match((await vacuous.textContent("#rays p"))!, /nothing was compared\./);
  await vacuous.context().close();
});

test("pixels of a blend that differ are counted at the head, in words and in the table of blends", async () => {
  const page = await made("blend", rendered(0, 5));
  assert.match((await page.textContent(".summary"))!, /5 rendered pixels differ from the texture's/);
  const rays = (await page.textContent("#rays"))!;
  assert.match(rays, /5 pixels differ from the texture's, 5 of them where hits blend\./);
  assert.match(rays, /Hits that blend by max/);
  assert.match(rays, /Even rays: /);
  assert.deepEqual(await page.$$eval("#rays .scrolls:nth-of-type(n) tbody tr", (rows) => rows.map((r) => [...r.children].map((c) => c.textContent)).filter((r) => r.includes("shader"))), [
    ["flat", "2", "shader", "3", "0", "6", "33.3 %", "7", "1.5", "5"],
  ]);
  await page.context().close();
});

test("methods and blends that hold leave no verdict, and say that no pixel differs", async () => {
  const page = await made("fine", rendered(0, 0));
  assert.equal(await page.textContent(".summary"), "No verdicts: figures only.");
  assert.match((await page.textContent("#rays"))!, /No pixel of any method or blend differs from the texture's\./);
  await page.context().close();
});

test("views by attribute micromaps have their table, and a picture that is gone is named", async () => {
  const page = await made("views", views);
  assert.deepEqual(await page.$$eval("section", (all) => all.map((s) => s.id)), ["views"]);
  assert.deepEqual(await page.$$eval("#views tbody td", (all) => all.map((c) => c.textContent)), ["faces", "2", "0.125", "0.25", "12.5"]);
  assert.match((await page.textContent("#views"))!, /The picture gone\.png is not here/);
  await page.context().close();
});
