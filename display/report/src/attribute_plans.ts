// Attribute micromaps of a scene: levels planned for an error, triangle by triangle, and mips beside those of textures.
import type { SceneAttributes } from "./data";
import { el, plainTable } from "./dom";
import { grouped, percent, short } from "./format";

type Plan = NonNullable<SceneAttributes["plans"]>[number];
type Mip = NonNullable<SceneAttributes["mips"]>[number];

const optional = <T>(x: T | undefined, words: (x: T) => string) => (x === undefined ? "" : words(x));

/** What a plan takes, and how it compares with one level for all triangles: the lowest as close, and between two at equal error. */
export function planRow(plan: Plan): string[] {
  return [
    plan.kind, short(plan.wanted), grouped(plan.special), grouped(plan.maps), grouped(plan.not_kept), grouped(plan.bytes), optional(plan.rmse, short), optional(plan.flip, short),
    optional(plan.uniform?.level, String), optional(plan.uniform?.bytes, grouped), optional(plan.uniform?.plan_to_it, short),
    optional(plan.equal_rmse?.plan_to_it, short), optional(plan.equal_flip?.plan_to_it, short),
  ];
}

/** How many triangles have which level in each plan of a set: a row a plan, a column a level. */
export function planLevelRows(run: SceneAttributes, set: string): { levels: number[]; rows: string[][] } {
  const of = (run.plan_levels ?? []).filter((l) => l.set === set);
  const levels = [...new Set(of.map((l) => l.level))].sort((a, b) => a - b);
  const plans = (run.plans ?? []).filter((p) => p.set === set);
  const at = (plan: Plan, level: number) => of.find((l) => l.kind === plan.kind && l.wanted === plan.wanted && l.level === level);
  return { levels, rows: plans.map((plan) => [plan.kind, short(plan.wanted), grouped(plan.special), ...levels.map((level) => optional(at(plan, level)?.planned, grouped))]) };
}

export function plansTable(run: SceneAttributes, set: string): HTMLElement | null {
  const plans = (run.plans ?? []).filter((p) => p.set === set);
  if (plans.length === 0) return null;
  const { levels, rows } = planLevelRows(run, set);
  const note =
    "Each triangle has the lowest level that keeps the wanted error, in codes of 8 bits, and no map where one value does. Bytes are 4 a value and 5 a triangle. " +
    "As close: the lowest level for all triangles whose error is no more; plan to it: the plan's bytes by those of one level. At equal error: between two levels. Not kept: triangles whose error is more at the last level, too.";
  const head = ["Maps of", "Wanted RMSE", "Without map", "Maps", "Not kept", "Bytes", "RMSE", "FLIP", "Level as close", "Its bytes", "Plan to it", "To equal RMSE", "To equal FLIP"];
  return el(
    "div",
    { class: "wide" },
    el("p", { class: "note" }, note),
    plainTable(`${set}: levels as triangles need them`, head, plans.map(planRow)),
    plainTable(`${set}: triangles of plans, by level`, ["Maps of", "Wanted RMSE", "Without map", ...levels.map((level) => `Level ${level}`)], rows),
  );
}

/** A mip of the texture, and of each kind of maps the level with most nearly as many values. */
export function mipRows(mip: Mip): string[][] {
  const errors = (of: Mip["texture"]) => [short(of.rmse), optional(of.flip, short), optional(of.border_rmse, short), optional(of.interior_rmse, short)];
  const maps = (name: string, of: Mip["faces"]) => [String(mip.mip), `${name}, level ${of.level}`, short(of.values_per_texel), ...errors(of)];
  return [[String(mip.mip), "texture", short(4 ** -mip.mip), ...errors(mip.texture)], maps("faces", mip.faces), maps("vertices", mip.vertices)];
}

export function mipsTable(run: SceneAttributes, set: string): HTMLElement | null {
  const mips = (run.mips ?? []).filter((m) => m.set === set);
  if (mips.length === 0) return null;
  const near = mips.map((m) => `${m.mip}: ${percent(m.border)}`).join(", ");
  const note =
    "Mips of the texture, of the whole image whichever charts its texels are of, beside the maps' own; RMSE in codes of 8 bits, against the texture. " +
    `Border: texels within 2^mip of another chart or of what no triangle shows, of those shown ${near}.`;
  return el(
    "div",
    { class: "wide" },
    el("p", { class: "note" }, note),
    plainTable(`${set}: mips, and what bleeds across charts`, ["Mip", "Of", "Values a texel", "RMSE", "FLIP", "RMSE, border", "RMSE, interior"], mips.flatMap(mipRows)),
  );
}
