// Refuted laws on the triangle: pan, zoom, level by level, with the counterexample, the order and the colours.
import { cornersOf, indexOf, type Micro, microAt, microOfIndex } from "./curve";
import { place } from "./answers";
import type { Report } from "./data";
import { button, el, fresh, select } from "./dom";
import { type Counter, exhibit, type Exhibit } from "./exhibit";
import { type Colouring, colouring, type Mode, modesOf, modeWords, stateName } from "./fills";
import { grouped, plural } from "./format";
import { drawCorners, drawCounter, drawCross, drawGrid, drawNumbers, drawOrder, drawOutlines, drawWrong, type Stage, wholeView } from "./overlay";
import { type Fill, paint, slope, toPoint, type View } from "./raster";
import { square } from "./square";
import { onTheme } from "./theme";
import type { Group } from "./verdicts";

const highest = 16;

/** A law and a level of it, at which a picture begins. */
export interface Place {
  law: string;
  level: number;
}
export interface Showing {
  /** Shown at first, where it is refuted. */
  at?: Place;
  /** Called for each refuted law that is shown, with its simplest counterexample. */
  shown?: (group: Group, counter: Counter | undefined) => void;
}

/** A patch of a fill, for the legend. */
export function patch(fill: Fill): HTMLCanvasElement {
  const made = el("canvas", { "aria-hidden": "true", class: "patch" });
  [made.width, made.height] = [28, 16];
  const c = made.getContext("2d")!;
  const image = c.createImageData(28, 16);
  paint(new Uint32Array(image.data.buffer), 28, 16, { x: 0.5, y: 0.2, scale: 1000 }, 0, 1, [fill], () => 0);
  c.putImageData(image, 0, 0);
  return made;
}

class Viewer {
  readonly root: HTMLElement;
  private readonly canvas = el("canvas", { class: "triangle", tabindex: "0", role: "application", "aria-roledescription": "picture" });
  private readonly c = this.canvas.getContext("2d")!;
  private readonly buffer = document.createElement("canvas");
  private readonly readout = el("p", { class: "readout" });
  private readonly spoken = el("p", { class: "spoken", "aria-live": "polite" });
  private readonly legend = el("div", { class: "legend" });
  private readonly about = el("div", { class: "about" });
  private readonly words = el("p", { class: "note" });
  private readonly slider: HTMLInputElement;
  private readonly levelWords = el("output", {});
  private readonly modes = select("Colours", [], (value) => this.setMode(value as Mode));
  private readonly showOrder: HTMLInputElement;
  private width = 0;
  private height = 0;
  private view: View = wholeView(640, 560);
  private whole = true;
  private level = 0;
  private mode: Mode = "order";
  private colours!: Colouring;
  private shown!: Exhibit;
  private dirty = false;
  private moving = false;
  private coarse = false;
  private settle = 0;
  private keys = false;
  private readonly pointers = new Map<number, { x: number; y: number }>();

  constructor(readonly report: Report, all: Group[], private readonly showing: Showing) {
    const sliderId = fresh("level");
    this.slider = el("input", { id: sliderId, type: "range", min: "0", max: String(highest), step: "1" });
    this.slider.addEventListener("input", () => this.setLevel(Number(this.slider.value)));
    const orderId = fresh("order");
    this.showOrder = el("input", { id: orderId, type: "checkbox", checked: "" });
    this.showOrder.addEventListener("change", () => this.touch());
    const chooser = select(
      "Refuted",
      all.map((g, k) => ({ value: String(k), words: `${g.law}, ${g.subject}` })),
      (value) => this.show(all[Number(value)]!),
    );
    this.listen();
    this.root = el(
      "div",
      { class: "viewer" },
      all.length > 1 ? el("div", { class: "tools" }, chooser.box) : null,
      this.about,
      el(
        "div",
        { class: "tools" },
        el("span", { class: "field" }, el("label", { for: sliderId }, "Level"), this.slider, this.levelWords),
        this.modes.box,
        el("span", { class: "field" }, this.showOrder, el("label", { for: orderId }, "the order as a line")),
      ),
      el(
        "div",
        { class: "tools" },
        button("Zoom in", () => this.zoom(1.6)),
        button("Zoom out", () => this.zoom(1 / 1.6)),
        button("Whole triangle", () => this.fit()),
        button("To the counterexample", () => this.toCounter()),
      ),
      this.canvas,
      this.readout,
      this.spoken,
      this.legend,
      this.words,
    );
    new ResizeObserver(([entry]) => this.resize(entry!.contentRect.width)).observe(this.root);
    onTheme(() => {
      this.recolour();
    });
    const first = Math.max(0, all.findIndex((g) => g.law === showing.at?.law));
    chooser.list.value = String(first);
    this.show(all[first]!);
    if (showing.at?.law === all[first]!.law) this.setLevel(showing.at.level);
  }

  show(group: Group): void {
    this.shown = exhibit(this.report, group);
    const e = this.shown;
    this.about.replaceChildren(...this.aboutNodes());
    const modes = modesOf(e);
    this.modes.list.replaceChildren(...modes.map((mode) => el("option", { value: mode }, modeWords[mode])));
    this.mode = modes[0]!;
    this.canvas.setAttribute(
      "aria-label",
      `Base triangle: ${group.law} on ${group.subject}. Arrow keys move it, plus and minus zoom, 0 shows all, brackets change the level`,
    );
    this.readout.textContent = "Point at a micro-triangle to read it.";
    this.fit();
    this.setLevel(e.counters[0]?.shownAt ?? 3);
    this.showing.shown?.(group, e.counters[0]);
  }

  private aboutNodes(): Node[] {
    const e = this.shown;
    const nodes: Node[] = [];
    const c = e.counters[0];
    if (c) {
      const { counterexample: x } = c;
      nodes.push(
        el(
          "p",
          {},
          `The simplest counterexample${e.counters.length > 1 ? ` of ${e.counters.length}` : ""}: level ${c.level}, case `,
          el("code", {}, x.case.length > 200 ? `${x.case.slice(0, 200)}...` : x.case),
          x.hex ? ` ${x.hex}` : "",
          `; expected `,
          el("strong", {}, String(x.expected)),
          ", got ",
          el("strong", { class: "wrong" }, String(x.got)),
          ".",
        ),
      );
    }
    const { run } = e.group;
    for (const d of run.content.diagnoses ?? [])
      if (d.law === e.group.law && d.subject === e.group.subject) nodes.push(el("ul", {}, ...d.lines.map((line) => el("li", {}, line))));
    nodes.push(...e.words.map((words) => el("p", { class: "note" }, words)));
    if (e.square) nodes.push(square(e.square));
    if (e.picture) {
      const utf8 = String.fromCharCode(...new TextEncoder().encode(e.picture));
      nodes.push(
        el("details", {}, el("summary", {}, "The texels around it"), el("img", { class: "picture", src: `data:image/svg+xml;base64,${btoa(utf8)}`, alt: "The micro-triangle on its texels, as mmverify replay draws it" })),
      );
    }
    return nodes;
  }

  private setLevel(level: number): void {
    this.level = Math.max(0, Math.min(highest, level));
    this.slider.value = String(this.level);
    this.levelWords.textContent = `${this.level}: ${plural(4 ** this.level, "micro-triangle")}`;
    this.slider.setAttribute("aria-valuetext", this.levelWords.textContent);
    this.recolour();
  }

  private setMode(mode: Mode): void {
    this.mode = mode;
    this.recolour();
  }

  private recolour(): void {
    this.modes.list.value = this.mode;
    this.colours = colouring(this.shown, this.mode, this.level);
    const marks: (Node | string)[] = this.colours.legend.map(({ fill, words }) => el("span", { class: "entry" }, patch(fill), words));
    const answers = this.mode === "answers" ? this.shown.answers.get(this.level) : undefined;
    if (answers && answers.edges.length > 0) marks.push(el("span", { class: "entry" }, el("span", { class: "mark edge" }), "wrong on the edge"));
    if (answers && answers.vertices.length > 0) marks.push(el("span", { class: "entry" }, el("span", { class: "mark vertex" }), "wrong at the vertex"));
    const counter = this.counter();
    if (counter?.shownAt === this.level && counter.right !== null) marks.push(el("span", { class: "entry" }, el("span", { class: "mark right" }), `expected ${counter.right}`));
    if (counter?.shownAt === this.level && counter.wrong !== null) marks.push(el("span", { class: "entry" }, el("span", { class: "mark wrong" }), `returned ${counter.wrong}`));
    if (counter?.shownAt === this.level && counter.about !== null) marks.push(el("span", { class: "entry" }, el("span", { class: "mark right" }), `the counterexample is about ${counter.about}`));
    if (counter?.point) marks.push(el("span", { class: "entry" }, el("span", { class: "mark point" }), `the point (${counter.point.uText}, ${counter.point.vText})`));
    this.legend.replaceChildren(...marks);
    this.touch();
  }

  /** The counterexample of this level, or the simplest of all. */
  private counter(): Counter | undefined {
    return this.shown.counters.find((c) => c.shownAt === this.level) ?? this.shown.counters[0];
  }

  private note(orderLevel: number | null): void {
    const words: string[] = [];
    if (this.colours.words) words.push(this.colours.words);
    const answers = this.shown.answers.get(this.level);
    if (answers && this.mode === "answers") {
      const { inside, edges, vertices } = answers;
      const wrong = answers.wrongCells === 0 ? "none is wrong" : `${grouped(answers.wrongCells)} wrong`;
      words.push(
        `Level ${this.level}: asked on ${grouped(answers.cells)} cells, ${wrong}` +
          (answers.wrongCells === 0 ? "." : answers.all ? `: ${plural(inside.size, "micro-triangle")}, ${plural(edges.length, "edge")}, ${plural(vertices.length, "vertex", "vertices")}.` : "."),
      );
    }
    const counter = this.counter();
    if (counter && counter.shownAt !== this.level) words.push(`The counterexample is of level ${counter.shownAt}.`);
    if (counter?.point && counter.shownAt === this.level && answers?.wrongCells === 0)
      words.push("The counterexample is another point than the one that each cell was asked at.");
    if (counter && counter.wrong === null && counter.right !== null && counter.point && counter.shownAt === this.level)
      words.push(`What it returned, ${counter.counterexample.got}, is no micro-triangle of this level.`);
    if (this.showOrder.checked && orderLevel !== this.level)
      words.push(
        orderLevel === null
          ? `The order of level ${this.level} is too fine to be drawn here; zoom in.`
          : `The line is the curve of level ${orderLevel}: that of level ${this.level} is too fine to be seen here; zoom in.`,
      );
    const text = words.join(" ");
    if (this.words.textContent !== text) this.words.textContent = text;
  }

  // The view

  private resize(width: number): void {
    if (width < 40 || width === this.width) return;
    const dpr = devicePixelRatio;
    this.width = Math.floor(width);
    this.height = Math.floor(Math.max(280, Math.min(0.86 * width, 640, innerHeight * 0.78)));
    this.canvas.width = Math.round(this.width * dpr);
    this.canvas.height = Math.round(this.height * dpr);
    this.canvas.style.height = `${this.height}px`;
    if (this.whole) this.fit();
    this.touch();
  }

  private fit(): void {
    this.view = wholeView(this.width || 640, this.height || 560);
    this.whole = true;
    this.touch();
  }

  private toCounter(): void {
    const counter = this.counter();
    if (!counter) return;
    this.setLevel(counter.shownAt);
    let at: [number, number] | undefined = counter.point ? [counter.point.u, counter.point.v] : undefined;
    const index = counter.right ?? counter.about;
    if (!at && index !== null) {
      const c = cornersOf(microOfIndex(index, this.level, this.shown.order));
      const N = 2 ** this.level;
      at = [(c[0] + c[2] + c[4]) / 3 / N, (c[1] + c[3] + c[5]) / 3 / N];
    }
    if (!at) return;
    this.view = { x: at[0] + at[1] / 2, y: at[1] * slope, scale: Math.max(this.view.scale, 2 ** this.level * Math.min(90, this.width / 5)) };
    this.whole = false;
    this.touch();
  }

  private zoom(factor: number, px = this.width / 2, py = this.height / 2): void {
    const before = toPoint(this.view, this.width, this.height, px, py);
    const least = wholeView(this.width, this.height).scale * 0.6;
    const scale = Math.max(least, Math.min(this.view.scale * factor, 400 * 2 ** highest));
    this.view = { ...this.view, scale };
    const after = toPoint(this.view, this.width, this.height, px, py);
    const du = before[0] - after[0], dv = before[1] - after[1];
    this.move(du + dv / 2, dv * slope);
  }

  private pan(dx: number, dy: number): void {
    this.move(-dx / this.view.scale, dy / this.view.scale);
  }

  /** The middle stays within the triangle's box. */
  private move(x: number, y: number): void {
    this.view = { ...this.view, x: Math.max(0, Math.min(1, this.view.x + x)), y: Math.max(0, Math.min(slope, this.view.y + y)) };
    this.whole = false;
    this.moving = true;
    clearTimeout(this.settle);
    this.settle = window.setTimeout(() => {
      this.moving = false;
      if (this.coarse) this.touch();
    }, 140);
    this.touch();
  }

  private listen(): void {
    const { canvas } = this;
    const local = (event: PointerEvent | WheelEvent) => {
      const box = canvas.getBoundingClientRect();
      return { x: event.clientX - box.left, y: event.clientY - box.top };
    };
    canvas.addEventListener("pointerdown", (event) => {
      this.pointers.set(event.pointerId, local(event));
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => {
      const now = local(event);
      const before = this.pointers.get(event.pointerId);
      if (before) {
        if (this.pointers.size === 1) this.pan(now.x - before.x, now.y - before.y);
        else if (this.pointers.size === 2) {
          const other = [...this.pointers].find(([id]) => id !== event.pointerId)![1];
          const apart = (a: typeof now) => Math.hypot(a.x - other.x, a.y - other.y);
          this.zoom(apart(now) / Math.max(1, apart(before)), (now.x + other.x) / 2, (now.y + other.y) / 2);
        }
        this.pointers.set(event.pointerId, now);
      }
      this.keys = false;
      this.read(now.x, now.y, false);
    });
    for (const type of ["pointerup", "pointercancel"] as const) canvas.addEventListener(type, (event) => this.pointers.delete(event.pointerId));
    canvas.addEventListener(
      "wheel",
      (event) => {
        // Else the page could not be scrolled past the picture.
        if (document.activeElement !== canvas && !event.ctrlKey) return;
        event.preventDefault();
        const { x, y } = local(event);
        this.zoom(Math.exp(-event.deltaY / 400), x, y);
      },
      { passive: false },
    );
    canvas.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const by = event.shiftKey ? 200 : 40;
      const acts: Record<string, () => void> = {
        ArrowLeft: () => this.pan(by, 0),
        ArrowRight: () => this.pan(-by, 0),
        ArrowUp: () => this.pan(0, by),
        ArrowDown: () => this.pan(0, -by),
        "+": () => this.zoom(1.3),
        "=": () => this.zoom(1.3),
        "-": () => this.zoom(1 / 1.3),
        "0": () => this.fit(),
        "[": () => this.setLevel(this.level - 1),
        "]": () => this.setLevel(this.level + 1),
      };
      const act = acts[event.key];
      if (!act) return;
      event.preventDefault();
      this.keys = true;
      act();
      this.read(this.width / 2, this.height / 2, true);
    });
    canvas.addEventListener("blur", () => {
      this.keys = false;
      this.touch();
    });
  }

  private read(px: number, py: number, speak: boolean): void {
    const [u, v] = toPoint(this.view, this.width, this.height, px, py);
    const inside = u >= 0 && v >= 0 && u + v <= 1;
    this.readout.textContent = inside ? this.describe(microAt(u, v, this.level)) : "Point at a micro-triangle to read it.";
    if (speak) this.spoken.textContent = this.readout.textContent;
  }

  private describe(m: Micro): string {
    const { level } = this;
    const N = 2 ** level;
    const index = indexOf(m, level, this.shown.order);
    const parts = [`Micro-triangle ${grouped(index)} of level ${level}, ${m.inverted ? "inverted" : "upright"}, u from ${m.i}/${N}, v from ${m.j}/${N}.`];
    const answers = this.shown.answers.get(level);
    if (answers) {
      const wrong = answers.inside.get(place(m.i, m.j, m.inverted, level));
      parts.push(wrong ? `Inside it the subject answers ${grouped(wrong.got)}: wrong.` : answers.known(m.i, m.j) ? "Inside it the subject is right." : "");
      const touches = (i: number, j: number) => {
        const c = cornersOf(m);
        return [0, 2, 4].some((k) => c[k] === i && c[k + 1] === j);
      };
      const edges = answers.edges.filter((e) => touches(e.i0, e.j0) && touches(e.i1, e.j1));
      const vertices = answers.vertices.filter((x) => touches(x.i, x.j));
      if (edges.length > 0) parts.push(`Wrong on ${plural(edges.length, "edge")} of it: ${edges.map((e) => `${e.got} for ${e.right}`).join(", ")}.`);
      if (vertices.length > 0) parts.push(`Wrong at ${plural(vertices.length, "vertex", "vertices")}: ${vertices.map((x) => `${x.got} for ${x.right}`).join(", ")}.`);
    }
    const states = this.shown.states.get(level);
    if (states) {
      const is = stateName(states.expected[index]!);
      parts.push(states.got === null ? `State ${is}.` : `It is ${is}; the subject says ${stateName(states.got[index]!)}.`);
    }
    return parts.filter((p) => p !== "").join(" ");
  }

  private touch(): void {
    if (this.dirty) return;
    this.dirty = true;
    requestAnimationFrame(() => {
      this.dirty = false;
      this.draw();
    });
  }

  private draw(): void {
    if (this.width === 0) return;
    const { c, canvas, buffer } = this;
    const dpr = devicePixelRatio;
    const start = performance.now();
    // While it moves, a machine on which a frame takes too long gets a quarter of the pixels.
    const fine = !(this.moving && this.coarse);
    const quality = fine ? dpr : dpr / 2;
    const w = Math.round(this.width * quality), h = Math.round(this.height * quality);
    if (buffer.width !== w || buffer.height !== h) [buffer.width, buffer.height] = [w, h];
    const b = buffer.getContext("2d")!;
    const image = b.createImageData(w, h);
    const scaled = { ...this.view, scale: (this.view.scale * w) / this.width };
    paint(new Uint32Array(image.data.buffer), w, h, scaled, this.level, quality, this.colours.fills, this.colours.kind);
    b.putImageData(image, 0, 0);
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.clearRect(0, 0, canvas.width, canvas.height);
    c.imageSmoothingEnabled = false;
    c.drawImage(buffer, 0, 0, canvas.width, canvas.height);
    c.setTransform(dpr, 0, 0, dpr, 0, 0);
    c.lineJoin = "round";
    const stage: Stage = { c, view: this.view, width: this.width, height: this.height, level: this.level, order: this.shown.order };
    drawGrid(stage);
    const orderLevel = this.showOrder.checked ? drawOrder(stage) : this.level;
    const answers = this.shown.answers.get(this.level);
    const counter = this.counter();
    if (counter) drawOutlines(stage, counter);
    if (answers && this.mode === "answers") drawWrong(stage, answers);
    const here = counter?.shownAt === this.level;
    drawNumbers(stage, new Set(here ? [counter.right ?? -1, counter.wrong ?? -1, counter.about ?? -1] : []));
    if (counter) drawCounter(stage, counter);
    drawCorners(stage);
    if (this.keys) drawCross(stage);
    this.note(orderLevel);
    if (fine) this.coarse = performance.now() - start > 14;
  }
}

export function triangleSection(report: Report, refuted: Group[], showing: Showing = {}): HTMLElement {
  const with_ = refuted.filter((g) => g.verdict === "refuted");
  return new Viewer(report, with_, showing).root;
}
