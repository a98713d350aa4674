// A scene's plan: what is baked, what is left out and why.
import { type Report, type Scene, scenes } from "./data";
import { el, plainTable } from "./dom";
import { grouped, percent, plural, seconds, short } from "./format";

/** A bar in parts; each part has its pattern, words and number in a list below, so that the bar says nothing alone. */
function bar(label: string, parts: { words: string; n: number; look: string }[]): HTMLElement {
  const all = parts.reduce((sum, p) => sum + p.n, 0);
  if (all === 0) return el("p", {}, `${label}: none.`);
  const made = el("div", { class: "bar", "aria-hidden": "true" });
  for (const p of parts)
    if (p.n > 0) {
      const piece = el("span", { class: `piece ${p.look}`, title: `${p.words}: ${grouped(p.n)}` });
      piece.style.flexGrow = String(p.n);
      made.append(piece);
    }
  return el(
    "figure",
    {},
    el("figcaption", {}, label),
    made,
    el("ul", { class: "legend" }, ...parts.map((p) => el("li", { class: "entry" }, el("span", { class: `patch piece ${p.look}` }), `${p.words}: ${grouped(p.n)} (${percent(p.n / all)})`))),
  );
}

function onePlan(name: string, scene: Scene): HTMLElement {
  const { plan, bake } = scene;
  const why = new Map<string, { triangles: number; primitives: number }>();
  for (const l of plan.left_out) {
    const sum = why.get(l.why) ?? { triangles: 0, primitives: 0 };
    why.set(l.why, { triangles: sum.triangles + l.triangles, primitives: sum.primitives + 1 });
  }
  const box = el(
    "div",
    {},
    el("h3", {}, scene.file, el("span", { class: "from" }, ` from ${name}`)),
    el(
      "p",
      {},
      `${plural(plan.triangles, "triangle")}, ${grouped(plan.triangles_placed)} as nodes place them. ` +
        (plan.baked_triangles === 0
          ? "Nothing to bake."
          : `${grouped(plan.baked_triangles)} to bake, ${grouped(plan.baked_triangles_placed)} as placed; ${grouped(plan.distinct_triangles)} maps are enough, as the others are the same piece of texture` +
            `${plan.reordered_triangles > 0 ? `, ${grouped(plan.reordered_triangles)} of them with their vertices in another order` : ""}.`),
    ),
    bar("Triangles", [
      { words: "baked, one map each", n: plan.distinct_triangles, look: "opaque" },
      { words: "share another's map", n: Math.max(0, plan.baked_triangles - plan.distinct_triangles), look: "unknown-transparent" },
      { words: "left out", n: Math.max(0, plan.triangles - plan.baked_triangles), look: "transparent" },
    ]),
  );
  const tables = el("div", { class: "charts" });
  if (plan.surfaces.length > 0)
    tables.append(
      plainTable(
        "Surfaces",
        ["Image", "Size", "Mode", "Filter", "Cutoff", "Factor"],
        plan.surfaces.map((s) => [s.image, `${s.width} x ${s.height}`, s.mode, s.filter ?? "", s.mode === "MASK" ? short(s.cutoff) : "", short(s.factor)]),
      ),
    );
  if (why.size > 0)
    tables.append(
      plainTable(
        "Left out",
        ["Why", "Primitives", "Triangles"],
        [...why].sort((a, b) => b[1].triangles - a[1].triangles).map(([words, n]) => [words, grouped(n.primitives), grouped(n.triangles)]),
      ),
    );
  if (plan.left_out_laws && plan.left_out_laws.length > 0)
    tables.append(plainTable("Laws left out", ["What", "Why"], plan.left_out_laws.map((l) => [l.what, l.why])));
  box.append(tables);
  if (bake) {
    tables.append(
      plainTable(
        "Levels",
        ["Level", "Maps"],
        Object.entries(bake.triangles_by_level)
          .sort((a, b) => Number(a[0]) - Number(b[0]))
          .map(([n, maps]) => [n, grouped(maps)]),
      ),
    );
    box.append(
      bar(`States of ${plural(bake.micro_triangles, "micro-triangle")}`, [
        { words: "opaque", n: bake.states.O, look: "opaque" },
        { words: "unknown, opaque", n: bake.states.UO, look: "unknown-opaque" },
        { words: "unknown, transparent", n: bake.states.UT, look: "unknown-transparent" },
        { words: "transparent", n: bake.states.T, look: "transparent" },
      ]),
      el("p", { class: "note" }, `Loaded in ${seconds(bake.load_seconds)}, baked in ${seconds(bake.bake_seconds)}; whole numbers decided ${grouped(bake.exact)} of ${grouped(bake.leaves)} leaves${bake.lowered > 0 ? `; ${plural(bake.lowered, "triangle")} at a lower level, for memory` : ""}.`),
    );
  }
  if (scene.saved)
    box.append(el("p", {}, `No shader is called on ${percent(scene.saved.transparent + scene.saved.opaque)} of the placed area: ${percent(scene.saved.transparent)} transparent, ${percent(scene.saved.opaque)} opaque.`));
  return box;
}

export const planSections = (report: Report): HTMLElement[] => scenes(report).map(({ name, scene }) => onePlan(name, scene));
