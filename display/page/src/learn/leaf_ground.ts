// The ground of the leaf: what each micro-triangle is called, by the rule or by its middle alone.
import { stateFills } from "../../../report/src/fills";
import { named } from "../../../report/src/palette";
import { slope } from "../../../report/src/raster";
import { microOf } from "../walk/steps";
import type { Ground } from "../walk/walker";
import { centreOnLeaf, leaf, type State, stateByCentre, stateByRule, states } from "./half_covered";

export type Way = "rule" | "centre";

const words: Record<State, string> = {
  [states.transparent]: "transparent: no leaf in it. A ray goes on, and no shader is called.",
  [states.opaque]: "opaque: leaf everywhere in it. A ray stops, and no shader is called.",
  [states.unknownTransparent]: "unknown: the edge of the leaf goes through it, its middle is beside the leaf. A shader reads the texture.",
  [states.unknownOpaque]: "unknown: the edge of the leaf goes through it, its middle is on the leaf. A shader reads the texture.",
};

function wrongWords(rule: State, onLeaf: boolean): string {
  if (rule === states.opaque || rule === states.transparent) return "";
  return onLeaf
    ? " Its middle alone says opaque: a ray that meets its empty part would stop in the air."
    : " Its middle alone says transparent: a ray that meets its leafy part would fly through, and the leaf has a hole.";
}

export function leafGround(way: () => Way): Ground {
  const state = (i: number, j: number, inverted: boolean, level: number): State =>
    (way() === "rule" ? stateByRule : stateByCentre)({ i, j, inverted }, level);
  return {
    name: "A leaf on the triangle",
    levels: [0, 7],
    step: "micro",
    numbers: false,
    order: () => null,
    colours: (level) => {
      const fills = stateFills();
      const all = ["transparent", "opaque", "unknown, its middle beside the leaf", "unknown, its middle on the leaf"];
      return {
        fills,
        kind: (i, j, inverted) => state(i, j, inverted, level),
        legend: fills.map((fill, k) => ({ fill, words: all[k]! })).slice(0, way() === "rule" ? 4 : 2),
      };
    },
    describe: (at, level) => {
      const m = microOf(at, level);
      const rule = stateByRule(m, level);
      return way() === "rule" ? `This one is ${words[rule]}` : `Called ${stateByCentre(m, level) === states.opaque ? "opaque" : "transparent"}.${wrongWords(rule, centreOnLeaf(m, level)) || " That is right."}`;
    },
    over: ({ c, view }, pixel) => {
      const [x, y] = pixel(leaf.x - leaf.y / slope / 2, leaf.y / slope);
      c.beginPath();
      c.arc(x, y, leaf.r * view.scale, 0, 2 * Math.PI);
      c.strokeStyle = named("paper");
      c.lineWidth = 5;
      c.stroke();
      c.strokeStyle = named("ink");
      c.lineWidth = 2;
      c.stroke();
    },
  };
}
