// For everybody: keys, names, widths, colours, contrast. With everything on the page that it can show.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";

import type { Page } from "playwright-core";

import { done, open } from "./browser";

/** A scene judged, a function refuted, a law run: once, and looked at in all ways. */
async function fill(): Promise<Page> {
  const page = await open();
  await page.getByRole("button", { name: "Use the suite's own scene" }).click();
  await done(page.locator("#scene"));
  await page.getByLabel("Time limit").fill("200");
  await page.getByLabel("Levels 0 to").fill("3");
  await page.getByLabel("Example").selectOption({ label: "wrong: breaks ties otherwise" });
  await page.getByRole("button", { name: "Judge it" }).click();
  await done(page.locator("#function"));
  await page.getByLabel("Filter").last().fill("index.bijective");
  await page.locator(".law:not([hidden]) summary").first().click();
  await page.locator(".law[open]").getByRole("button", { name: /^Run/ }).click();
  await done(page.locator(".law[open]"));
  await page.locator("details.other summary").click();
  return page;
}
let made: Promise<Page> | undefined;
const filled = (): Promise<Page> => (made ??= fill());

async function become(page: Page, width: number, colorScheme: "light" | "dark"): Promise<void> {
  await page.setViewportSize({ width, height: 900 });
  await page.emulateMedia({ colorScheme });
  await page.waitForFunction((scheme) => document.documentElement.dataset["theme"] === scheme, colorScheme);
  await page.waitForTimeout(300);
}

test("narrow and wide, light and dark: nothing scrolls sideways but tables within their boxes", async () => {
  const page = await filled();
  for (const width of [400, 1280])
    for (const scheme of ["light", "dark"] as const) {
      await become(page, width, scheme);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
      const shots = process.env["MMVERIFY_SHOTS"];
      if (shots)
        for (const id of ["header", "#scene", "#function", "#laws", "#curves"])
          await page.locator(id).first().screenshot({ path: join(shots, `${id.replace("#", "")}-${width}-${scheme}.png`) });
    }
});

test("keys reach everything, and every control has a name", async () => {
  const page = await filled();
  const wanted = await page.$$eval("button, select, input, textarea, summary, a[href], canvas[tabindex], .scrolls", (all) =>
    all.filter((e) => (e as HTMLElement).checkVisibility()).map((e) => ((e as HTMLElement).dataset["reached"] = "no")).length,
  );
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  for (let k = 0; k < wanted + 30; ++k) {
    await page.keyboard.press("Tab");
    await page.evaluate(() => ((document.activeElement as HTMLElement).dataset["reached"] = "yes"));
  }
  assert.deepEqual(await page.$$eval("[data-reached=no]", (all) => all.map((e) => `${e.tagName} ${e.className} ${e.textContent}`)), []);
  const nameless = await page.$$eval("button, select, input, textarea, canvas[tabindex]", (all) =>
    all.filter((e) => !(e.getAttribute("aria-label") ?? e.textContent ?? "").trim() && !(e.id && document.querySelector(`label[for="${e.id}"]`))).map((e) => e.outerHTML),
  );
  assert.deepEqual(nameless, []);
});

test("words have contrast of 4.5 to 1, light and dark", async () => {
  const page = await filled();
  for (const scheme of ["light", "dark"] as const) {
    await become(page, 1280, scheme);
    const poor = await page.evaluate(() => {
      const channels = (colour: string) => /rgba?\(([^)]+)\)/.exec(colour)?.[1]!.split(/[ ,/]+/).map(Number);
      const luminance = (c: number[]) => {
        const [r, g, b] = c.slice(0, 3).map((x) => (x / 255 <= 0.03928 ? x / 255 / 12.92 : ((x / 255 + 0.055) / 1.055) ** 2.4));
        return 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;
      };
      const found: string[] = [];
      for (const e of document.querySelectorAll("p, a, li, td, th, dt, dd, button, label, h1, h2, h3, summary, figcaption, caption, code, strong, textarea, .verdict")) {
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
  }
});
