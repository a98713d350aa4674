// A scene, dropped.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { before, test } from "node:test";

import { percent } from "../../../report/src/format";
import { done, drop, folder, native, open, verdictsIn } from "./browser";

const json = (name: string) => JSON.parse(readFileSync(join(folder, name), "utf8"));

before(() => {
  native("scene", "-o", "garden.glb", "--samples", "200", "--quiet");
  native("scene", "garden.glb", "--samples", "200", "--sizes", "1..4", "--quiet", "--json", "garden.json");
  // A usage count that the records do not bear out: the finding's code is the native program's.
  const file = readFileSync(join(folder, "garden.glb"));
  const text = file.toString("latin1").replace(/("usageCounts":\[)(\d)/, (_, head: string, digit: string) => `${head}${digit === "9" ? 8 : Number(digit) + 1}`);
  writeFileSync(join(folder, "broken.glb"), Buffer.from(text, "latin1"));
  native("validate", "broken.glb", "--json", "broken.json");
});

test("a dropped .glb: findings, plan, footprint, savings, micromaps; the figures are the native program's", async () => {
  const page = await open();
  const section = page.locator("#scene");
  await drop(page, ".drop", { name: "garden.glb", bytes: readFileSync(join(folder, "garden.glb")) });
  await done(section);
  const text = (await section.textContent())!;
  assert.match(text, /gltf \(draft ext-2\): 0 errors, 0 warnings/);
  const { plan, footprint, vq2 } = json("garden.json").scene;
  assert.ok(text.includes(`${plan.triangles} triangles, ${plan.triangles_placed} as nodes place them`));
  assert.ok(text.includes(`${footprint.micromaps} micromaps, ${footprint.special_indices} special indices`));
  // What an encoder makes of it: a compiler's mistake would show here.
  assert.ok(text.includes(percent(1 - (vq2.unknown + vq2.substitutions) / vq2.regions)));
  assert.equal(await section.locator(".plot canvas").count(), 2);
  const verdicts = Object.values(await verdictsIn(section));
  assert.ok(verdicts.length >= 5 && verdicts.every((v) => v === "proved" || v === "checked"));
  // Its own maps, and those baked here: as many as there are records.
  const maps = section.locator(".maps");
  assert.equal(await maps.count(), 2);
  for (const k of [0, 1]) assert.match((await maps.nth(k).locator("output").first().textContent())!, new RegExp(`^of ${footprint.micromaps}: level \\d`));

  // By keyboard: to another map, and a few steps in it.
  const walker = maps.nth(1);
  await walker.getByRole("button", { name: "Next map" }).press("Enter");
  const canvas = walker.locator("canvas.walker");
  await canvas.focus();
  assert.match((await walker.locator(".readout").textContent())!, /^Micro-triangle 0 of /);
  await canvas.press("ArrowRight");
  await canvas.press("n");
  assert.match((await walker.locator(".readout").textContent())!, /^Micro-triangle [\d,]+ of [\d,]+: (T|O|UT|UO) /);

  const [download] = await Promise.all([page.waitForEvent("download"), section.getByText("Save the scene with its micromaps").click()]);
  await download.saveAs(join(folder, "saved.glb"));
  native("validate", "saved.glb", "--json", "saved.json");
  assert.equal(json("saved.json").errors, 0);
  await page.context().close();
});

test("a broken file: its findings, with places and remedies", async () => {
  const page = await open();
  const section = page.locator("#scene");
  await section.locator("input[type=file]").setInputFiles(join(folder, "broken.glb"));
  await section.locator(".findings li").first().waitFor();
  const wanted = json("broken.json").findings.map((f: { code: string }) => f.code);
  assert.ok(wanted.length > 0);
  assert.deepEqual(await section.locator(".findings li > code").allTextContents(), wanted);
  assert.match((await section.locator(".findings").textContent())!, /To mend it: /);
  await page.context().close();
});

test("what is no scene is named, and nothing hangs", async () => {
  const page = await open();
  const section = page.locator("#scene");
  await section.locator("input[type=file]").setInputFiles({ name: "note.glb", mimeType: "", buffer: Buffer.from("no scene") });
  await section.getByRole("alert").waitFor();
  assert.match((await section.getByRole("alert").textContent())!, /note\.glb/);
  await page.context().close();
});
