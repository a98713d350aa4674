// Every law.
import assert from "node:assert/strict";
import { test } from "node:test";

import { done, native, open } from "./browser";

test("all laws of the native program are listed, and say what they say", async () => {
  const page = await open();
  const section = page.locator("#laws");
  await section.locator(".law").first().waitFor();
  const { laws } = JSON.parse(native("list", "--json")) as { laws: { law: string; statement: string }[] };
  assert.deepEqual(
    await section.locator(".law summary").evaluateAll((all) => all.map((s) => s.textContent)),
    laws.map((l) => `${l.law} ${l.statement}`),
  );
  await page.context().close();
});

test("a law runs here, by keyboard, with its verdict, its time and the wrong subjects that it catches", async () => {
  const page = await open();
  const section = page.locator("#laws");
  await section.getByLabel("Filter").fill("traverse.decision");
  assert.match((await section.locator(".count").textContent())!, /^1 of \d+ laws/);
  await section.getByLabel("wrong on purpose").check();
  await section.locator(".law:not([hidden]) summary").press("Enter");
  const law = section.locator(".law[data-law='traverse.decision']");
  await law.getByRole("button", { name: "Run traverse.decision here" }).press("Enter");
  await done(law);
  const rows = await law.locator("tbody tr").evaluateAll((all) => all.map((r) => [...r.children].map((c) => c.textContent!)));
  assert.ok(rows.length >= 2);
  for (const row of rows) {
    assert.equal(row[0], "traverse.decision");
    assert.match(row[4]!, /proved/);
    assert.match(row[5]!, /\d (ns|µs|ms|s)$/);
  }
  const caught = /Of (\d+) subjects? that (?:is|are) wrong on purpose, (\d+) (?:was|were) refuted/.exec((await law.textContent())!)!;
  assert.ok(Number(caught[1]) > 0 && caught[1] === caught[2]);
  await page.context().close();
});

test("a law that needs the native program says why", async () => {
  const page = await open();
  const section = page.locator("#laws");
  await section.getByLabel("Filter").fill("index.all_levels");
  await section.locator(".law:not([hidden]) summary").click();
  const law = section.locator(".law[data-law='index.all_levels']");
  await law.getByText("Not here: ").waitFor();
  assert.match((await law.textContent())!, /Not here: A prover, z3/);
  assert.equal(await law.getByRole("button").count(), 0);
  await page.context().close();
});
