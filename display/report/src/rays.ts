// What rays of a scene met: any-hit calls by method and level, what that takes, and where they were called.
import { chart, type Series } from "./chart";
import { benches, type Rendered, type RenderedRow, type Report } from "./data";
import { el, plainTable } from "./dom";
import { bytes, grouped, percent, plural, short } from "./format";
import { pathSection } from "./render_path";

const levelOf = (row: { level?: number }) => (row.level === undefined ? "" : String(row.level));

const sum = (rows: readonly { differing: number }[]) => rows.reduce((all, r) => all + r.differing, 0);

/** Pixels that differ from the texture's, of methods and of blends. */
export const differingPixels = (run: Rendered): number => sum(run.rows) + sum(run.blends ?? []);

/** What was held against the texture, and how many pixels differ. */
export function differingWords(run: Rendered): string {
  const blends = run.blends ?? [];
  if (![...run.rows, ...blends].some((r) => r.method !== "texture")) return "Nothing was held against the texture.";
  if (differingPixels(run) === 0) return `No pixel of any method${blends.length > 0 ? " or blend" : ""} differs from the texture's.`;
  const n = differingPixels(run);
  return `${plural(n, "pixel")} ${n === 1 ? "differs" : "differ"} from the texture's${sum(blends) > 0 ? `, ${grouped(sum(blends))} of them where hits blend` : ""}.`;
}

/** Rows whose last column counts what differs: a count other than 0 stands out. */
export const standingOut = (rows: string[][]): (string | Node)[][] =>
  rows.map((row) => (row.at(-1) === "0" ? row : [...row.slice(0, -1), el("strong", { class: "wrong" }, row.at(-1)!)]));

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

export const blendRows = (run: Rendered): string[][] =>
  (run.blends ?? []).map((r) => [
    r.method, levelOf(r), r.by === "fixed" ? "fixed function" : "shader", grouped(r.ignored), grouped(r.fixed), grouped(r.any_hit), percent(r.saved), grouped(r.spoiled), short(r.times_texture), grouped(r.differing),
  ]);

const columns =
  "A ray: any-hit calls over all rays. Known: the share of candidates on triangles with micromaps that a map decides. Predicted: the share of these triangles' area where maps decide, reckoned without a ray. Even rays: the share that lines of all directions through all of the scene met.";

function blends(run: Rendered): HTMLElement[] {
  if (run.blends === undefined) return [];
  return [
    plainTable(`Hits that blend by ${run.tool.blend ?? "an operation not named"}`, ["Method", "Level", "O blended by", "Ignored", "Fixed", "Any-hit calls", "Saved", "As met", "Time, texture = 1", "Differing"], standingOut(blendRows(run))),
    el("p", { class: "note" }, "O blended by: who blends what maps call opaque. Fixed: hits that the fixed function blends. Saved: the share of the texture's any-hit calls that are not made. As met: pixels whose payload would be another one, were hits blended in the order of traversal."),
  ];
}

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
  const series = callsByLevel(run), words = differingWords(run);
  return el(
    "div",
    {},
    el("h3", {}, run.file, el("span", { class: "from" }, ` from ${name}`)),
    el(
      "p",
      {},
      `${plural(run.rays, "primary ray")} and ${plural(run.shadow_rays, "shadow ray")} by ${run.tool.embree}; ${plural(run.tested_placed, "triangle")} placed with micromaps. `,
      differingPixels(run) === 0 ? words : el("strong", { class: "wrong" }, words),
    ),
    series.length > 0
      ? el("div", { class: "charts" }, chart({ title: "Any-hit calls a ray by level", note: "Forms of one map call alike; square maps and the texture have no level.", x: { label: "level of every map", whole: true }, y: { label: "any-hit calls a ray" }, series }))
      : null,
    plainTable("Rays", ["Method", "Level", "Any-hit calls", "A ray", "Known", "Predicted", "Even rays", "Bytes", "Time, texture = 1", "Differing"], standingOut(rayRows(run))),
    el("p", { class: "note" }, columns),
    ...blends(run),
    ...picture(report, file, run),
  );
}

/** Verdicts first, then figures. */
export const raySections = (report: Report): HTMLElement[] => [
  ...benches(report, "render_path").map(({ name, content }) => pathSection(name, content, standingOut)),
  ...benches(report, "render").map(({ file, name, content }) => oneRun(report, file, name, content)),
];
