// One chart: uPlot has the axes, the scales and the lines; marks, hovering, keys and zoom are here.
import uPlot from "uplot";

import { button, el, fresh, svg } from "./dom";
import { colour, type Look, look, named, type Shape, trace } from "./palette";
import { onTheme } from "./theme";
import { linearTicks, logTicks, tickWords } from "./ticks";

export interface Mark {
  x: number;
  y: number;
  /** What it says when it is pointed at, a line each. */
  words: string[];
  hollow?: boolean;
}

export interface Series {
  name: string;
  marks: Mark[];
  line?: boolean;
  dashed?: boolean;
  /** Drawn beside its marks. */
  label?: string;
  /** Its own; otherwise that of its place among the series. */
  look?: Look | undefined;
}

export interface Axis {
  label: string;
  log?: boolean;
  whole?: boolean;
  /** A place for what is no number of a logarithmic axis, and its words. */
  floor?: { at: number; words: string };
  from?: number;
  to?: number;
}

export interface ChartSpec {
  title: string;
  note?: string;
  x: Axis;
  y: Axis;
  series: Series[];
  /** Marks that nothing of their kind beats, in order of x: ringed, and joined by steps. */
  fronts?: Mark[][];
  height?: number;
}

type Range = [number, number];

/** The range of all marks, with some room. */
function rangeOf(axis: Axis, values: number[]): Range {
  let min = Math.min(...values);
  let max = Math.max(...values);
  if (axis.from !== undefined) min = axis.from;
  if (axis.to !== undefined) max = axis.to;
  if (axis.log) {
    if (min === max) [min, max] = [min / 3, max * 3];
    const room = (max / min) ** 0.08;
    return [min / Math.max(room, 1.25), max * Math.max(room, 1.25)];
  }
  if (min === max) [min, max] = [min - 1, max + 1];
  const room = (max - min) * 0.06;
  return [axis.from ?? min - room, axis.to ?? max + room];
}

const zoomedBy = (range: Range, factor: number, log: boolean): Range => {
  const to = (x: number) => (log ? Math.log(x) : x);
  const back = (x: number) => (log ? Math.exp(x) : x);
  const middle = (to(range[0]) + to(range[1])) / 2;
  const half = ((to(range[1]) - to(range[0])) / 2) * factor;
  return [back(middle - half), back(middle + half)];
};

const lookOf = (s: Series, k: number): Look => s.look ?? look(k);

function swatch(shape: Shape, hollow: boolean, dashed: boolean, line: boolean): SVGElement {
  const box = svg("svg", { width: 26, height: 14, viewBox: "0 0 26 14", "aria-hidden": "true" });
  if (line)
    box.append(svg("line", { x1: 0, x2: 26, y1: 7, y2: 7, stroke: "currentColor", "stroke-width": 1.5, ...(dashed ? { "stroke-dasharray": "4 3" } : {}) }));
  const paths: Record<Shape, string> = {
    circle: "M17.5 7a4.5 4.5 0 1 1-9 0a4.5 4.5 0 1 1 9 0",
    square: "M9 3h8v8h-8z",
    triangle: "M13 1.8L18 11H8z",
    diamond: "M13 1.5L18.5 7L13 12.5L7.5 7z",
    cross: "M9 3l8 8M9 11l8-8",
    plus: "M13 1.5v11M7.5 7h11",
  };
  const lines = hollow || shape === "cross" || shape === "plus";
  box.append(svg("path", { d: paths[shape], fill: lines ? "none" : "currentColor", stroke: "currentColor", "stroke-width": lines ? 2 : 1 }));
  return box;
}

export function chart(given: ChartSpec): HTMLElement {
  // A logarithmic axis has no place for 0: what has none is not drawn.
  const drawable = (m: Mark) => (!given.x.log || m.x > 0) && (!given.y.log || m.y > 0);
  const spec: ChartSpec = {
    ...given,
    series: given.series.map((s) => ({ ...s, marks: s.marks.filter(drawable) })),
    fronts: (given.fronts ?? []).map((front) => front.filter(drawable)),
  };
  if (spec.series.every((s) => s.marks.length === 0))
    return el("figure", { class: "chart" }, el("figcaption", {}, spec.title), el("p", { class: "note" }, "No figure of it can be drawn: all are 0."));
  const all = spec.series.flatMap((s) => s.marks);
  const full = { x: rangeOf(spec.x, all.map((m) => m.x)), y: rangeOf(spec.y, [...all.map((m) => m.y), ...(spec.y.floor ? [spec.y.floor.at] : [])]) };
  let range = { ...full };
  const shown = spec.series.map(() => true);

  const title = fresh("chart");
  const tip = el("div", { class: "tip", "aria-hidden": "true" });
  const spoken = el("p", { class: "spoken", "aria-live": "polite" });
  const ring = el("div", { class: "ring" });
  const plot = el("div", {
    class: "plot",
    tabindex: "0",
    role: "group",
    "aria-roledescription": "chart",
    "aria-labelledby": title,
    "aria-description": "Left and right arrow keys go from mark to mark; plus and minus zoom, 0 shows all",
  });
  let u: uPlot | undefined;

  const xs = [...new Set(all.map((m) => m.x))].sort((a, b) => a - b);
  const columns = spec.series.map((s) => {
    const by = new Map(s.marks.map((m) => [m.x, m.y]));
    return xs.map((x) => by.get(x) ?? null);
  });

  /** Hides what was pointed at. */
  const hide = () => {
    tip.style.display = ring.style.display = "none";
    current = -1;
  };
  /** In order of x, for the keys. */
  const order = spec.series
    .flatMap((s, k) => s.marks.map((mark) => ({ mark, k, name: s.name })))
    .sort((a, b) => a.mark.x - b.mark.x || a.mark.y - b.mark.y);
  let current = -1;

  const place = (m: Mark) => ({ left: u!.valToPos(m.x, "x"), top: u!.valToPos(m.y, "y") });
  const inside = (m: Mark) => m.x >= range.x[0] && m.x <= range.x[1] && m.y >= range.y[0] && m.y <= range.y[1];

  const show = (at: number, speak: boolean) => {
    const { mark, name } = order[at]!;
    const { left, top } = place(mark);
    const over = u!.over;
    tip.replaceChildren(el("strong", {}, name), ...mark.words.map((words) => el("div", {}, words)));
    tip.style.display = ring.style.display = "block";
    ring.style.left = `${left}px`;
    ring.style.top = `${top}px`;
    const width = tip.offsetWidth;
    const height = tip.offsetHeight;
    const room = over.clientWidth;
    tip.style.left = `${Math.max(0, Math.min(left + 12, room - width))}px`;
    tip.style.top = `${top - height - 10 > 0 ? top - height - 10 : top + 12}px`;
    if (speak) spoken.textContent = [name, ...mark.words].join(", ");
    current = at;
  };

  const nearest = (left: number, top: number): number => {
    let best = -1;
    let least = 28;
    order.forEach(({ mark, k }, at) => {
      if (!shown[k] || !inside(mark)) return;
      const p = place(mark);
      const distance = Math.hypot(p.left - left, p.top - top);
      if (distance < least) [best, least] = [at, distance];
    });
    return best;
  };

  const redraw = () => {
    hide();
    u?.setData(u.data);
  };
  const zoom = (factor: number) => {
    range = { x: zoomedBy(range.x, factor, !!spec.x.log), y: zoomedBy(range.y, factor, !!spec.y.log) };
    redraw();
  };
  const whole = () => {
    range = { ...full };
    redraw();
  };

  const drawMarks = (p: uPlot) => {
    const c = p.ctx;
    const dpr = devicePixelRatio;
    const at = (m: Mark) => [p.valToPos(m.x, "x", true), p.valToPos(m.y, "y", true)] as const;
    c.save();
    c.beginPath();
    c.rect(p.bbox.left - 6 * dpr, p.bbox.top - 6 * dpr, p.bbox.width + 12 * dpr, p.bbox.height + 12 * dpr);
    c.clip();
    for (const front of spec.fronts ?? []) {
      const visible = front.filter((m) => spec.series.some((s, k) => shown[k] && s.marks.includes(m)));
      c.beginPath();
      visible.forEach((m, k) => {
        const [x, y] = at(m);
        if (k === 0) c.moveTo(x, y);
        else c.lineTo(x, at(visible[k - 1]!)[1]), c.lineTo(x, y);
      });
      c.strokeStyle = named("soft");
      c.lineWidth = 1.5 * dpr;
      c.setLineDash([5 * dpr, 4 * dpr]);
      c.stroke();
      c.setLineDash([]);
      for (const m of visible) {
        const [x, y] = at(m);
        c.beginPath();
        c.arc(x, y, 8.5 * dpr, 0, 2 * Math.PI);
        c.strokeStyle = named("ink");
        c.lineWidth = 1.5 * dpr;
        c.stroke();
      }
    }
    spec.series.forEach((s, k) => {
      if (!shown[k]) return;
      const { colour: number, shape } = lookOf(s, k);
      const lines = shape === "cross" || shape === "plus";
      c.strokeStyle = c.fillStyle = colour(number);
      c.lineWidth = (lines ? 2.2 : 1.5) * dpr;
      for (const m of s.marks) {
        const [x, y] = at(m);
        c.beginPath();
        trace(c, shape, x, y, (s.line ? 3.4 : 4.6) * dpr);
        if (m.hollow || lines) c.stroke();
        else c.fill();
      }
    });
    labels(p, c, dpr);
    c.restore();
  };

  /** Names beside marks, where there is room for them. */
  const labels = (p: uPlot, c: CanvasRenderingContext2D, dpr: number) => {
    const taken: [number, number, number, number][] = [];
    spec.series.forEach((s, k) => {
      if (shown[k])
        for (const m of s.marks) {
          const x = p.valToPos(m.x, "x", true), y = p.valToPos(m.y, "y", true);
          taken.push([x - 6 * dpr, y - 6 * dpr, x + 6 * dpr, y + 6 * dpr]);
        }
    });
    c.font = `${11 * dpr}px system-ui, sans-serif`;
    c.textBaseline = "middle";
    c.textAlign = "left";
    spec.series.forEach((s, k) => {
      const m = s.marks[s.marks.length - 1];
      if (!shown[k] || !s.label || !m || !inside(m)) return;
      const x = p.valToPos(m.x, "x", true), y = p.valToPos(m.y, "y", true);
      const width = c.measureText(s.label).width;
      for (const [dx, dy] of [[13, 0], [8, -15], [8, 15], [-13 - width / dpr, 0], [-width / dpr / 2, -16], [-width / dpr / 2, 16]] as const) {
        const box: [number, number, number, number] = [x + dx * dpr, y + (dy - 6) * dpr, x + dx * dpr + width, y + (dy + 6) * dpr];
        const { left, top, width: w, height: h } = p.bbox;
        if (box[0] < left || box[1] < top || box[2] > left + w || box[3] > top + h) continue;
        if (taken.some((t) => t[0] < box[2] && t[2] > box[0] && t[1] < box[3] && t[3] > box[1])) continue;
        taken.push(box);
        c.strokeStyle = named("paper");
        c.lineWidth = 3 * dpr;
        c.lineJoin = "round";
        c.strokeText(s.label, box[0], y + dy * dpr);
        c.fillStyle = named("soft");
        c.fillText(s.label, box[0], y + dy * dpr);
        break;
      }
    });
  };

  const axis = (which: "x" | "y"): uPlot.Axis => {
    const of = spec[which];
    return {
      scale: which,
      label: of.label,
      labelSize: 22,
      labelFont: "12px system-ui, sans-serif",
      font: "12px system-ui, sans-serif",
      size: which === "x" ? 34 : 58,
      stroke: () => named("soft"),
      grid: { stroke: () => named("line"), width: 1 },
      ticks: { stroke: () => named("line"), width: 1, size: 5 },
      splits: (p) => {
        const pixels = (which === "x" ? p.bbox.width : p.bbox.height) / devicePixelRatio;
        const count = Math.max(2, Math.floor(pixels / (which === "y" ? 44 : of.whole ? 44 : 70)));
        const [min, max] = range[which];
        const ticks = of.log ? logTicks(min, max, count) : linearTicks(min, max, count, !!of.whole);
        return of.floor ? [of.floor.at, ...ticks.filter((t) => t > of.floor!.at * 2)].filter((t) => t >= min && t <= max) : ticks;
      },
      filter: (_, splits) => splits,
      values: (_, splits) => splits.map((t) => (of.floor && t === of.floor.at ? of.floor.words : tickWords(t, !!of.log))),
    };
  };

  const create = (width: number) => {
    const scale = (which: "x" | "y"): uPlot.Scale => ({
      time: false,
      auto: true,
      distr: spec[which].log ? 3 : 1,
      range: () => range[which],
    });
    u = new uPlot(
      {
        width,
        height: spec.height ?? 360,
        padding: [10, 14, 0, 0],
        legend: { show: false },
        cursor: { drag: { x: true, y: true, dist: 6, setScale: false }, points: { show: false } },
        scales: { x: scale("x"), y: scale("y") },
        axes: [axis("x"), axis("y")],
        series: [
          {},
          ...spec.series.map((s, k): uPlot.Series => ({
            scale: "y",
            spanGaps: true,
            stroke: () => colour(lookOf(s, k).colour),
            width: 1.5,
            ...(s.dashed ? { dash: [6, 4] } : {}),
            points: { show: false },
            ...(s.line ? {} : { paths: () => null }),
          })),
        ],
        hooks: {
          draw: [drawMarks],
          setCursor: [
            (p) => {
              const { left, top } = p.cursor;
              if (left === undefined || top === undefined || left < 0) return hide();
              const at = nearest(left, top);
              if (at < 0) hide();
              else if (at !== current) show(at, false);
            },
          ],
          setSelect: [
            (p) => {
              const { left, top, width: w, height: h } = p.select;
              if (w < 6 || h < 6) return;
              range = {
                x: [p.posToVal(left, "x"), p.posToVal(left + w, "x")],
                y: [p.posToVal(top + h, "y"), p.posToVal(top, "y")],
              };
              p.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
              redraw();
            },
          ],
        },
      },
      [xs, ...columns],
      plot,
    );
    u.over.append(ring, tip);
    u.over.addEventListener("dblclick", whole);
    hide();
  };

  plot.addEventListener("keydown", (event) => {
    if (!u || event.ctrlKey || event.metaKey || event.altKey) return;
    const steps: Record<string, number> = { ArrowRight: 1, ArrowLeft: -1 };
    const by = steps[event.key];
    if (by !== undefined) {
      let at = current;
      for (let tries = 0; tries < order.length; ++tries) {
        at = at < 0 && by < 0 ? order.length - 1 : (at + by + order.length) % order.length;
        if (shown[order[at]!.k] && inside(order[at]!.mark)) break;
      }
      show(at, true);
    } else if (event.key === "+" || event.key === "=") zoom(0.7);
    else if (event.key === "-") zoom(1 / 0.7);
    else if (event.key === "0") whole();
    else if (event.key === "Escape") hide();
    else return;
    event.preventDefault();
  });
  plot.addEventListener("blur", hide);

  new ResizeObserver(([entry]) => {
    const width = Math.floor(entry!.contentRect.width);
    if (width < 40) return;
    if (!u) create(width);
    else if (width !== u.width) u.setSize({ width, height: spec.height ?? 360 });
  }).observe(plot);

  const keys = spec.series.map((s, k) => {
    const key = button("", () => {
      shown[k] = !shown[k];
      key.setAttribute("aria-pressed", String(shown[k]));
      u?.setSeries(k + 1, { show: shown[k]! });
      hide();
    }, { class: "key", "aria-pressed": "true" });
    key.append(swatch(lookOf(s, k).shape, s.marks.length > 0 && s.marks.every((m) => m.hollow), !!s.dashed, !!s.line), s.name);
    const paint = () => ((key.firstElementChild as SVGElement).style.color = colour(lookOf(s, k).colour));
    paint();
    onTheme(paint);
    return key;
  });
  onTheme(() => u?.redraw(false));

  return el(
    "figure",
    { class: "chart" },
    el("figcaption", { id: title }, spec.title),
    spec.note ? el("p", { class: "note" }, spec.note) : null,
    plot,
    el(
      "div",
      { class: "tools" },
      button("Zoom in", () => zoom(0.7)),
      button("Zoom out", () => zoom(1 / 0.7)),
      button("Show all", whole),
    ),
    spec.series.length > 1 || spec.series[0]?.label === undefined ? el("div", { class: "keys", role: "group", "aria-label": "Series, shown or hidden" }, ...keys) : null,
    spoken,
  );
}
