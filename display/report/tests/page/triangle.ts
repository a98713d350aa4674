// The triangle that a counterexample opens: what it draws, how it answers, how fast it moves.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { coordinate } from "../../src/cases";
import { curveIndex, indexOf, microAt } from "../../src/curve";
import type { Report } from "../../src/data";
import { folder, open, picture, program, run, settled } from "./browser";

test("the triangle: level, colours, order, zoom and pan change the picture; pointing reads it", async () => {
  const page = await open("all.html");
  const canvas = page.locator("canvas.triangle");
  await canvas.scrollIntoViewIfNeeded();
  assert.match((await page.textContent(".viewer .note"))!, /asked on 61 cells, 4 wrong: 2 micro-triangles, 2 edges, 0 vertices/);
  const seen = [await picture(page)];
  const changed = async (what: string) => {
    await settled(page);
    const now = await picture(page);
    assert.ok(!seen.includes(now), `${what} changes the picture`);
    seen.push(now);
  };
  const box = (await canvas.boundingBox())!;
  // The middle of micro-triangle 7, which answers 4: grid square (1, 0) of level 2, its upper half.
  const scale = Math.min(box.width - 24, (box.height - 60) / (Math.sqrt(3) / 2));
  const at = (u: number, v: number) => ({
    x: box.x + box.width / 2 + (u + v / 2 - 0.5) * scale,
    y: box.y + box.height / 2 - ((v - 0.5) * (Math.sqrt(3) / 2) + 0.006) * scale,
  });
  const point = at((1 + 2 / 3) / 4, (2 / 3) / 4);
  await page.mouse.move(point.x, point.y);
  assert.match((await page.textContent(".readout"))!, /Micro-triangle 7 of level 2, inverted.*answers 4: wrong/);

  // Micro-triangle 7 is outlined as the right one; the wrong edge from (2, 0) to (1, 1) is drawn above that outline.
  const onEdge = at(1.7 / 4, 0.3 / 4);
  const [pixel, wrong] = await canvas.evaluate(
    (c, [x, y]) => {
      const ink = document.createElement("canvas").getContext("2d")!;
      ink.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--wrong");
      ink.fillRect(0, 0, 1, 1);
      return [(c as HTMLCanvasElement).getContext("2d")!.getImageData(x!, y!, 1, 1), ink.getImageData(0, 0, 1, 1)].map((d) => [...d.data].join());
    },
    [Math.round(onEdge.x - box.x), Math.round(onEdge.y - box.y)],
  );
  assert.equal(pixel, wrong);

  await page.getByLabel("the order as a line").uncheck();
  await changed("without the order it");
  await page.getByLabel("Level", { exact: true }).first().fill("4");
  await changed("level 4");
  assert.match((await page.textContent(".viewer .note"))!, /asked on 817 cells, 317 wrong/);
  await page.getByLabel("Colours").selectOption("order");
  await changed("colours by order");
  await page.getByRole("button", { name: "To the counterexample" }).click();
  await changed("going to the counterexample");
  await page.locator(".viewer").getByRole("button", { name: "Zoom in" }).click();
  await changed("zoom");
  await page.mouse.move(box.x + 300, box.y + 200);
  await page.mouse.down();
  await page.mouse.move(box.x + 340, box.y + 260, { steps: 4 });
  await page.mouse.up();
  await changed("a drag");
  await canvas.focus();
  for (const key of ["ArrowLeft", "ArrowUp", "+", "]"]) {
    await page.keyboard.press(key);
    await changed(`the key ${key}`);
  }
  assert.match((await page.locator(".viewer .spoken").textContent())!, /Micro-triangle [\d,]+ of level 5/);
  const before = await page.evaluate(() => scrollY);
  await page.mouse.wheel(0, -200);
  await changed("the wheel");
  assert.equal(await page.evaluate(() => scrollY), before);
  await page.context().close();
});

test("a refuted baker: its states beside the right ones, and its texels", async () => {
  run("prove", "bake.conservative", "--subject", "centre-sample", "--levels", "1", "--no-mutants", "--quiet", "--json", "bake_wrong.json");
  run("report", "bake_wrong.json", "-o", "bake_wrong.html");
  const page = await open("bake_wrong.html");
  const seen = [await picture(page)];
  for (const colours of ["got", "expected", "order"]) {
    await page.getByLabel("Colours").selectOption(colours);
    await settled(page);
    const now = await picture(page);
    assert.ok(!seen.includes(now), colours);
    seen.push(now);
  }
  await page.getByLabel("Level", { exact: true }).first().fill("3");
  await page.getByLabel("Colours").selectOption("got");
  // Its picture is made in pieces, and the words come with the last.
  await page.waitForFunction(() => document.querySelector(".viewer > .note")!.textContent!.includes("The states are of level 1"));
  await page.locator("summary", { hasText: "texels" }).click();
  assert.ok(await page.$eval("img.picture", (img) => (img as HTMLImageElement).naturalWidth > 100));
  await page.context().close();
});

test("the page's curve is the program's", () => {
  // Every cell of level 6, answered by the page's code, judged by the program.
  const points = run("gen", "index", "--level", "6");
  const answered = points
    .split("\n")
    .filter((line) => line !== "" && !line.startsWith("#"))
    .map((line) => {
      const [k, u, v] = line.split(" ");
      return `${k} ${indexOf(microAt(coordinate(u!)!, coordinate(v!)!, 6), 6, "curve")}`;
    })
    .join("\n");
  const checked = spawnSync(program, ["check", "index", "--level", "6"], { input: `${answered}\n`, encoding: "utf8" });
  assert.equal(checked.status, 0, checked.stdout + checked.stderr);
  // And the right answers that a page carries.
  const html = readFileSync(join(folder, "all.html"), "utf8");
  const report = JSON.parse(/<script type="application\/json" id="data">(.*?)<\/script>/s.exec(html)![1]!) as Report;
  let cells = 0;
  for (const { level, wrong } of report.asked[0]!.levels)
    for (let k = 0; k < wrong.length; k += 4) {
      const N = 2 ** level;
      const m = microAt(wrong[k]! / 4 / N, wrong[k + 1]! / 4 / N, level);
      assert.equal(curveIndex(m.i, m.j, m.inverted, level), wrong[k + 2]);
      ++cells;
    }
  assert.ok(cells > 1000);
});

test("a million micro-triangles: frames of a pan", async () => {
  const page = await open("all.html");
  await page.locator("canvas.triangle").scrollIntoViewIfNeeded();
  await page.getByLabel("Level", { exact: true }).first().fill("10");
  for (const colours of ["order", "answers"]) {
    await page.getByLabel("Colours").selectOption(colours);
    await page.locator(".viewer").getByRole("button", { name: "Whole triangle" }).click();
    await settled(page);
    const box = (await page.locator("canvas.triangle").boundingBox())!;
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.evaluate(() => {
      const times: number[] = ((window as { times?: number[] }).times = []);
      let last = performance.now();
      const tick = (now: number) => {
        times.push(now - last);
        last = now;
        requestAnimationFrame(tick);
      };
      requestAnimationFrame(tick);
    });
    for (let k = 1; k <= 90; ++k) await page.mouse.move(box.x + box.width / 2 + 100 * Math.sin(k / 9), box.y + box.height / 2 + 60 * Math.cos(k / 9));
    await page.mouse.up();
    const times = (await page.evaluate(() => (window as { times?: number[] }).times!)).slice(2).sort((a, b) => a - b);
    const at = (share: number) => times[Math.min(times.length - 1, Math.floor(share * times.length))]!.toFixed(1);
    console.log(`# level 10, 1,048,576 micro-triangles, colours ${colours}: ${times.length} frames, median ${at(0.5)} ms, 95 % within ${at(0.95)} ms, longest ${at(1)} ms`);
    assert.ok(times.length > 5);
  }
  await page.context().close();
});
