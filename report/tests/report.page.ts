// The page in a browser: made by the program from real results, opened from disk, offline.
// Environment: MMVERIFY_PROGRAM, CHROMIUM; MMVERIFY_SHOTS: a folder for pictures of it.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";

import { type Browser, chromium, type Locator, type Page } from "playwright-core";

import { coordinate } from "../src/cases";
import { curveIndex, indexOf, microAt } from "../src/curve";
import type { Report } from "../src/data";

const program = process.env["MMVERIFY_PROGRAM"]!;
const folder = mkdtempSync(join(tmpdir(), "mmverify-page-"));
let browser: Browser;

function run(...args: string[]): string {
  const made = spawnSync(program, args, { cwd: folder, encoding: "utf8", maxBuffer: 1 << 28 });
  assert.ok(made.status === 0 || made.status === 1, `${args.join(" ")}: ${made.stderr}`);
  return made.stdout;
}

/** A page open in a window of its own, which fails the test for any complaint or request. */
async function open(file: string, options: { width?: number; height?: number; dark?: boolean } = {}): Promise<Page> {
  const context = await browser.newContext({
    viewport: { width: options.width ?? 1280, height: options.height ?? 900 },
    colorScheme: options.dark ? "dark" : "light",
    offline: true,
    reducedMotion: "reduce",
  });
  const page = await context.newPage();
  const url = pathToFileURL(join(folder, file)).href;
  page.on("console", (m) => assert.ok(!["error", "warning"].includes(m.type()), `console: ${m.text()}`));
  page.on("pageerror", (error) => assert.fail(`page: ${error.message}`));
  page.on("request", (r) => assert.ok(r.url() === url || r.url().startsWith("data:"), `request: ${r.url()}`));
  await page.goto(url);
  await page.waitForSelector("#verdicts, #trade, #attributes");
  await page.waitForTimeout(150);
  return page;
}

/** A canvas in so few words that a failed assertion can print them. */
const pixelsOf = async (canvas: Locator): Promise<string> =>
  createHash("sha256")
    .update(await canvas.evaluate((c) => (c as HTMLCanvasElement).toDataURL()))
    .digest("hex");
const picture = (page: Page): Promise<string> => pixelsOf(page.locator("canvas.triangle"));
const settled = (page: Page) => page.waitForTimeout(250);

before(async () => {
  browser = await chromium.launch({ executablePath: process.env["CHROMIUM"] ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
  run("prove", "index.equals_reference", "--subject", "step-appendix-middle", "--subject", "step", "--levels", "0..4", "--quiet", "--json", "wrong.json");
  run("scene", "--sizes", "1..4", "--samples", "500", "--quiet", "--json", "scene.json");
  run("bench", "index", "--levels", "3..6", "--samples", "2000", "--quiet", "--json", "index.json");
  run("bench", "vq", "--maps", "4", "--quiet", "--json", "vq.json");
  run("bench", "bake", "--levels", "3..4", "--maps", "1", "--quiet", "--json", "bake.json");
  run("scene", "--attributes", "--level", "1..3", "--packed", "--time", "--mips", "--plan", "20,40", "--quiet", "--json", "attributes.json", "--pictures", "pictures");
  run("report", "wrong.json", "scene.json", "index.json", "vq.json", "bake.json", "attributes.json", "-o", "all.html");
  run("prove", "index.bijective", "--levels", "0..3", "--quiet", "--json", "right.json");
  run("report", "right.json", "-o", "right.html");
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

test("every section is there, nothing is asked of a network, nothing complains", async () => {
  const page = await open("all.html");
  assert.deepEqual(await page.$$eval("section", (all) => all.map((s) => s.id)), ["verdicts", "refuted", "trade", "cost", "footprint", "savings", "attributes", "plan"]);
  assert.equal(await page.$$eval(".plot canvas", (all) => all.length), await page.$$eval(".plot", (all) => all.length));
  // Rays need Embree, which not every machine has: they alone are not given.
  assert.match((await page.textContent("footer p"))!, /^Not given: rays \([^;]*\)\.$/);
  await page.context().close();
});

test("what was not given is named", async () => {
  const page = await open("right.html");
  assert.deepEqual(await page.$$eval("section", (all) => all.map((s) => s.id)), ["verdicts", "cost"]);
  assert.match((await page.textContent("footer"))!, /Not given: error against run time \(a result of mmverify bench --json\); footprint/);
  await page.context().close();
});

test("the table filters", async () => {
  const page = await open("all.html");
  const rows = () => page.$$eval(".verdicts tbody tr", (all) => all.length);
  const all = await rows();
  await page.getByLabel("Filter").fill("appendix refuted");
  assert.equal(await rows(), 1);
  assert.match((await page.textContent(".count"))!, new RegExp(`^1 of ${all} rows$`));
  await page.getByLabel("Filter").fill("no such law");
  assert.equal(await rows(), 0);
  await page.getByLabel("Filter").fill("");
  await page.getByLabel("Verdict", { exact: true }).first().selectOption("checked");
  assert.ok((await rows()) > 0 && (await rows()) < all);
  await page.getByLabel("Topic").selectOption("index");
  assert.equal(await rows(), 0);
  await page.context().close();
});

test("the table sorts by each column, by keyboard, and says so", async () => {
  const page = await open("all.html");
  const column = (k: number) => page.$$eval(".verdicts tbody tr", (all, at) => all.map((r) => r.children[at]!.textContent!), k);
  assert.match((await column(4))[0]!, /refuted/);
  const head = page.locator(".verdicts thead th").nth(3);
  await head.locator("button").focus();
  await page.keyboard.press("Enter");
  assert.equal(await head.getAttribute("aria-sort"), "ascending");
  const numbers = (await column(3)).map((t) => Number(/^[\d,]+/.exec(t)![0].replaceAll(",", "")));
  assert.deepEqual(numbers, [...numbers].sort((a, b) => a - b));
  await page.keyboard.press("Space");
  assert.equal(await head.getAttribute("aria-sort"), "descending");
  await page.locator(".verdicts thead button").first().click();
  const laws = (await column(0)).map((t) => t.split(" ")[0]!);
  assert.deepEqual(laws, [...laws].sort());
  assert.equal(await head.getAttribute("aria-sort"), "none");
  await page.context().close();
});

test("a row opens: counterexample, replay command, level by level", async () => {
  const page = await open("all.html");
  const more = page.locator(".verdicts .more").first();
  await more.focus();
  await page.keyboard.press("Enter");
  const text = (await page.textContent(".below"))!;
  assert.match(text, /mmverify replay index\.equals_reference --level 2 --case e:u=3\/8,v=1\/8 --subject step-appendix-middle/);
  assert.match(text, /expected 7, got 4/);
  assert.match(text, /right at levels 0\.\.1, wrong at 2/);
  assert.equal(await page.$$eval(".below tbody tr", (all) => all.length), 5);
  await page.keyboard.press("Enter");
  assert.equal(await page.$(".below"), null);
  await page.context().close();
});

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
  assert.match((await tip.textContent())!, /hard points/);
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

test("keys reach everything that can be clicked", async () => {
  const page = await open("all.html");
  const wanted = await page.$$eval("button, select, input, summary, a[href], canvas.triangle, .plot, .scrolls", (all) =>
    all.filter((e) => (e as HTMLElement).checkVisibility()).map((e, k) => ((e as HTMLElement).dataset["reached"] = "no", k)).length,
  );
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  for (let k = 0; k < wanted + 20; ++k) {
    await page.keyboard.press("Tab");
    await page.evaluate(() => ((document.activeElement as HTMLElement).dataset["reached"] = "yes"));
  }
  assert.deepEqual(await page.$$eval("[data-reached=no]", (all) => all.map((e) => `${e.tagName} ${e.className} ${e.textContent}`)), []);
  // What has the focus shows it.
  await page.locator(".verdicts thead button").first().focus();
  await page.keyboard.press("Tab");
  assert.notEqual(await page.evaluate(() => getComputedStyle(document.activeElement!).outlineStyle), "none");
  await page.context().close();
});

test("every control has a name, every row its heading", async () => {
  const page = await open("all.html");
  const nameless = await page.$$eval("button, select, input, canvas[tabindex]", (all) =>
    all.filter((e) => !(e.getAttribute("aria-label") ?? e.textContent ?? "").trim() && !(e.id && document.querySelector(`label[for="${e.id}"]`))).map((e) => e.outerHTML),
  );
  assert.deepEqual(nameless, []);
  assert.ok(await page.$$eval(".verdicts tbody tr", (all) => all.every((r) => r.querySelector("th[scope=row]") !== null)));
  await page.context().close();
});

test("narrow and wide, light and dark: nothing scrolls sideways but tables within their boxes", async () => {
  for (const width of [320, 400, 768, 1280])
    for (const dark of [false, true]) {
      const page = await open("all.html", { width, dark });
      await page.locator(".verdicts .more").first().click();
      await page.$$eval("details", (all) => all.forEach((d) => (d.open = true)));
      await settled(page);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
      const shots = process.env["MMVERIFY_SHOTS"];
      if (shots) await page.screenshot({ path: join(shots, `${width}-${dark ? "dark" : "light"}.png`), fullPage: true });
      await page.context().close();
    }
});

test("the button changes the colours, of the page and of its pictures", async () => {
  const page = await open("all.html");
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const [light, drawn] = [await paper(), await picture(page)];
  await page.getByRole("button", { name: "Dark colours" }).click();
  await settled(page);
  assert.notEqual(await paper(), light);
  assert.notEqual(await picture(page), drawn);
  await page.getByRole("button", { name: "Light colours" }).click();
  await settled(page);
  assert.equal(await paper(), light);
  assert.equal(await picture(page), drawn);
  await page.context().close();
});

test("words of text have contrast of 4.5 to 1", async () => {
  for (const dark of [false, true]) {
    const page = await open("all.html", { dark });
    const poor = await page.evaluate(() => {
      const channels = (colour: string) => /rgba?\(([^)]+)\)/.exec(colour)?.[1]!.split(/[ ,/]+/).map(Number);
      const luminance = (c: number[]) => {
        const [r, g, b] = c.slice(0, 3).map((x) => (x / 255 <= 0.03928 ? x / 255 / 12.92 : ((x / 255 + 0.055) / 1.055) ** 2.4));
        return 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;
      };
      const found: string[] = [];
      for (const e of document.querySelectorAll("p, a, li, td, th, button, label, h1, h2, h3, summary, figcaption, caption, code, strong, .verdict")) {
        const ink = channels(getComputedStyle(e).color);
        let paper: number[] | undefined;
        for (let at: Element | null = e; at && !paper; at = at.parentElement) {
          const c = channels(getComputedStyle(at).backgroundColor);
          if (c && (c[3] ?? 1) === 1) paper = c;
        }
        if (!ink || !paper) continue;
        const [a, b] = [luminance(ink), luminance(paper)];
        const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        if (contrast < 4.5) found.push(`${e.tagName} ${e.textContent!.slice(0, 30)} ${contrast.toFixed(2)}`);
      }
      return found;
    });
    assert.deepEqual(poor, []);
    await page.context().close();
  }
});

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

test("a bench without verdicts is a page, too", async () => {
  run("report", "vq.json", "-o", "vq.html");
  const page = await open("vq.html");
  assert.deepEqual(await page.$$eval("section", (all) => all.map((s) => s.id)), ["trade", "savings"]);
  await page.context().close();
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
