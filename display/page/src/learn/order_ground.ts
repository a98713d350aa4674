// The ground of the explanation: the order of micro-triangles, and what a tie is.
import { indexOf, type Micro, microOfIndex, type Order } from "../../../report/src/curve";
import { grouped } from "../../../report/src/format";
import { named, wordOf } from "../../../report/src/palette";
import type { Fill } from "../../../report/src/raster";
import { outline } from "../walk/mark";
import { type At, microOf } from "../walk/steps";
import { placeOf, touching } from "../walk/touching";
import type { Ground } from "../walk/walker";
import { rowPlace } from "./rows";

/** 3/16 as a text, reduced. */
export function fraction(k: number, of: number): string {
  if (k === 0) return "0";
  while (k % 2 === 0 && of % 2 === 0) [k, of] = [k / 2, of / 2];
  return of === 1 ? String(k) : `${k}/${of}`;
}

export function coordinates(at: At, level: number): string {
  const quarters = 4 * 2 ** level;
  return `u ${fraction(at.ku, quarters)}, v ${fraction(at.kv, quarters)}, w ${fraction(quarters - at.ku - at.kv, quarters)}`;
}

const plain = (hex: string): Fill => ({ pattern: "plain", paper: wordOf(hex), ink: wordOf(hex) });
const indices = (all: Micro[], level: number, order: Order): number[] => all.map((m) => indexOf(m, level, order)).sort((a, b) => a - b);
const list = (numbers: number[]): string => (numbers.length < 2 ? numbers.join() : `${numbers.slice(0, -1).map(grouped).join(", ")} and ${grouped(numbers.at(-1)!)}`);

export function tieWords(at: At, level: number, order: Order): string {
  const all = touching(at, level);
  const own = grouped(order === "curve" ? indexOf(microOf(at, level), level, order) : rowPlace(at, level).index);
  const place = placeOf(at);
  if (place === "inside") return `Inside micro-triangle ${own}.`;
  if (all.length === 1) return `On ${place === "edge" ? "an edge" : "a corner"} of the base triangle, of micro-triangle ${own} alone: no tie.`;
  return `A tie: on ${place === "edge" ? "the edge" : "the corner"} that ${list(indices(all, level, order))} share. ${order === "curve" ? "The reference" : "Figure 4 of the paper on attribute micromaps"} gives it to ${own}.`;
}

export function orderGround(order: Order, moved: (at: At, level: number) => void): Ground {
  return {
    name: order === "curve" ? "The triangle and its curve" : "The triangle and its rows",
    levels: [0, 6],
    step: "quarter",
    numbers: true,
    order: () => order,
    colours: () => {
      const paper = plain(document.documentElement.dataset["theme"] === "dark" ? "#1d3f56" : "#e4f0f8");
      return { fills: [paper], kind: () => 0, legend: [] };
    },
    describe: (at, level) => `${coordinates(at, level)}. ${tieWords(at, level, order)}`,
    moved,
    owner: order === "rows" ? (at, level) => microOfIndex(rowPlace(at, level).index, level, order) : microOf,
    over: ({ c, level }, pixel, at) => {
      const all = touching(at, level);
      if (all.length < 2) return;
      c.setLineDash([6, 4]);
      c.strokeStyle = named("wrong");
      c.lineWidth = 2.5;
      for (const m of all) {
        outline(c, m, level, pixel);
        c.stroke();
      }
      c.setLineDash([]);
    },
  };
}
