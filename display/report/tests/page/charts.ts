// The charts.
import assert from "node:assert/strict";
import { test } from "node:test";

import { open, pixelsOf, settled } from "./browser";

test("a chart says its numbers, by mouse and by keys, and zooms", async () => {
  const page = await open("all.html");
  const plot = page.locator("#trade .plot").first();
  await plot.scrollIntoViewIfNeeded();
  await plot.focus();
  await page.keyboard.press("ArrowRight");
  const tip = plot.locator(".tip");
  assert.match((await tip.textContent())!, /ns an index, level 6/);
  assert.match((await page.locator("#trade .chart .spoken").first().textContent())!, /ns an index/);
  const ring = (await plot.locator(".ring").boundingBox())!;
  await page.keyboard.press("Escape");
  assert.equal(await tip.isVisible(), false);
  await page.mouse.move(ring.x + ring.width / 2 + 3, ring.y + ring.height / 2);
  assert.equal(await tip.isVisible(), true);
  assert.match((await tip.textContent())!, /stiff points/);
  const shot = () => pixelsOf(plot.locator("canvas"));
  const whole = await shot();
  await page.locator("#trade .chart").first().getByRole("button", { name: "Zoom in" }).click();
  await settled(page);
  const near = await shot();
  assert.notEqual(near, whole);
  await page.locator("#trade .chart").first().getByRole("button", { name: "Show all" }).click();
  await settled(page);
  assert.equal(await shot(), whole);
  // A box drawn with the mouse.
  const box = (await plot.locator(".u-over").boundingBox())!;
  await page.mouse.move(box.x + 60, box.y + 60);
  await page.mouse.down();
  await page.mouse.move(box.x + 260, box.y + 200, { steps: 5 });
  await page.mouse.up();
  await settled(page);
  assert.notEqual(await shot(), whole);
  await page.context().close();
});

test("series can be hidden", async () => {
  const page = await open("all.html");
  const chart = page.locator("#cost .chart").first();
  const shot = () => pixelsOf(chart.locator("canvas"));
  const all = await shot();
  const key = chart.locator(".key").first();
  await key.click();
  await settled(page);
  assert.equal(await key.getAttribute("aria-pressed"), "false");
  assert.notEqual(await shot(), all);
  await page.context().close();
});
