// Views of a scene shaded by attribute micromaps, beside those shaded by its textures.
import { benches, type Report, type Views } from "./data";
import { el, plainTable } from "./dom";
import { plural, short } from "./format";

export const viewRows = (run: Views): string[][] =>
  run.rows.map((r) => [r.from, String(r.level), short(r.flip), short(r.textured_flip), short(r.textured_rmse)]);

function pictures(report: Report, file: number, run: Views): (HTMLElement | null)[] {
  return run.rows.map((row, k) => {
    if (row.picture === undefined) return null;
    const found = report.pictures.find((shown) => shown.file === file && shown.picture === k);
    const words = `Textures, maps of ${row.from} at level ${row.level}, and FLIP between them`;
    if (found?.png === undefined) return el("p", { class: "note" }, `The picture ${row.picture} is not here: ${found?.why ?? "no reason known"}.`);
    return el(
      "figure",
      {},
      el("div", { class: "scrolls", tabindex: "0", role: "region", "aria-label": words }, el("div", { class: "sheet" }, el("img", { src: `data:image/png;base64,${found.png}`, alt: words }))),
      el("figcaption", { class: "note" }, `${words}.`),
    );
  });
}

function oneRun(report: Report, file: number, name: string, run: Views): HTMLElement {
  const { width, height, rays, shading, embree } = run.tool;
  return el(
    "div",
    {},
    el("h3", {}, run.file, el("span", { class: "from" }, ` from ${name}`)),
    el("p", {}, `${width} x ${height} pixels, ${plural(rays, "primary ray")} each, ${shading}, by ${embree}. Rays met ${plural(run.textured_triangles, "triangle")} with a texture, in ${plural(run.textured_pixels, "pixel")}.`),
    plainTable("Views", ["Maps of", "Level", "FLIP", "FLIP, textured", "RMSE, textured"], viewRows(run)),
    el("p", { class: "note" }, "FLIP: the mean over all pixels, 0 to 1. Textured: over the pixels that show a texture. RMSE: of codes of 8 bits."),
    ...pictures(report, file, run),
  );
}

export const viewSections = (report: Report): HTMLElement[] => benches(report, "views").map(({ file, name, content }) => oneRun(report, file, name, content));
