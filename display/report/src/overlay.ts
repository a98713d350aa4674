// What is drawn over the colours: grid, order, wrong edges and vertices, the counterexample.
import type { Answers } from "./answers";
import { cornersOf, indexOf, type Micro, microOfIndex, type Order } from "./curve";
import type { Counter } from "./exhibit";
import { named } from "./palette";
import { line, type Window } from "./path";
import { slope, toPixel, toPoint, type View } from "./raster";

export interface Stage {
  c: CanvasRenderingContext2D;
  view: View;
  width: number;
  height: number;
  level: number;
  order: Order;
}

const least = { grid: 5, curve: 7, numbers: 36 };

/** Length of a micro-triangle's side in pixels. */
export const sideOf = (s: Stage): number => s.view.scale / 2 ** s.level;

export function windowOf(s: Stage): Window {
  const points = [
    [0, 0],
    [s.width, 0],
    [0, s.height],
    [s.width, s.height],
  ].map(([x, y]) => toPoint(s.view, s.width, s.height, x!, y!));
  const us = points.map((p) => p[0]);
  const vs = points.map((p) => p[1]);
  return { u0: Math.max(0, Math.min(...us)), u1: Math.min(1, Math.max(...us)), v0: Math.max(0, Math.min(...vs)), v1: Math.min(1, Math.max(...vs)) };
}

const at = (s: Stage, i: number, j: number): [number, number] => toPixel(s.view, s.width, s.height, i / 2 ** s.level, j / 2 ** s.level);

function outline(s: Stage, m: Micro): void {
  const corners = cornersOf(m);
  s.c.beginPath();
  s.c.moveTo(...at(s, corners[0], corners[1]));
  s.c.lineTo(...at(s, corners[2], corners[3]));
  s.c.lineTo(...at(s, corners[4], corners[5]));
  s.c.closePath();
}

const middle = (s: Stage, m: Micro): [number, number] => at(s, m.i + (m.inverted ? 2 : 1) / 3, m.j + (m.inverted ? 2 : 1) / 3);

export function drawGrid(s: Stage): void {
  const { c } = s;
  const N = 2 ** s.level;
  if (sideOf(s) >= least.grid) {
    const w = windowOf(s);
    const clamp = (x: number) => Math.max(0, Math.min(N, x));
    c.beginPath();
    for (let i = clamp(Math.floor(w.u0 * N)); i <= clamp(Math.ceil(w.u1 * N)); ++i) {
      c.moveTo(...at(s, i, 0));
      c.lineTo(...at(s, i, N - i));
    }
    for (let j = clamp(Math.floor(w.v0 * N)); j <= clamp(Math.ceil(w.v1 * N)); ++j) {
      c.moveTo(...at(s, 0, j));
      c.lineTo(...at(s, N - j, j));
    }
    for (let k = clamp(Math.floor((w.u0 + w.v0) * N)); k <= clamp(Math.ceil((w.u1 + w.v1) * N)); ++k) {
      c.moveTo(...at(s, k, 0));
      c.lineTo(...at(s, 0, k));
    }
    c.strokeStyle = named("grid");
    c.lineWidth = sideOf(s) > 20 ? 1 : 0.5;
    c.stroke();
  }
  c.beginPath();
  c.moveTo(...at(s, 0, 0));
  c.lineTo(...at(s, N, 0));
  c.lineTo(...at(s, 0, N));
  c.closePath();
  c.strokeStyle = named("ink");
  c.lineWidth = 1.5;
  c.stroke();
}

/** The order as a line; returns the level that it could be drawn at, null where not at all. */
export function drawOrder(s: Stage): number | null {
  const { c } = s;
  const path = line(s.level, s.order, windowOf(s), least.curve / s.view.scale);
  if (path.stretches.length === 0) return null;
  const strokes = new Path2D();
  for (const stretch of path.stretches) {
    strokes.moveTo(...toPixel(s.view, s.width, s.height, stretch[0]!, stretch[1]!));
    for (let k = 2; k < stretch.length; k += 2) strokes.lineTo(...toPixel(s.view, s.width, s.height, stretch[k]!, stretch[k + 1]!));
  }
  const side = s.view.scale / 2 ** path.level;
  // A line of two colours is seen on any ground.
  c.strokeStyle = named("paper");
  c.lineWidth = side > 16 ? 4 : 2.4;
  c.stroke(strokes);
  c.strokeStyle = named("curve");
  c.lineWidth = side > 16 ? 2 : 1.1;
  c.stroke(strokes);
  return path.level;
}

export function drawNumbers(s: Stage, taken: ReadonlySet<number>): void {
  const { c } = s;
  const side = sideOf(s);
  if (side < least.numbers) return;
  const N = 2 ** s.level;
  const w = windowOf(s);
  const size = Math.min(18, side / Math.max(3.2, 0.9 * (4 ** s.level - 1).toString().length));
  if (size < 7) return;
  c.font = `${size}px system-ui, sans-serif`;
  c.textAlign = "center";
  c.textBaseline = "middle";
  c.lineWidth = 3;
  c.strokeStyle = named("paper");
  c.fillStyle = named("ink");
  for (let j = Math.max(0, Math.floor(w.v0 * N)); j < Math.min(N, w.v1 * N); ++j)
    for (let i = Math.max(0, Math.floor(w.u0 * N)); i < Math.min(N - j, w.u1 * N + 1); ++i)
      for (const inverted of [false, true]) {
        if (inverted && i + j > N - 2) continue;
        const m = { i, j, inverted };
        const k = indexOf(m, s.level, s.order);
        if (taken.has(k)) continue;
        const [x, y] = middle(s, m);
        if (x < -20 || y < -20 || x > s.width + 20 || y > s.height + 20) continue;
        c.strokeText(`${k}`, x, y);
        c.fillText(`${k}`, x, y);
      }
}

/** Wrong edges as bars wider than an outline, wrong vertices as squares wider than the counterexample's point. */
export function drawWrong(s: Stage, answers: Answers): void {
  const { c } = s;
  const side = sideOf(s);
  // Finer than that, a halo would hide the neighbours.
  const halo = side >= 8;
  const bars = new Path2D();
  for (const e of answers.edges) {
    const [x0, y0] = at(s, e.i0, e.j0);
    const [x1, y1] = at(s, e.i1, e.j1);
    bars.moveTo(x0 + 0.12 * (x1 - x0), y0 + 0.12 * (y1 - y0));
    bars.lineTo(x1 - 0.12 * (x1 - x0), y1 - 0.12 * (y1 - y0));
  }
  const squares = new Path2D();
  const r = Math.max(0.7, Math.min(8, side / 7));
  for (const v of answers.vertices) {
    const [x, y] = at(s, v.i, v.j);
    squares.rect(x - r, y - r, 2 * r, 2 * r);
  }
  c.lineCap = "butt";
  c.strokeStyle = named("paper");
  c.lineWidth = Math.min(11, 1.5 + side / 5);
  if (halo) c.stroke(bars);
  c.strokeStyle = c.fillStyle = named("wrong");
  c.lineWidth = Math.max(0.7, Math.min(7, side / 8));
  c.stroke(bars);
  c.fill(squares);
  c.strokeStyle = named("paper");
  c.lineWidth = 1;
  if (halo) c.stroke(squares);
}

interface Marked {
  index: number;
  colour: string;
  dashed: boolean;
}

/** The micro-triangles that a counterexample names and that lie on this level. */
function markedBy(s: Stage, counter: Counter): Marked[] {
  if (counter.shownAt !== s.level) return [];
  const all: [number | null, string, boolean][] = [
    [counter.wrong, "wrong", true],
    [counter.about, "right", false],
    [counter.right, "right", false],
  ];
  return all.flatMap(([index, colour, dashed]) => (index === null ? [] : [{ index, colour: named(colour), dashed }]));
}

/** Outlines of the right micro-triangle and of the one returned. Wrong edges are drawn after it, or it would hide them. */
export function drawOutlines(s: Stage, counter: Counter): void {
  const { c } = s;
  const side = sideOf(s);
  for (const { index, colour, dashed } of markedBy(s, counter)) {
    const m = microOfIndex(index, s.level, s.order);
    outline(s, m);
    c.setLineDash(dashed ? [7, 4] : []);
    c.strokeStyle = named("paper");
    c.lineWidth = 6;
    if (side > 14) c.stroke();
    c.strokeStyle = colour;
    c.lineWidth = 3;
    c.stroke();
    c.setLineDash([]);
    if (side >= 14) continue;
    c.beginPath();
    c.arc(...middle(s, m), 9, 0, 2 * Math.PI);
    c.stroke();
  }
}

/** The counterexample: numbers of the right micro-triangle and of the one returned, and the point. */
export function drawCounter(s: Stage, counter: Counter): void {
  const { c } = s;
  const side = sideOf(s);
  if (side >= 30)
    for (const { index, colour } of markedBy(s, counter)) {
      const [x, y] = middle(s, microOfIndex(index, s.level, s.order));
      c.font = `bold ${Math.min(20, side / 3)}px system-ui, sans-serif`;
      c.textAlign = "center";
      c.textBaseline = "middle";
      c.strokeStyle = named("paper");
      c.lineWidth = 4;
      c.strokeText(`${index}`, x, y);
      c.fillStyle = colour;
      c.fillText(`${index}`, x, y);
    }
  if (counter.point) {
    const [x, y] = toPixel(s.view, s.width, s.height, counter.point.u, counter.point.v);
    c.beginPath();
    c.arc(x, y, 4, 0, 2 * Math.PI);
    c.fillStyle = "#000";
    c.fill();
    c.strokeStyle = "#fff";
    c.lineWidth = 1.5;
    c.stroke();
  }
}

export function drawCorners(s: Stage): void {
  const { c } = s;
  c.font = "12px system-ui, sans-serif";
  c.textAlign = "center";
  c.textBaseline = "alphabetic";
  const narrow = s.width < 480;
  const words = (name: string, which: string) => (narrow ? `${name} = 1` : `${name} = 1, ${which} vertex`);
  const put = (text: string, x: number, y: number) => {
    const half = c.measureText(text).width / 2 + 4;
    if (x < -half || x > s.width + half || y < 0 || y > s.height + 14) return;
    c.strokeStyle = named("paper");
    c.lineWidth = 3;
    const px = Math.max(half, Math.min(s.width - half, x));
    c.strokeText(text, px, y);
    c.fillStyle = named("soft");
    c.fillText(text, px, y);
  };
  const corner = (u: number, v: number) => toPixel(s.view, s.width, s.height, u, v);
  const [wx, wy] = corner(0, 0);
  const [ux, uy] = corner(1, 0);
  const [vx, vy] = corner(0, 1);
  put(words("w", "first"), wx, wy + 17);
  put(words("u", "second"), ux, uy + 17);
  put(words("v", "third"), vx, vy - 8);
}

/** Where keys point: the middle of the picture. */
export function drawCross(s: Stage): void {
  const { c } = s;
  const [x, y] = [s.width / 2, s.height / 2];
  for (const [colour, width] of [[named("paper"), 4], [named("ink"), 1.5]] as const) {
    c.beginPath();
    c.moveTo(x - 9, y);
    c.lineTo(x + 9, y);
    c.moveTo(x, y - 9);
    c.lineTo(x, y + 9);
    c.strokeStyle = colour;
    c.lineWidth = width;
    c.stroke();
  }
}

/** A view that has the whole base triangle. */
export const wholeView = (width: number, height: number): View => ({
  x: 0.5,
  y: slope / 2 - 0.006,
  scale: Math.min((width - 24) / 1, (height - 60) / slope),
});
