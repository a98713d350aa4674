// The two curves, walked by keyboard.
import assert from "node:assert/strict";
import { test } from "node:test";

import { rightIndex } from "../../src/program/cells";
import { open } from "./browser";

test("a walk by keys over insides, edges and corners; ties are told and given as the reference gives them", async () => {
  const page = await open();
  const part = page.locator("#walk-order");
  const canvas = part.locator("canvas.walker");
  const says = () => part.locator(".readout").textContent();
  await canvas.focus();
  // It begins at u = 6/16, v = 4/16 of level 2, in the middle of an edge.
  assert.match((await says())!, new RegExp(`^u 3/8, v 1/4, w 3/8\\. A tie: on the edge that 5 and 7 share\\. The reference gives it to ${rightIndex(6, 4, 2)}\\.$`));
  await canvas.press("ArrowRight");
  await canvas.press("ArrowUp");
  assert.match((await says())!, /^u 7\/16, v 5\/16, w 1\/4\. (Inside|A tie)/);
  await canvas.press("ArrowRight");
  await canvas.press("ArrowDown");
  assert.match((await says())!, new RegExp(`A tie: on the corner that \\d+, \\d+, \\d+, \\d+, \\d+ and \\d+ share\\. The reference gives it to ${rightIndex(8, 4, 2)}\\.`));
  const path = (await part.locator(".path").textContent())!;
  assert.match(path, new RegExp(`= ${rightIndex(8, 4, 2)}\\.$`));
  await canvas.press("]");
  assert.match((await part.locator("output").first().textContent())!, /^3: 64 micro-triangles/);
  assert.match((await says())!, /^u 1\/2, v 1\/4/);
  await canvas.press("n");
  const first = /micro-triangle (\d+)/.exec((await says())!)![1];
  await canvas.press("p");
  assert.equal(Number(/micro-triangle (\d+)/.exec((await says())!)![1]), Number(first) - 1);
  await part.getByLabel("Order", { exact: true }).selectOption("rows");
  assert.match((await part.locator(".path").textContent())!, /^Row \d begins at/);
  await page.context().close();
});

test("pointing reads the triangle, and zoom changes the picture", async () => {
  const page = await open();
  const part = page.locator("#walk-order");
  const canvas = part.locator("canvas.walker");
  await canvas.scrollIntoViewIfNeeded();
  const before = await part.locator(".readout").textContent();
  const box = (await canvas.boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + 0.8 * box.height);
  assert.notEqual(await part.locator(".readout").textContent(), before);
  const picture = () => canvas.evaluate((c) => (c as HTMLCanvasElement).toDataURL());
  const whole = await picture();
  await part.getByRole("button", { name: "Zoom in" }).click();
  await page.waitForTimeout(200);
  assert.notEqual(await picture(), whole);
  await page.context().close();
});

test("the leaf: by the middle alone nothing is unknown, and a wrong one says what goes wrong", async () => {
  const page = await open();
  const part = page.locator("#walk-leaf");
  const canvas = part.locator("canvas.walker");
  await canvas.focus();
  const said = new Set<string>();
  const walk = async () => {
    for (let k = 0; k < 64; ++k) {
      said.add((await part.locator(".readout").textContent())!);
      await canvas.press("n");
    }
  };
  await walk();
  assert.ok([...said].some((t) => t.includes("unknown")) && [...said].some((t) => t.includes("opaque: leaf everywhere")));
  said.clear();
  await part.getByLabel("States").selectOption("centre");
  for (let k = 0; k < 64; ++k) await canvas.press("p");
  await walk();
  assert.ok([...said].every((t) => /^Called (opaque|transparent)/.test(t)));
  assert.ok([...said].some((t) => t.includes("would stop in the air")) && [...said].some((t) => t.includes("the leaf has a hole")));
  await page.context().close();
});
