// The looks of what `--plot` draws, too: one thing has one colour in both (bench/scene/attribute_picture.cpp,
// bench/attribute/picture.cpp).
import type { Look, Shape } from "./palette";

const blue = 0, vermilion = 1, green = 2, orange = 4, grey = 6;

const hues: [start: string, hue: number][] = [
  ["vertices, Bird", green],
  ["faces", vermilion],
  ["vertices", blue],
  ["textures", grey],
  ["W-minor", blue],
  ["U-major", orange],
  ["Bird", green],
  ["bilinear texture", vermilion],
  ["3x3 by Cramer", vermilion],
  ["two equations", blue],
  ["pattern", orange],
  ["ours, locates too, batched", green],
];

/** Of what is packed or batched the shape differs, the colour does not. */
const shapeOf = (name: string): Shape =>
  name.endsWith(", packed") ? "diamond" : name.endsWith(", batched") || name === "faces" ? "square" : "circle";

/** Nothing where plots have no look of that name. */
export function plotLook(name: string): Look | undefined {
  const found = hues.find(([start]) => name === start || name.startsWith(`${start}, `));
  return found && { colour: found[1], shape: shapeOf(name) };
}
