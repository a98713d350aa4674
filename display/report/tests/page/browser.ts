// What the tests of the page share: a folder of real results and pages, made once, and a browser.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before } from "node:test";
import { pathToFileURL } from "node:url";

import { type Browser, chromium, type Locator, type Page } from "playwright-core";

export const program = process.env["MMVERIFY_PROGRAM"]!;
export const folder = mkdtempSync(join(tmpdir(), "mmverify-page-"));
let browser: Browser;

export function run(...args: string[]): string {
  const made = spawnSync(program, args, { cwd: folder, encoding: "utf8", maxBuffer: 1 << 28 });
  assert.ok(made.status === 0 || made.status === 1, `${args.join(" ")}: ${made.stderr}`);
  return made.stdout;
}

/** A page open in a window of its own, which fails the test for any complaint or request. */
export async function open(file: string, options: { width?: number; height?: number; dark?: boolean } = {}): Promise<Page> {
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
  await page.waitForSelector("#verdicts, #trade, #attributes, #rays, #views");
  await page.waitForTimeout(150);
  return page;
}

/** A canvas in so few words that a failed assertion can print them. */
export const pixelsOf = async (canvas: Locator): Promise<string> =>
  createHash("sha256")
    .update(await canvas.evaluate((c) => (c as HTMLCanvasElement).toDataURL()))
    .digest("hex");
export const picture = (page: Page): Promise<string> => pixelsOf(page.locator("canvas.triangle"));
export const settled = (page: Page) => page.waitForTimeout(250);

before(async () => {
  browser = await chromium.launch({ executablePath: process.env["CHROMIUM"] ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
  run("prove", "index.equals_reference", "--subject", "step-appendix-middle", "--subject", "step", "--levels", "0..4", "--quiet", "--json", "wrong.json");
  run("scene", "--sizes", "1..4", "--samples", "500", "--quiet", "--json", "scene.json");
  run("bench", "index", "--levels", "3..6", "--samples", "2000", "--quiet", "--json", "index.json");
  run("bench", "vq", "--maps", "4", "--quiet", "--json", "vq.json");
  run("bench", "bake", "--levels", "3..4", "--maps", "1", "--quiet", "--json", "bake.json");
  run("attributes", "--level", "1..3", "--packed", "--time", "--mips", "--plan", "20,40", "--quiet", "--json", "attributes.json", "--pictures", "pictures");
  run("report", "wrong.json", "scene.json", "index.json", "vq.json", "bake.json", "attributes.json", "-o", "all.html");
  run("prove", "index.bijective", "--levels", "0..3", "--quiet", "--json", "right.json");
  run("report", "right.json", "-o", "right.html");
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});
