// What is on a page, and what is not.
import assert from "node:assert/strict";
import { test } from "node:test";

import { open, run } from "./browser";

test("every section is there, nothing is asked of a network, nothing complains", async () => {
  const page = await open("all.html");
  assert.deepEqual(await page.$$eval("section", (all) => all.map((s) => s.id)), ["verdicts", "refuted", "trade", "cost", "footprint", "savings", "attributes", "plan"]);
  assert.equal(await page.$$eval(".plot canvas", (all) => all.length), await page.$$eval(".plot", (all) => all.length));
  // Rays and views need Embree, which not every machine has: they alone are not given.
  assert.match((await page.textContent("footer p"))!, /^Not given: rays \([^;]*\); views by attribute micromaps \([^;]*\)\.$/);
  await page.context().close();
});

test("what was not given is named", async () => {
  const page = await open("right.html");
  assert.deepEqual(await page.$$eval("section", (all) => all.map((s) => s.id)), ["verdicts", "cost"]);
  assert.match((await page.textContent("footer"))!, /Not given: error against run time \(a result of mmverify bench --json\); footprint/);
  await page.context().close();
});

test("a bench without verdicts is a page, too", async () => {
  run("report", "vq.json", "-o", "vq.html");
  const page = await open("vq.html");
  assert.deepEqual(await page.$$eval("section", (all) => all.map((s) => s.id)), ["trade", "savings"]);
  await page.context().close();
});
