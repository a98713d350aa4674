// Beside the picture: what is shown, how many, and where the pointer is.
import { el, fresh, select } from "../../report/src/dom";
import { grouped, percent, plural } from "../../report/src/format";
import type { Mapped } from "./load";
import { countsOf, microOf } from "./maps";
import type { Hit, Stage, Underneath } from "./stage";
import { tints } from "./tints";

/** Levels and states of all triangles; a special index is a triangle of level 0. */
export function total(mapped: Mapped[]) {
  const levels = new Map<number, number>(), states = [0, 0, 0, 0];
  let triangles = 0, special = 0;
  for (const entry of mapped.filter(({ first }) => first).flatMap(({ entries }) => entries)) {
    if (!entry) continue;
    ++triangles;
    if ("state" in entry) ++special;
    const level = "state" in entry ? 0 : entry.record.level;
    levels.set(level, (levels.get(level) ?? 0) + 1);
    countsOf(entry).forEach((count, k) => (states[k]! += count));
  }
  return { triangles, special, levels: [...levels].sort(([a], [b]) => a - b), states };
}

function checkbox(words: (Node | string)[], act: () => void): { box: HTMLElement; input: HTMLInputElement } {
  const id = fresh("box"), input = el("input", { id, type: "checkbox", checked: "" });
  input.addEventListener("change", act);
  return { input, box: el("span", { class: "field" }, input, el("label", { for: id }, ...words)) };
}

function swatch(k: number): HTMLElement {
  const square = el("span", { class: "swatch", "aria-hidden": "true" });
  square.style.background = tints[k]!.word;
  return square;
}

/** "mesh 0 primitive 1 triangle 12: record 5 of level 4; micro-triangle 37: T, transparent" */
export function wordsOf(hit: Hit | null): string {
  if (!hit) return "Point at a triangle.";
  const entry = hit.of.entries[hit.triangle] ?? null, micro = microOf(entry, hit.u, hit.v);
  if (!entry || !micro) return `${hit.of.what} triangle ${hit.triangle}: its index names no record`;
  const { sign, words } = tints[micro.state];
  const of = "state" in entry ? "special index" : `record ${entry.number} of level ${micro.level}; micro-triangle ${grouped(micro.index)} of ${grouped(4 ** micro.level)}`;
  return `${hit.of.what} triangle ${hit.triangle}: ${of}: ${sign}, ${words}`;
}

export function panel(stage: Stage, mapped: Mapped[]): HTMLElement {
  const { triangles, special, levels, states } = total(mapped);
  const sum = states.reduce((a, b) => a + b, 0);
  const rows = tints.map(({ sign, words }, k) =>
    checkbox([swatch(k), el("b", {}, sign), ` ${words}`, el("span", { class: "count" }, `${grouped(states[k]!)} · ${percent(states[k]! / Math.max(sum, 1))}`)], () => change()));
  const id = fresh("strength");
  const strength = el("input", { id, type: "range", min: "0", max: "1", step: "0.05", value: "0.5" });
  const lines = checkbox(["Edges of micro-triangles"], () => change());
  const change = (): void => stage.uniforms(Number(strength.value), lines.input.checked, rows.map(({ input }) => input.checked));
  strength.addEventListener("input", change);
  const names = stage.textures.map((texture, k) => texture.name || mapped.find(({ material }) => material.map === texture)?.material.name || `texture ${k}`);
  const views = select("View", [{ value: "", words: "the scene" }, ...names.map((words, k) => ({ value: String(k), words: `flat, on ${words}` }))], (value) => {
    stage.show(value === "" ? null : stage.textures[Number(value)]!);
    stage.underneath(under.list.value as Underneath);
  });
  const under = select("Texture", ["as rendered", "whole", "none"].map((words) => ({ value: words, words })), (value) => stage.underneath(value as Underneath));
  const readout = el("output", { class: "readout", "aria-live": "polite" }, wordsOf(null));
  stage.canvas.addEventListener("pointermove", ({ offsetX, offsetY }) => {
    // The middle of the pixel, as the picture is drawn.
    readout.textContent = wordsOf(stage.hit((Math.floor(offsetX) + 0.5) / stage.canvas.clientWidth, (Math.floor(offsetY) + 0.5) / stage.canvas.clientHeight));
  });
  return el(
    "div",
    { class: "maps" },
    el("p", { class: "total" }, `${plural(triangles, "triangle")} with maps; by level ${levels.map(([level, count]) => `${level}: ${grouped(count)}`).join(", ")}; ${grouped(special)} of them special indices.`),
    el("div", { class: "states", role: "group", "aria-label": "States" }, ...rows.map(({ box }) => box)),
    el("div", { class: "tools" }, el("span", { class: "field" }, el("label", { for: id }, "Tint"), strength), lines.box),
    el("div", { class: "tools" }, views.box, under.box),
    readout,
  );
}
