// The page opens, and its policy holds.
import assert from "node:assert/strict";
import { test } from "node:test";

import { open } from "./browser";

test("five sections, the program ready, its time", async () => {
  const page = await open();
  assert.deepEqual(await page.$$eval("section", (all) => all.map((s) => s.id)), ["scene", "function", "result", "laws", "curves"]);
  const words = (await page.textContent("#state"))!;
  assert.match(words, /The program is ready: [\d.]+ MB of WebAssembly, unpacked and compiled in/);
  console.log(`# ${words}`);
  await page.context().close();
});

test("the policy: no other script, no network, no evaluation of text", async () => {
  const page = await open();
  const policy = (await page.getAttribute("meta[http-equiv=Content-Security-Policy]", "content"))!;
  assert.doesNotMatch(policy, /unsafe-inline|'unsafe-eval'|https?:|\*/);
  assert.match(policy, /^default-src 'none'; script-src 'sha256-[^']+' 'wasm-unsafe-eval';/);
  // The browser holds the page to it; in the page the functions under test run in workers of theirs.
  page.removeAllListeners("console");
  assert.match(await page.evaluate(() => fetch("https://example.invalid/").then(() => "reached", String)), /TypeError/);
  assert.equal(await page.evaluate(() => {
    const script = document.createElement("script");
    script.textContent = "window.planted = 1";
    document.body.append(script);
    return (window as { planted?: number }).planted;
  }), undefined);
  await page.context().close();
});
