// An index function, pasted.
import assert from "node:assert/strict";
import { test } from "node:test";

import type { Page } from "playwright-core";

import { native, done, open, verdictsIn } from "./browser";

async function judge(page: Page, code?: string, seconds = 200): Promise<void> {
  const section = page.locator("#function");
  await section.getByLabel("Time limit").fill(String(seconds));
  if (code !== undefined) await section.getByLabel("The function").fill(code);
  await section.getByRole("button", { name: "Judge it" }).click();
}

test("the right function is proved, level by level", async () => {
  const page = await open();
  const section = page.locator("#function");
  await judge(page);
  await done(section);
  const { "index.exact_or_published": onFloats, ...verdicts } = await verdictsIn(section);
  assert.equal(Object.keys(verdicts).length, 6);
  assert.ok(Object.values(verdicts).every((v) => v === "proved"), JSON.stringify(verdicts));
  assert.equal(onFloats, "checked");
  assert.equal(await section.locator("canvas.triangle").count(), 0);
  assert.match((await section.locator(".about-verdict").textContent())!, /each operation rounded to binary32.*Not asked: levels 6 to 16/);
  await page.context().close();
});

test("a formula that binary32 rounds is refuted on floats; in doubles it is not, and the verdict says which", async () => {
  const page = await open();
  const section = page.locator("#function");
  const verdictOn = async (numbers: string): Promise<[string | undefined, string]> => {
    await section.getByLabel("Numbers").selectOption(numbers);
    await judge(page);
    await done(section);
    return [(await verdictsIn(section))["index.exact_or_published"], (await section.locator(".about-verdict").textContent())!];
  };
  await section.getByLabel("Example").selectOption({ label: "wrong on floats: by w = 1 - u - v" });
  const [rounded, words] = await verdictOn("binary32");
  assert.equal(rounded, "refuted");
  assert.match(words, /each operation rounded to binary32/);
  assert.match((await verdictOn("binary64"))[1], /in binary64, as JavaScript computes; in binary32, as shaders do, it may answer otherwise/);
  await section.getByLabel("also a million floats").uncheck();
  const [none, left] = await verdictOn("binary32");
  assert.equal(none, undefined);
  assert.match(left, /Not asked: levels 6 to 16; floats beside the grid's points/);
  await page.context().close();
});

test("ties broken otherwise: refuted on edges and corners alone, with the picture", async () => {
  const page = await open();
  const section = page.locator("#function");
  await section.getByLabel("Example").selectOption({ label: "wrong: breaks ties otherwise" });
  await judge(page);
  await done(section);
  const verdicts = await verdictsIn(section);
  assert.equal(verdicts["index.equals_reference"], "refuted");
  assert.equal(verdicts["index.rounding"], "refuted");
  assert.equal(verdicts["index.bijective"], "proved");
  assert.match((await section.locator(".about").textContent())!, /simplest counterexample/);
  assert.match((await section.locator(".viewer > .note").textContent())!, /asked on \d+ cells, \d+ wrong: 0 micro-triangles, [1-9]/);
  // The wrong edge lies on the outline of the right micro-triangle, and is drawn above it: the middle of the edge of 1 and 2.
  await page.waitForTimeout(300);
  const [pixel, wrong] = await section.locator("canvas.triangle").evaluate((c) => {
    const canvas = c as HTMLCanvasElement;
    const ink = document.createElement("canvas").getContext("2d")!;
    ink.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--wrong");
    ink.fillRect(0, 0, 1, 1);
    const scale = Math.min(canvas.clientWidth - 24, (canvas.clientHeight - 60) / (Math.sqrt(3) / 2));
    const [u, v] = [1 / 2, 1 / 4];
    const x = canvas.clientWidth / 2 + (u + v / 2 - 0.5) * scale;
    const y = canvas.clientHeight / 2 - ((v - 0.5) * (Math.sqrt(3) / 2) + 0.006) * scale;
    return [canvas.getContext("2d")!.getImageData(Math.round(x), Math.round(y), 1, 1), ink.getImageData(0, 0, 1, 1)].map((d) => [...d.data].join());
  });
  assert.equal(pixel, wrong);
  await page.context().close();
});

test("a mirrored function: refuted inside micro-triangles", async () => {
  const page = await open();
  const section = page.locator("#function");
  await section.getByLabel("Example").selectOption({ label: "wrong: mirrored" });
  await judge(page);
  await done(section);
  const verdicts = await verdictsIn(section);
  assert.equal(verdicts["index.equals_reference"], "refuted");
  assert.equal(verdicts["index.bijective"], "proved");
  assert.match((await section.locator(".viewer > .note").textContent())!, /wrong: [1-9]\d* micro-triangle/);
  await page.context().close();
});

test("one that never ends is ended at its time limit, and the page says so", async () => {
  const page = await open();
  const section = page.locator("#function");
  await section.getByLabel("Example").selectOption({ label: "wrong: never ends at level 3" });
  await judge(page, undefined, 2);
  assert.match((await section.getByRole("alert").textContent())!, /stopped after 2 s, which is the time limit: does the function end/);
  // And the page goes on.
  await section.getByLabel("Example").selectOption({ label: "right: Vulkan's reference, exact on floats" });
  await judge(page);
  await done(section);
  await page.context().close();
});

test("Stop stops", async () => {
  const page = await open();
  const section = page.locator("#function");
  await judge(page, "function index() { for (;;); }");
  await section.getByRole("button", { name: "Stop" }).first().click();
  assert.match((await section.getByRole("alert").textContent())!, /as you asked/);
  await page.context().close();
});

test("what is wrong with the text, or with an answer, is said", async () => {
  const page = await open();
  const section = page.locator("#function");
  await judge(page, "function index(level, u, v) {\n  return level +* u;\n}");
  assert.match((await section.getByRole("alert").textContent())!, /^line 2: SyntaxError/);
  await judge(page, "const other = 1;");
  await section.getByRole("alert").filter({ hasText: "no function of the name index" }).waitFor();
  await judge(page, "function index(level, u, v) { return u === 0.5 ? undefined : 0; }");
  await done(section);
  assert.ok(Object.values(await verdictsIn(section)).includes("broken"));
  await section.locator(".verdicts tr[data-verdict=broken] .more").first().click();
  assert.match((await section.locator(".below").textContent())!, /returned undefined, which is no whole number/);
  // A script that throws, in either arithmetic, and over lines that are one operation.
  for (const numbers of ["binary32", "binary64"]) {
    await section.getByLabel("Numbers").selectOption(numbers);
    await judge(page, "function index(level, u, v) {\n  const a = u *\n    v;\n  return nothing + a;\n}");
    await done(section);
    await section.locator(".verdicts tr[data-verdict=broken] .more").first().click();
    assert.match((await section.locator(".below").textContent())!, /line 4: ReferenceError: nothing is not defined/);
  }
  await page.context().close();
});

test("a text of another language gets a hint with its command; a script for npm gets a verdict", async () => {
  const page = await open();
  const section = page.locator("#function");
  await judge(page, "#version 460\nuint index(uint level, float u, float v) { return 0u; }\n");
  assert.match((await section.locator(".hint").textContent())!, /^This is GLSL.*mmverify prove index --subject mine\.glsl/);
  assert.match((await section.getByRole("alert").filter({ visible: true }).textContent())!, /did not run this text/);
  await judge(page, "export function index_f32(level, u, v, index) {\n  index.fill(0);\n}\n");
  await done(section);
  assert.equal((await verdictsIn(section))["index.equals_reference"], "refuted");
  assert.match((await section.locator(".hint").textContent())!, /npx mmverify prove/);
  await section.getByLabel("The function").fill("fn index(level: u32, u: f32, v: f32) -> u32 { return 0u; }");
  assert.equal(await section.getByLabel("Language").inputValue(), "WGSL");
  await page.context().close();
});

test("a link to a case brings the function, runs nothing by itself, and shows the case", async () => {
  const page = await open();
  const section = page.locator("#function");
  await section.getByLabel("Example").selectOption({ label: "wrong: breaks ties otherwise" });
  await section.getByLabel("Levels 0 to").fill("3");
  await judge(page);
  await done(section);
  await section.getByLabel("Refuted").selectOption({ label: "index.rounding, ./your-index.js" });
  const link = section.getByText("Link to this case: index.rounding, level 1");
  const words = (await link.textContent())!;
  const address = (await link.getAttribute("href"))!;
  const code = await section.getByLabel("The function").inputValue();
  await page.context().close();

  const other = await open({ hash: address });
  const there = other.locator("#function");
  await there.getByText("A link brought this function").waitFor();
  assert.equal(await there.getByLabel("The function").inputValue(), code);
  assert.equal(await there.locator(".verdicts").count(), 0);
  await there.getByRole("button", { name: "Judge it" }).click();
  await done(there);
  assert.equal(await there.getByLabel("Refuted").evaluate((list) => (list as HTMLSelectElement).selectedOptions[0]!.text), "index.rounding, ./your-index.js");
  assert.equal(await there.getByText("Link to this case").textContent(), words);
  await other.evaluate(() => (location.hash = "#case=abc"));
  await there.getByText("This link's case cannot be read").waitFor();
  await other.context().close();
});

test("WGSL: judged where there is WebGPU, else the page says that there is none and names the table", async () => {
  const page = await open();
  const section = page.locator("#function");
  page.removeAllListeners("console"); // Chromium warns of drivers
  await section.getByLabel("Language").selectOption("WGSL");
  const has = await page.evaluate(async () => (await (navigator as { gpu?: { requestAdapter(): Promise<unknown> } }).gpu?.requestAdapter()) != null);
  console.log(`# WebGPU: ${has ? "there" : "not there"}`);
  if (!has) {
    await section.getByText(/WebGPU.*A table of answers/).first().waitFor();
    await page.context().close();
    return;
  }
  await judge(page);
  await done(section);
  assert.equal((await verdictsIn(section))["index.equals_reference"], "proved");
  await section.getByLabel("Example").selectOption({ label: "wrong: mirrored" });
  await judge(page);
  await section.locator("canvas.triangle").waitFor();
  assert.equal((await verdictsIn(section))["index.equals_reference"], "refuted");
  await judge(page, "fn index(level: u32, u: f32, v: f32) -> u32 {\n  return nothing;\n}");
  assert.match((await section.getByRole("alert").textContent())!, /^line 2: .*nothing/);
  await page.context().close();
});

test("a table of answers: the points are the native program's, right and wrong answers are told apart", async () => {
  const page = await open();
  const part = page.locator("#answers");
  await page.getByText("A table of answers, for a function").click();
  await part.getByRole("button", { name: "Write the points" }).click();
  await done(part);
  assert.equal(await part.getByLabel("Points").inputValue(), native("gen", "index", "--level", "2"));
  // Right answers: the reference at the points, known by the curve of level 0: 0 everywhere.
  await part.getByLabel("Level").fill("0");
  await part.getByRole("button", { name: "Write the points" }).click();
  await done(part);
  const zeros = Array.from({ length: 7 }, (_, k) => `${k} 0`).join("\n");
  await part.getByLabel("Answers").fill(zeros);
  await part.getByRole("button", { name: "Judge the answers" }).click();
  await part.locator(".verdicts").waitFor();
  assert.deepEqual(Object.values(await verdictsIn(part)), ["proved"]);
  assert.match((await part.locator(".about-verdict").textContent())!, /Not asked: levels other than 0; floats/);
  await part.getByLabel("Answers").fill(zeros.replace("3 0", "3 1"));
  await part.getByRole("button", { name: "Judge the answers" }).click();
  await part.locator("canvas.triangle").waitFor();
  assert.deepEqual(Object.values(await verdictsIn(part)), ["refuted"]);
  await page.context().close();
});
