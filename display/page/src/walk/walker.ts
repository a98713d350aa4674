// A triangle to walk about in: colours, grid, order and numbers, and a place that keys and the pointer move.
import type { Micro, Order } from "../../../report/src/curve";
import { button, el, fresh } from "../../../report/src/dom";
import { plural } from "../../../report/src/format";
import { drawCorners, drawGrid, drawNumbers, drawOrder, type Stage, wholeView } from "../../../report/src/overlay";
import { named } from "../../../report/src/palette";
import { type Fill, paint, slope, toPixel, toPoint, type View } from "../../../report/src/raster";
import { onTheme } from "../../../report/src/theme";
import { patch } from "../../../report/src/triangle";
import { mark } from "./mark";
import { type At, atLevel, middleOf, microOf, microStep, orderStep, quarterStep } from "./steps";

export interface Colours {
  fills: readonly Fill[];
  kind: (i: number, j: number, inverted: boolean) => number;
  legend: { fill: Fill; words: string }[];
}

export interface Ground {
  /** What a screen reader calls it. */
  name: string;
  /** The lowest and highest level of the slider; the same: there is none. */
  levels: [number, number];
  /** The step of an arrow key. */
  step: "quarter" | "micro";
  numbers: boolean;
  order: (level: number) => Order | null;
  colours: (level: number) => Colours;
  /** What is said of a place; it is read aloud, too. */
  describe: (at: At, level: number) => string;
  /** The micro-triangle that a place belongs to, where it is not Vulkan's. */
  owner?: (at: At, level: number) => Micro;
  /** Called after each step. */
  moved?: (at: At, level: number) => void;
  /** More to draw, in pixels of the page. */
  over?: (stage: Stage, pixel: (u: number, v: number) => [number, number], at: At) => void;
}

export class Walker {
  readonly root: HTMLElement;
  private readonly canvas = el("canvas", { class: "triangle walker", tabindex: "0", role: "application", "aria-roledescription": "picture" });
  private readonly buffer = document.createElement("canvas");
  private readonly readout = el("p", { class: "readout", "aria-live": "polite" });
  private readonly legend = el("div", { class: "legend" });
  private readonly slider: HTMLInputElement;
  private readonly levelWords = el("output", {});
  private readonly levelTools: HTMLElement;
  private ground: Ground;
  private colours!: Colours;
  private width = 0;
  private height = 0;
  private zoom = 1;
  private dirty = false;
  level: number;
  at: At = { ku: 1, kv: 1 };

  constructor(ground: Ground, level: number) {
    this.ground = ground;
    this.level = level;
    const id = fresh("level");
    this.slider = el("input", { id, type: "range", step: "1" });
    this.slider.addEventListener("input", () => this.toLevel(Number(this.slider.value)));
    this.levelTools = el("span", { class: "field" }, el("label", { for: id }, "Level"), this.slider, this.levelWords);
    this.listen();
    this.root = el(
      "div",
      { class: "viewer walk" },
      el(
        "div",
        { class: "tools" },
        this.levelTools,
        button("Previous", () => this.go(orderStep(this.at, -1, this.level, this.order())), { title: "the micro-triangle before this one in the order" }),
        button("Next", () => this.go(orderStep(this.at, 1, this.level, this.order())), { title: "the micro-triangle after this one in the order" }),
        button("Zoom in", () => this.zoomBy(1.6)),
        button("Zoom out", () => this.zoomBy(1 / 1.6)),
      ),
      this.canvas,
      this.readout,
      this.legend,
    );
    new ResizeObserver(([entry]) => this.resize(entry!.contentRect.width)).observe(this.root);
    onTheme(() => this.refresh());
    this.show(ground, level);
  }

  show(ground: Ground, level: number): void {
    this.ground = ground;
    [this.slider.min, this.slider.max] = [String(ground.levels[0]), String(ground.levels[1])];
    this.levelTools.hidden = ground.levels[0] === ground.levels[1];
    this.canvas.setAttribute("aria-label", `${ground.name}. Arrow keys walk, n and p go along the order, plus and minus zoom, brackets change the level`);
    this.level = level;
    if (ground.step === "micro") this.at = middleOf(microOf({ ku: Math.min(this.at.ku, 1), kv: Math.min(this.at.kv, 1) }, level));
    this.zoom = 1;
    this.setLevel(level);
  }

  /** Asks the ground anew for its colours and words. */
  refresh(): void {
    this.colours = this.ground.colours(this.level);
    this.legend.replaceChildren(...this.colours.legend.map(({ fill, words }) => el("span", { class: "entry" }, patch(fill), words)));
    this.tell();
  }

  go(at: At): void {
    this.at = at;
    this.tell();
  }

  toLevel(level: number): void {
    const [low, high] = this.ground.levels;
    const next = Math.max(low, Math.min(high, level));
    const there = atLevel(this.at, this.level, next);
    this.at = this.ground.step === "micro" ? middleOf(microOf(there, next)) : there;
    this.setLevel(next);
  }

  private order = (): Order => this.ground.order(this.level) ?? "curve";

  private setLevel(level: number): void {
    this.level = level;
    this.slider.value = String(level);
    this.levelWords.textContent = `${level}: ${plural(4 ** level, "micro-triangle")}`;
    this.slider.setAttribute("aria-valuetext", this.levelWords.textContent);
    this.refresh();
  }

  private tell(): void {
    this.readout.textContent = this.ground.describe(this.at, this.level);
    this.ground.moved?.(this.at, this.level);
    this.touch();
  }

  private zoomBy(factor: number): void {
    this.zoom = Math.max(1, Math.min(this.zoom * factor, 2 ** this.level * 4));
    if (this.zoom < 1.05) this.zoom = 1;
    this.touch();
  }

  /** The whole triangle; nearer, what is around the place. */
  private view(): View {
    const whole = wholeView(this.width, this.height);
    if (this.zoom === 1) return whole;
    const quarters = 4 * 2 ** this.level;
    const [u, v] = [this.at.ku / quarters, this.at.kv / quarters];
    return { x: u + v / 2, y: v * slope, scale: whole.scale * this.zoom };
  }

  private listen(): void {
    const { canvas } = this;
    const point = (event: PointerEvent): void => {
      const box = canvas.getBoundingClientRect();
      const [u, v] = toPoint(this.view(), this.width, this.height, event.clientX - box.left, event.clientY - box.top);
      if (u < -0.02 || v < -0.02 || u + v > 1.02) return;
      const quarters = 4 * 2 ** this.level;
      const ku = Math.max(0, Math.min(quarters, Math.round(u * quarters)));
      const at = { ku, kv: Math.max(0, Math.min(quarters - ku, Math.round(v * quarters))) };
      this.go(this.ground.step === "micro" ? middleOf(microOf(at, this.level)) : at);
    };
    // Nearer, the picture moves with the place: there a click moves it, and pointing does not.
    canvas.addEventListener("pointermove", (event) => this.zoom === 1 && point(event));
    canvas.addEventListener("pointerdown", point);
    canvas.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const step = (this.ground.step === "micro" ? microStep : quarterStep)(this.at, event.key, this.level);
      const acts: Record<string, () => void> = {
        n: () => this.go(orderStep(this.at, 1, this.level, this.order())),
        p: () => this.go(orderStep(this.at, -1, this.level, this.order())),
        "+": () => this.zoomBy(1.3),
        "=": () => this.zoomBy(1.3),
        "-": () => this.zoomBy(1 / 1.3),
        "[": () => this.toLevel(this.level - 1),
        "]": () => this.toLevel(this.level + 1),
      };
      const act = step ? () => this.go(step) : acts[event.key];
      if (!act) return;
      event.preventDefault();
      act();
    });
  }

  private resize(width: number): void {
    if (width < 40 || width === this.width) return;
    this.width = Math.floor(width);
    this.height = Math.floor(Math.max(280, Math.min(0.86 * width, 560, innerHeight * 0.72)));
    this.canvas.width = Math.round(this.width * devicePixelRatio);
    this.canvas.height = Math.round(this.height * devicePixelRatio);
    this.canvas.style.height = `${this.height}px`;
    this.touch();
  }

  private touch(): void {
    if (this.dirty) return;
    this.dirty = true;
    requestAnimationFrame(() => {
      this.dirty = false;
      if (this.width > 0) this.draw();
    });
  }

  private draw(): void {
    const { canvas, buffer, ground, level } = this;
    const c = canvas.getContext("2d")!;
    const [w, h] = [canvas.width, canvas.height];
    if (buffer.width !== w || buffer.height !== h) [buffer.width, buffer.height] = [w, h];
    const b = buffer.getContext("2d")!;
    const image = b.createImageData(w, h);
    const view = this.view();
    paint(new Uint32Array(image.data.buffer), w, h, { ...view, scale: view.scale * devicePixelRatio }, level, devicePixelRatio, this.colours.fills, this.colours.kind);
    b.putImageData(image, 0, 0);
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.clearRect(0, 0, w, h);
    c.drawImage(buffer, 0, 0);
    c.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    c.lineJoin = "round";
    const order = ground.order(level);
    const stage: Stage = { c, view, width: this.width, height: this.height, level, order: order ?? "curve" };
    drawGrid(stage);
    if (order) drawOrder(stage);
    const quarters = 4 * 2 ** level;
    const pixel = (u: number, v: number): [number, number] => toPixel(view, this.width, this.height, u, v);
    ground.over?.(stage, pixel, this.at);
    if (ground.numbers) drawNumbers(stage, new Set());
    mark(c, (ground.owner ?? microOf)(this.at, level), level, pixel, ground.step === "quarter" ? pixel(this.at.ku / quarters, this.at.kv / quarters) : null, named);
    if (this.zoom === 1) drawCorners(stage);
  }
}
