// Files, dropped anywhere.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { before, test } from "node:test";

import { drop, folder, native, open, verdictsIn } from "./browser";

before(() => {
  native("prove", "index.equals_reference", "--subject", "step-appendix-middle", "--levels", "0..2", "--quiet", "--json", "wrong.json");
  native("scene", "-o", "small.glb", "--samples", "9", "--quiet");
  native("validate", "small.glb", "--json", "findings.json");
});

const file = (name: string) => ({ name, bytes: readFileSync(join(folder, name)) });

test("a result.json, dropped on the heading, is a report: its verdicts, and its counterexample on the triangle", async () => {
  const page = await open();
  const section = page.locator("#result");
  await drop(page, "h1", file("wrong.json"));
  await section.locator("canvas.triangle").waitFor();
  const wanted = JSON.parse(readFileSync(join(folder, "wrong.json"), "utf8")).results.some((r: { verdict: string }) => r.verdict === "refuted");
  assert.equal(wanted, true);
  assert.deepEqual(await verdictsIn(section), { "index.equals_reference": "refuted" });
  assert.match((await section.textContent())!, /Made from 1 file by mmverify/);
  // Chosen by the field as well, and what is no result is named.
  await section.locator("input[type=file]").setInputFiles(join(folder, "findings.json"));
  assert.match((await section.getByRole("alert").textContent())!, /^findings\.json: its schema is mmverify\.validate\/1\./);
  await page.context().close();
});

test("a dropped function fills the form; what no section takes is named", async () => {
  const page = await open();
  await drop(page, "footer, #curves", { name: "mine.wgsl", bytes: Buffer.from("fn index(level: u32, u: f32, v: f32) -> u32 { return 7u; }") });
  await page.waitForFunction(() => document.querySelector("#function textarea") && (document.querySelector("#function textarea") as HTMLTextAreaElement).value.includes("7u"));
  assert.equal(await page.locator("#function").getByLabel("Language").inputValue(), "WGSL");
  await drop(page, "h1", { name: "note.txt", bytes: Buffer.from("a note") });
  assert.match((await page.locator("#dropped").textContent())!, /^note\.txt: no section takes this/);
  await page.context().close();
});

test("the first screen has a picture, at 1280 and at 400 pixels", async () => {
  for (const width of [1280, 400]) {
    const page = await open({ width });
    const canvas = page.locator(".front canvas").first();
    const box = (await canvas.boundingBox())!;
    assert.ok(box.width >= 300 && box.x + box.width <= width && box.y + box.height <= 900, JSON.stringify(box));
    // All four states are in it.
    const colours = await canvas.evaluate((c) => {
      const { data } = (c as HTMLCanvasElement).getContext("2d")!.getImageData(0, 0, (c as HTMLCanvasElement).width, (c as HTMLCanvasElement).height);
      const seen = new Map<number, number>();
      const words = new Uint32Array(data.buffer);
      for (const word of words) seen.set(word, (seen.get(word) ?? 0) + 1);
      return [...seen.values()].filter((n) => n > words.length / 300).length;
    });
    assert.ok(colours >= 4, `${colours} colours`);
    await page.context().close();
  }
});
