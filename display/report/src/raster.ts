// A picture of the micro-triangles, pixel by pixel: what it costs is a matter of pixels, not of how many there are.

/** The plane in which the base triangle is equilateral: w at (0, 0), u at (1, 0), v at (1/2, slope), y upwards. */
export const slope = Math.sqrt(3) / 2;

/** The middle of the picture, in that plane, and pixels to a unit of it. */
export interface View {
  x: number;
  y: number;
  scale: number;
}

/** Barycentrics to pixels of a picture of this size. */
export function toPixel(view: View, width: number, height: number, u: number, v: number): [number, number] {
  return [width / 2 + (u + v / 2 - view.x) * view.scale, height / 2 - (v * slope - view.y) * view.scale];
}

/** Pixels to barycentrics. */
export function toPoint(view: View, width: number, height: number, px: number, py: number): [number, number] {
  const v = (view.y - (py - height / 2) / view.scale) / slope;
  return [view.x + (px - width / 2) / view.scale - v / 2, v];
}

/** How a kind of micro-triangle is filled: one colour, or two by a pattern, so that colour never speaks alone. */
export type Pattern = "plain" | "hatch" | "dots" | "rows";
export interface Fill {
  pattern: Pattern;
  paper: number;
  ink: number;
}

/** Whether a pixel of a pattern is inked; `unit` is the size of a pixel of the page. */
function inked(pattern: Pattern, x: number, y: number, unit: number): boolean {
  const px = Math.floor(x / unit), py = Math.floor(y / unit);
  switch (pattern) {
    case "plain":
      return false;
    case "hatch":
      return (px + py) % 7 < 3;
    case "dots":
      return px % 6 < 2 && py % 6 < 2;
    case "rows":
      return py % 6 < 2;
  }
}

/** Fills a picture: every pixel whose middle lies in the base triangle gets the fill of its micro-triangle, every other one
 * 0. `kind` names the fill of a micro-triangle and is asked once for every run of pixels along a row. */
export function paint(
  pixels: Uint32Array,
  width: number,
  height: number,
  view: View,
  level: number,
  unit: number,
  fills: readonly Fill[],
  kind: (i: number, j: number, inverted: boolean) => number,
): void {
  const N = 2 ** level;
  for (let y = 0; y < height; ++y) {
    const row = y * width;
    const [u0, v] = toPoint(view, width, height, 0.5, y + 0.5);
    if (v < 0 || v > 1) {
      pixels.fill(0, row, row + width);
      continue;
    }
    const b = v * N;
    const j = Math.min(Math.floor(b), N - 1);
    const fj = b - j;
    const by = N / view.scale;
    // Pixels whose u lies in [0, 1 - v].
    const from = Math.max(0, Math.ceil((-u0 * N) / by));
    const to = Math.min(width, Math.ceil(((1 - v - u0) * N) / by));
    if (from >= to) {
      pixels.fill(0, row, row + width);
      continue;
    }
    pixels.fill(0, row, row + from);
    pixels.fill(0, row + to, row + width);
    let i = -1;
    let inverted = false;
    let fill: Fill = fills[0]!;
    for (let x = from; x < to; ++x) {
      const a = u0 * N + x * by;
      let ni = Math.floor(a);
      if (ni + j > N - 1) ni = N - 1 - j;
      const upper = a - ni + fj >= 1 && ni + j < N - 1;
      if (ni !== i || upper !== inverted) {
        i = ni;
        inverted = upper;
        fill = fills[kind(i, j, inverted)]!;
      }
      pixels[row + x] = fill.pattern !== "plain" && inked(fill.pattern, x, y, unit) ? fill.ink : fill.paper;
    }
  }
}
