// Law traverse.same_image on a scene, along a path of cameras: its verdict, and what each form of maps was asked.
import type { RenderPath, Verdict } from "./data";
import { el, plainTable } from "./dom";
import { grouped, plural } from "./format";
import { verdictMark } from "./table";

/** As the run says it, but not applicable where no ray met a map: then nothing was compared. */
export function pathVerdict(run: RenderPath): Verdict {
  if (run.verdict === "refuted" || run.differing > 0) return "refuted";
  return run.rows.some((r) => r.met > 0) ? run.verdict : "not_applicable";
}

export function pathWords(run: RenderPath): string {
  const { width, height, seed, shadows, embree } = run.tool;
  const frames = `${plural(run.cameras.length, "camera")}, ${plural(run.frames, "frame")} of ${width} x ${height}, ${plural(run.pixels, "pixel")} held against the texture's, ${shadows === "yes" ? "with" : "without"} shadow rays, by ${embree}, seed ${seed}; ${plural(run.tested_placed, "triangle")} placed with micromaps.`;
  if (pathVerdict(run) === "not_applicable") return `${frames} No ray met a map, so nothing was compared.`;
  if (run.differing === 0) return `${frames} No pixel differs.`;
  return `${frames} ${plural(run.differing, "pixel")} ${run.differing === 1 ? "differs" : "differ"}.`;
}

export const pathRows = (run: RenderPath): string[][] =>
  run.rows.map((r) => [
    r.method, r.level === undefined ? "" : String(r.level), grouped(r.frames), grouped(r.pixels), grouped(r.met), grouped(r.ignored), grouped(r.opaque), grouped(r.any_hit), grouped(r.differing),
  ]);

export function pathSection(name: string, run: RenderPath, standingOut: (rows: string[][]) => (string | Node)[][]): HTMLElement {
  const cameras = run.cameras.map((c) => [c.camera, c.tries, c.rays, c.shadow_rays, c.met, c.any_hit].map(grouped));
  return el(
    "div",
    {},
    el("h3", {}, verdictMark(pathVerdict(run)), ` ${run.law} on ${run.file}`, el("span", { class: "from" }, ` from ${name}`)),
    el("p", {}, pathWords(run)),
    plainTable("Frames of all cameras", ["Method", "Level", "Frames", "Pixels", "Rays that met a map", "Ignored", "Opaque", "Any-hit calls", "Differing"], standingOut(pathRows(run))),
    el("details", {}, el("summary", {}, "Camera by camera"), plainTable("Cameras of the path", ["Camera", "Places tried", "Primary rays", "Shadow rays", "Rays that met a map", "Any-hit calls of the texture"], cameras)),
  );
}
