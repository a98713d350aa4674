// The viewer in a browser: opened from disk, offline.
// Environment: MMVERIFY_PAGE, MMVERIFY_PROGRAM (the native one), CHROMIUM; MMVERIFY_SHOTS: a folder for pictures of it.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { before, test } from "node:test";

import type { Page } from "playwright-core";

import { drop, folder, native, open } from "../../page/tests/page/browser";
import { tints } from "../src/tints";

const bytes = (name: string): Buffer => readFileSync(join(folder, name));

before(() => {
  native("scene", "-o", "garden.glb", "--level", "3", "--no-laws", "--quiet");
  const file = bytes("garden.glb");
  const broken = file.toString("latin1").replace(/("usageCounts":\[)(\d)/, (_, head: string, digit: string) => `${head}${digit === "9" ? 8 : Number(digit) + 1}`);
  writeFileSync(join(folder, "broken.glb"), Buffer.from(broken, "latin1"));
});

/** The page with a file dropped on it, once its maps are drawn and its findings listed. */
async function viewing(name: string, options: Parameters<typeof open>[0] = {}): Promise<Page> {
  const page = await open({ ...options, ready: ".status" });
  await drop(page, "#page", { name, bytes: bytes(name) });
  await page.waitForSelector("h3:has-text('Findings')");
  await page.waitForSelector("canvas[data-drawn]");
  return page;
}

/** What the canvas shows, four bytes a pixel. */
async function picture(page: Page): Promise<{ pixels: Uint8Array; width: number; height: number }> {
  const { text, width, height } = await page.evaluate(() => {
    const canvas = document.querySelector("canvas")!, copy = document.createElement("canvas");
    const { width, height } = Object.assign(copy, { width: canvas.width, height: canvas.height });
    const flat = copy.getContext("2d", { willReadFrequently: true })!;
    flat.drawImage(canvas, 0, 0);
    const bytes = flat.getImageData(0, 0, width, height).data;
    let text = "";
    for (let k = 0; k < bytes.length; k += 1 << 14) text += String.fromCharCode(...bytes.subarray(k, k + (1 << 14)));
    return { text: btoa(text), width, height };
  });
  return { pixels: Buffer.from(text, "base64"), width, height };
}

test("levels and counts are the native program's", async () => {
  const page = await viewing("garden.glb");
  const said = native("check", "maps", "garden.glb", "--quiet");
  const [, triangles, special] = /([\d,]+) triangles with maps, [\d,]+ distinct; ([\d,]+) of them special/.exec(said)!;
  const [, levels] = /by level +(.*)/.exec(said)!;
  const text = (await page.locator(".total").textContent())!;
  assert.equal(text, `${triangles} triangles with maps; by level ${levels}; ${special} of them special indices.`);
  for (const [k, { sign }] of tints.entries()) {
    const [, count] = new RegExp(`(?:states +|, )${sign} ([\\d,]*\\d)`).exec(said)!;
    assert.ok((await page.locator(".states .count").nth(k).textContent())!.startsWith(`${count} · `), sign);
  }
  assert.match((await page.locator("aside").textContent())!, /gltf \(draft ext-2\): 0 errors, 0 warnings/);
  await page.context().close();
});

test("flat on a texture, each pixel has the tint of the state that is read there, and the state is the file's", async () => {
  const page = await viewing("garden.glb");
  await page.getByLabel("View").selectOption({ label: "flat, on leaves" });
  await page.getByLabel("Texture").selectOption("none");
  await page.getByLabel("Edges of micro-triangles").uncheck();
  await page.getByLabel("Tint").fill("1");
  await page.waitForTimeout(300);
  const canvas = page.locator("canvas"), box = (await canvas.boundingBox())!;
  const { pixels, width, height } = await picture(page);
  const seen = new Set<string>();
  const micros = new Set<string>();
  let means = 0;
  for (let k = 0; k < 150; ++k) {
    // Points of a sequence that fills the middle of the canvas, where the texture lies.
    const x = Math.floor(width * (0.1 + 0.8 * ((k * 0.7548776662) % 1))), y = Math.floor(height * (0.1 + 0.8 * ((k * 0.5698402909) % 1)));
    await page.mouse.move(box.x + x + 0.5, box.y + y + 0.5);
    const words = (await page.locator(".readout").textContent())!;
    const found = /^mesh (\d+) primitive (\d+) triangle (\d+): (?:record (\d+) of level (\d+); micro-triangle (\d+) of \d+|special index): (T|O|UT|UO), /.exec(words);
    assert.ok(found, words);
    const sign = found[7]!;
    const at = 4 * (Math.floor(y) * width + Math.floor(x)), pixel = [...pixels.subarray(at, at + 3)];
    const drawn = tints.find(({ word }) => [1, 3, 5].every((from, c) => Math.abs(parseInt(word.slice(from, from + 2), 16) - pixel[c]!) <= 2));
    // A pixel on an edge between triangles has a mean of two tints.
    if (!drawn) {
      ++means;
      continue;
    }
    assert.equal(drawn.sign, sign, words);
    seen.add(sign);
    micros.add(found.slice(1, 7).join());
    if (found[6] !== undefined) assert.equal(stateOf(Number(found[4]), Number(found[6])), tints.findIndex((tint) => tint.sign === sign), words);
  }
  assert.deepEqual([...seen].sort(), ["O", "T", "UO", "UT"]);
  assert.ok(means < 15, `${means} points on edges`);
  assert.ok(micros.size > 50, `${micros.size} micro-triangles`);
  await page.context().close();
});

/** A state of the file's first array, read from its bytes. */
function stateOf(record: number, index: number): number {
  const file = bytes("garden.glb"), json = JSON.parse(file.subarray(20, 20 + file.readUInt32LE(12)).toString());
  const [{ data, triangles }] = json.extensions.EXT_mesh_opacity_micromap.micromaps;
  const at = (view: number): number => 28 + file.readUInt32LE(12) + (json.bufferViews[view].byteOffset ?? 0);
  const bits = file.readUInt16LE(at(triangles) + 8 * record + 6);
  const bit = 8 * file.readUInt32LE(at(triangles) + 8 * record) + bits * index;
  return (file[at(data) + (bit >> 3)]! >> (bit & 7)) & (2 ** bits - 1);
}

test("a state that is unticked is not drawn, and the tint follows its slider", async () => {
  const page = await viewing("garden.glb");
  await page.getByLabel("View").selectOption({ label: "flat, on leaves" });
  await page.getByLabel("Texture").selectOption("none");
  /** Colours of areas; the edges of an area are blended. */
  const colours = async (): Promise<number> => {
    const { pixels } = await picture(page), counts = new Map<number, number>();
    for (const word of new Uint32Array(pixels.slice().buffer)) counts.set(word, (counts.get(word) ?? 0) + 1);
    return [...counts.values()].filter((count) => count > 400).length;
  };
  await page.getByLabel("Edges of micro-triangles").uncheck();
  await page.waitForTimeout(300);
  assert.equal(await colours(), 5);
  for (const { sign } of tints.slice(1)) await page.getByLabel(new RegExp(`^${sign} `)).uncheck();
  await page.waitForTimeout(300);
  assert.equal(await colours(), 2);
  await page.getByLabel("Tint").fill("0");
  await page.waitForTimeout(300);
  assert.equal(await colours(), 1);
  await page.context().close();
});

test("a broken file: its findings beside the picture", async () => {
  const page = await viewing("broken.glb");
  assert.ok((await page.locator(".findings li > code").allTextContents()).includes("counts.array"));
  await page.context().close();
});

test("a file that the page cannot show: why, and its findings all the same", async () => {
  const page = await open({ ready: ".status" });
  const file = join(process.env["MMVERIFY_SOURCE"]!, "tests/scene/files/leaf_draco.glb");
  await drop(page, "#page", { name: "leaf_draco.glb", bytes: readFileSync(file) });
  await page.waitForSelector("h3:has-text('Findings')");
  assert.match((await page.getByRole("alert").textContent())!, /does not decode meshes that Draco compressed/);
  assert.equal(await page.locator("canvas").count(), 0);
  await page.context().close();
});

test("a file without maps is baked here; what is no file is named", async () => {
  const page = await open({ ready: ".status" });
  await page.locator("input[type=file]").setInputFiles({ name: "note.glb", mimeType: "", buffer: Buffer.from("no scene") });
  await page.getByRole("alert").first().waitFor();
  const file = bytes("garden.glb"), size = file.readUInt32LE(12), json = JSON.parse(file.subarray(20, 20 + size).toString());
  delete json.extensions.EXT_mesh_opacity_micromap;
  for (const { primitives } of json.meshes) for (const primitive of primitives) delete primitive.extensions?.EXT_mesh_opacity_micromap;
  json.extensionsUsed = json.extensionsUsed.filter((name: string) => name !== "EXT_mesh_opacity_micromap");
  const plain = Buffer.concat([file.subarray(0, 20), Buffer.from(JSON.stringify(json).padEnd(size)), file.subarray(20 + size)]);
  await drop(page, "#page", { name: "plain.glb", bytes: plain });
  await page.getByRole("button", { name: "Bake them here" }).click();
  await page.waitForSelector("canvas[data-drawn]");
  assert.match((await page.locator(".total").textContent())!, /triangles with maps/);
  assert.match((await page.locator("aside").textContent())!, /plain\.glb, baked here/);
  await page.context().close();
});

test("narrow and wide, light and dark: nothing scrolls sideways, every control has a name", async () => {
  const page = await viewing("garden.glb");
  for (const width of [400, 1280])
    for (const scheme of ["light", "dark"] as const) {
      await page.setViewportSize({ width, height: 900 });
      await page.emulateMedia({ colorScheme: scheme });
      await page.waitForTimeout(300);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
      const shots = process.env["MMVERIFY_SHOTS"];
      if (shots) await page.screenshot({ path: join(shots, `viewer-${width}-${scheme}.png`) });
    }
  const unnamed = await page.$$eval("button, select, input", (all) => all.filter((e) => !(e as HTMLInputElement).labels?.length && !e.textContent).length);
  assert.equal(unnamed, 0);
  await page.context().close();
});
