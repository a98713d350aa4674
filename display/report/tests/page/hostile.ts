// A file that wants to be more than text.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { folder, open, run } from "./browser";

test("texts of a file stay texts", async () => {
  const hostile = `</script><script>window.hacked = 1</script><!--<script><img src=x onerror="window.hacked=2">\u2028{data}$&`;
  const wrong = JSON.parse(readFileSync(join(folder, "wrong.json"), "utf8"));
  for (const result of wrong.results) {
    result.subject = hostile;
    result.domain = hostile;
    if (result.counterexample) result.counterexample.case = result.counterexample.got = hostile;
  }
  wrong.diagnoses = [{ law: wrong.results[0].law, subject: hostile, lines: [hostile] }];
  const scene = JSON.parse(readFileSync(join(folder, "scene.json"), "utf8"));
  scene.scene.file = scene.scene.plan.surfaces[0].image = scene.scene.plan.left_out[0].why = hostile;
  const attributes = JSON.parse(readFileSync(join(folder, "attributes.json"), "utf8").replaceAll('"baseColor"', () => JSON.stringify(hostile)));
  attributes.file = attributes.left_out[0].why = attributes.pictures[0].image = attributes.pictures[0].file = hostile;
  // A path to a file that is no picture must not carry that file into the page.
  attributes.pictures[1].file = "wrong.json";
  for (const picture of attributes.pictures.slice(2)) picture.image = "harmless";
  writeFileSync(join(folder, "hostile_attributes.json"), JSON.stringify(attributes));
  writeFileSync(join(folder, "hostile.json"), JSON.stringify(wrong));
  writeFileSync(join(folder, "hostile_scene.json"), JSON.stringify(scene));
  run("report", "hostile.json", "hostile_scene.json", "hostile_attributes.json", "-o", "hostile.html");
  const page = await open("hostile.html");
  await page.locator(".verdicts .more").first().click();
  assert.equal(await page.evaluate(() => (window as { hacked?: number }).hacked), undefined);
  assert.equal(await page.$$eval("script", (all) => all.length), 2);
  assert.equal(await page.$$eval("main img", (all) => all.length), 0);
  assert.equal(await page.locator(".verdicts td").first().textContent(), hostile);
  assert.match((await page.textContent(".viewer"))!, /not asked again: the subject is not built in/);
  await page.context().close();
});
