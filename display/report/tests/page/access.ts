// For everybody: keys, names, widths, colours, contrast.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";

import { open, picture, settled } from "./browser";

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
