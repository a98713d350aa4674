// What rays of a scene met: any-hit calls by method and level, what that takes, and where they were called.
import { chart, type Series } from "./chart";
import { benches, type Rendered, type RenderedRow, type Report } from "./data";
import { el, plainTable } from "./dom";
import { bytes, grouped, percent, plural, short } from "./format";

const levelOf = (row: RenderedRow) => (row.level === undefined ? "" : String(row.level));

/** The rows of maps of one method that has levels, where there are two levels or more; the others as level lines. */
export function callsByLevel(run: Rendered): Series[] {
  const levels = [...new Set(run.rows.flatMap((r) => (r.level === undefined ? [] : [r.level])))];
  if (levels.length < 2) return [];
  const words = (row: RenderedRow, level: number) => [
    `${row.method}, level ${level}`,
    `${grouped(row.any_hit)} any-hit calls`,
    `${short(row.any_hit_a_ray)} a ray`,
    `${percent(row.known)} known`,
  ];
  return [...new Set(run.rows.map((r) => r.method))].map((method) => {
    const of = run.rows.filter((r) => r.method === method);
    const marks = levels.flatMap((level) => {
      const row = of.find((r) => r.level === level) ?? (of[0]!.level === undefined ? of[0] : undefined);
      return row ? [{ x: level, y: row.any_hit_a_ray, words: words(row, level) }] : [];
    });
    return { name: method, line: true, dashed: of[0]!.level === undefined, marks };
  });
}

export const rayRows = (run: Rendered): string[][] =>
  run.rows.map((r) => [
    r.method, levelOf(r), grouped(r.any_hit), short(r.any_hit_a_ray), percent(r.known),
    r.predicted === undefined ? "" : percent(r.predicted), r.even === undefined ? "" : percent(r.even), bytes(r.bytes), short(r.times_texture), grouped(r.differing),
  ]);

function picture(report: Report, file: number, run: Rendered): (HTMLElement | null)[] {
  return (run.pictures ?? []).map((p, k) => {
    const found = report.pictures.find((shown) => shown.file === file && shown.picture === k);
    const words =
      p.shows === "heat"
        ? "Any-hit calls of each pixel's primary and shadow ray, method by method: dark blue where none was called; the scale is below"
        : p.shows === "blended"
          ? "What the rays see where hits blend their colours, and end on nothing but what has no alpha to test"
          : "What the rays see: each material in a colour of its own, or in its attribute micromaps";
    if (found?.png === undefined) return el("p", { class: "note" }, `The picture ${p.file} is not here: ${found?.why ?? "no reason known"}.`);
    return el(
      "figure",
      {},
      el("div", { class: "scrolls", tabindex: "0", role: "region", "aria-label": words }, el("div", { class: p.shows === "heat" ? "sheet" : "" }, el("img", { class: p.shows === "heat" ? "" : "picture", src: `data:image/png;base64,${found.png}`, alt: words }))),
      el("figcaption", { class: "note" }, `${words}.`),
    );
  });
}

function oneRun(report: Report, file: number, name: string, run: Rendered): HTMLElement {
  const series = callsByLevel(run), differing = run.rows.reduce((sum, r) => sum + r.differing, 0);
  return el(
    "div",
    {},
    el("h3", {}, run.file, el("span", { class: "from" }, ` from ${name}`)),
    el(
      "p",
      {},
      `${plural(run.rays, "primary ray")} and ${plural(run.shadow_rays, "shadow ray")} by ${run.tool.embree}; ${plural(run.tested_placed, "triangle")} placed with micromaps. ` +
        (differing === 0 ? "No pixel of any method differs from the texture's." : `${plural(differing, "pixel")} differ from the texture's.`),
    ),
    series.length > 0
      ? el("div", { class: "charts" }, chart({ title: "Any-hit calls a ray by level", note: "Forms of one map call alike; square maps and the texture have no level.", x: { label: "level of every map", whole: true }, y: { label: "any-hit calls a ray" }, series }))
      : null,
    plainTable("Rays", ["Method", "Level", "Any-hit calls", "A ray", "Known", "Predicted", "Even rays", "Bytes", "Time, texture = 1", "Differing"], rayRows(run)),
    ...picture(report, file, run),
  );
}

export const raySections = (report: Report): HTMLElement[] => benches(report, "render").map(({ file, name, content }) => oneRun(report, file, name, content));
