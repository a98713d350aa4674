// A square map of a pair of triangles, region by region.
import { el } from "./dom";
import { stateFills } from "./fills";
import { onTheme } from "./theme";

/** T, C and O are filled as transparent, unknown and opaque. */
export function square(map: { side: number; letters: string }): HTMLElement {
  const zoom = Math.floor(256 / map.side);
  const size = zoom * map.side;
  const canvas = el("canvas", { class: "square", role: "img", "aria-label": `The square map: ${map.side} by ${map.side} regions` });
  [canvas.width, canvas.height] = [size, size];
  const draw = () => {
    const fills = stateFills();
    const of: Record<string, (typeof fills)[number]> = { T: fills[0]!, O: fills[1]!, C: fills[3]! };
    const c = canvas.getContext("2d")!;
    const image = c.createImageData(size, size);
    const words = new Uint32Array(image.data.buffer);
    for (let y = 0; y < size; ++y)
      for (let x = 0; x < size; ++x) {
        const fill = of[map.letters[Math.floor(y / zoom) * map.side + Math.floor(x / zoom)]!]!;
        const edge = x % zoom === 0 || y % zoom === 0;
        words[y * size + x] = edge ? fills[0]!.paper : fill.pattern !== "plain" && (x + y) % 5 < 2 ? fill.ink : fill.paper;
      }
    c.putImageData(image, 0, 0);
  };
  draw();
  onTheme(draw);
  return el("figure", {}, el("figcaption", {}, "The square map that was asked about: O filled, C hatched, T empty"), canvas);
}
