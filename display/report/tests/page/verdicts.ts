// The table of verdicts.
import assert from "node:assert/strict";
import { test } from "node:test";

import { open } from "./browser";

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
  assert.match(text, /right at levels 0\.\.1, first wrong at level 2/);
  assert.equal(await page.$$eval(".below tbody tr", (all) => all.length), 5);
  await page.keyboard.press("Enter");
  assert.equal(await page.$(".below"), null);
  await page.context().close();
});
