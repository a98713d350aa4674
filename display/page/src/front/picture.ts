// The first picture: a leaf and the states of its micro-triangles.
import { el } from "../../../report/src/dom";
import { drawGrid, type Stage, wholeView } from "../../../report/src/overlay";
import { paint, toPixel } from "../../../report/src/raster";
import { onTheme } from "../../../report/src/theme";
import { patch } from "../../../report/src/triangle";
import { leafGround } from "../learn/leaf_ground";

const level = 4;
const size = { width: 340, height: 330 };

function draw(canvas: HTMLCanvasElement): void {
  const ground = leafGround(() => "rule");
  const { fills, kind } = ground.colours(level);
  const c = canvas.getContext("2d")!;
  const { width, height } = canvas;
  const image = c.createImageData(width, height);
  const view = wholeView(size.width, size.height);
  const scale = width / size.width;
  paint(new Uint32Array(image.data.buffer), width, height, { ...view, scale: view.scale * scale }, level, scale, fills, kind);
  c.setTransform(1, 0, 0, 1, 0, 0);
  c.putImageData(image, 0, 0);
  c.setTransform(scale, 0, 0, scale, 0, 0);
  const stage: Stage = { c, view, ...size, level, order: "curve" };
  drawGrid(stage);
  ground.over!(stage, (u, v) => toPixel(view, size.width, size.height, u, v), { ku: 1, kv: 1 });
}

export function frontPicture(): HTMLElement {
  const canvas = el("canvas", { role: "img", "aria-label": `A round leaf on a triangle of ${4 ** level} micro-triangles, each in the colour of its state` });
  [canvas.width, canvas.height] = [2 * size.width, 2 * size.height];
  const legend = el("span", { class: "legend" });
  const all = () => {
    draw(canvas);
    const { fills } = leafGround(() => "rule").colours(level);
    const entry = (k: number, words: string) => el("span", { class: "entry" }, patch(fills[k]!), words);
    legend.replaceChildren(entry(1, "opaque: a ray stops"), entry(0, "transparent: it goes on"), entry(2, "unknown: a shader reads the texture"));
  };
  all();
  onTheme(all);
  return el("figure", { class: "front" }, canvas, el("figcaption", {}, legend));
}
