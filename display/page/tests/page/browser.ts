// What the tests of the page share: a browser, and files made by the native program.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before } from "node:test";
import { pathToFileURL } from "node:url";

import { type Browser, chromium, type Locator, type Page } from "playwright-core";

export const folder = mkdtempSync(join(tmpdir(), "mmverify-page-"));
const url = pathToFileURL(process.env["MMVERIFY_PAGE"]!).href;
let browser: Browser;
/** What a task may take on a machine that others share. */
export const patience = 300_000;

export function native(...args: string[]): string {
  const made = spawnSync(process.env["MMVERIFY_PROGRAM"]!, args, { cwd: folder, encoding: "utf8", maxBuffer: 1 << 28 });
  assert.ok(made.status === 0 || made.status === 1, `${args.join(" ")}: ${made.stderr}`);
  return made.stdout;
}

/** The page in a window of its own, which fails the test for any complaint, and for any request but of its own parts. */
export async function open(options: { width?: number; dark?: boolean; hash?: string; ready?: string } = {}): Promise<Page> {
  const context = await browser.newContext({
    viewport: { width: options.width ?? 1280, height: 900 },
    colorScheme: options.dark ? "dark" : "light",
    offline: true,
    reducedMotion: "reduce",
  });
  context.setDefaultTimeout(patience);
  const page = await context.newPage();
  // A test that reads the pixels of WebGL has to wait for them, which the driver warns of.
  page.on("console", (m) => assert.ok(!["error", "warning"].includes(m.type()) || m.text().includes("GPU stall due to ReadPixels"), `console: ${m.text()}`));
  page.on("pageerror", (error) => assert.fail(`page: ${error.message}`));
  page.on("request", (r) => assert.ok(r.url().replace(/#.*/, "") === url || /^(data|blob):/.test(r.url()), `request: ${r.url()}`));
  await page.goto(url + (options.hash ?? ""));
  await page.waitForSelector(options.ready ?? "#state:has-text('is ready')");
  return page;
}

/** Waits until the task of a section has ended; fails where it ended with a complaint. */
export async function done(of: Locator): Promise<void> {
  const ended = of.locator(".task .status", { hasText: "Done in" }).first();
  const complaint = of.getByRole("alert").first();
  await ended.or(complaint).first().waitFor();
  assert.equal(await complaint.count(), 0, (await complaint.allTextContents()).join());
}

/** Drops files on an element. */
export async function drop(page: Page, on: string, ...files: { name: string; bytes: Buffer }[]): Promise<void> {
  await page.evaluate(
    ({ on, files }) => {
      const transfer = new DataTransfer();
      for (const { name, bytes } of files) transfer.items.add(new File([Uint8Array.from(bytes)], name));
      document.querySelector(on)!.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
    },
    { on, files: files.map(({ name, bytes }) => ({ name, bytes: [...bytes] })) },
  );
}

export const verdictsIn = (of: Locator): Promise<Record<string, string>> =>
  of.locator(".verdicts tbody tr").evaluateAll((rows) =>
    Object.fromEntries(rows.map((r) => [r.querySelector(".more")!.textContent!, (r as HTMLElement).dataset["verdict"]!])),
  );

before(async () => {
  browser = await chromium.launch({
    executablePath: process.env["CHROMIUM"] ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader", "--enable-unsafe-swiftshader"],
  });
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});
