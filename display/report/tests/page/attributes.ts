// The section of attribute micromaps.
import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { folder, open, run } from "./browser";

test("attributes: counts, a footprint, errors and pictures are those of the file", async () => {
  const run = JSON.parse(readFileSync(join(folder, "attributes.json"), "utf8"));
  const grouped = (n: number) => n.toLocaleString("en-US");
  const page = await open("all.html");
  const section = page.locator("#attributes");
  const counts = await section.locator("table").first().locator("tbody tr").allTextContents();
  const of = run.rows.map((r: { faces: { maps: number } }) => r.faces.maps);
  assert.equal(counts.length, 2);
  assert.ok(counts[0]!.startsWith(`baseColorfaces${run.sets[0].triangles}${of[0]}..${of.at(-1)}`), counts[0]);
  assert.deepEqual(await section.locator("figcaption").allTextContents().then((all) => all.slice(0, 7)), [
    "Bytes of all maps by level", "FLIP of baseColor by level", "RMSE of baseColor by level", "FLIP of baseColor against bytes", "RMSE of baseColor against bytes",
    "FLIP of baseColor against the time of a lookup", "RMSE of baseColor against the time of a lookup",
  ]);
  const said = async (chart: number, key: string) => {
    const plot = section.locator(".plot").nth(chart);
    await plot.focus();
    await page.keyboard.press(key);
    return (await plot.locator(".tip").textContent())!;
  };
  // From the left: level 1, where faces packed take the least.
  assert.match(await said(0, "ArrowRight"), new RegExp(`^faces, packedlevel 1${run.rows[0].faces.packed.bytes} B`));
  assert.match(await said(1, "ArrowRight"), /level 1FLIP 0\.\d/);
  await section.locator("summary", { hasText: "The numbers" }).click();
  const last = (await section.locator("details tbody tr").last().allTextContents())[0]!;
  assert.ok(last.startsWith(`3vertices${run.rows[2].vertices.maps}`) && last.includes(grouped(run.rows[2].vertices.bytes)), last);
  assert.equal((await section.locator("table", { hasText: "bytes of packed maps" }).locator("tbody tr").allTextContents()).length, 6);

  const timed = await section.locator("table", { hasText: "the time of a lookup" }).locator("tbody tr").allTextContents();
  assert.equal(timed.length, 9);
  assert.match(timed[8]!, /^3vertices, Bird262,144[\d.]+/);

  const planned = await section.locator("table", { hasText: "levels as triangles need them" }).locator("tbody tr").allTextContents();
  assert.equal(planned.length, 4);
  assert.ok(planned[3]!.startsWith(`vertices40${run.plans[3].special}${run.plans[3].maps}`), planned[3]);
  const mips = await section.locator("table", { hasText: "what bleeds across charts" }).locator("tbody tr").allTextContents();
  assert.equal(mips.length, 9);
  assert.ok(mips[1]!.startsWith(`0faces, level ${run.mips[0].faces.level}`), mips[1]);

  const picture = section.locator("img");
  const shown = async () => [await picture.getAttribute("alt"), createHash("sha256").update((await picture.getAttribute("src"))!).digest("hex")] as const;
  const [words, first] = await shown();
  assert.match(words!, /at level 1: above the texture/);
  assert.ok(await picture.evaluate((img) => (img as HTMLImageElement).naturalWidth > 100));
  await section.getByLabel("Level of the picture").selectOption("3");
  assert.notEqual((await shown())[1], first);
  await section.getByLabel("Image").selectOption("leaves");
  assert.match((await shown())[0]!, /^leaves at level 1/);
  await page.context().close();
});

test("a picture that is gone is named, and the page is made", async () => {
  const run1 = JSON.parse(readFileSync(join(folder, "attributes.json"), "utf8"));
  for (const picture of run1.pictures) picture.file = "no such folder/x.png";
  writeFileSync(join(folder, "gone.json"), JSON.stringify(run1));
  run("report", "gone.json", "-o", "gone.html");
  const page = await open("gone.html");
  assert.deepEqual(await page.$$eval("section", (all) => all.map((s) => s.id)), ["attributes"]);
  assert.match((await page.textContent("#attributes"))!, /The picture of level 1 is not here: no such folder\/x\.png: /);
  assert.equal(await page.$("#attributes img"), null);
  await page.context().close();
});
