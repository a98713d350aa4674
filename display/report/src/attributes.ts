// Attribute micromaps of a scene, level by level: how many, how large, how far from its textures, and how they look.
import { mipsTable, plansTable } from "./attribute_plans";
import { chart, type Mark, type Series } from "./chart";
import { type AttributeRow, benches, type Report, type SceneAttributes } from "./data";
import { el, plainTable, select } from "./dom";
import { bytes, grouped, percent, plural, ranges, short } from "./format";
import { front } from "./front";
import { plotLook } from "./looks";

/** How maps are shown: faces; vertices, between which is interpolated or the nearest of which counts. */
interface Reading {
  name: string;
  bytes: (row: AttributeRow) => number;
  rmse: (row: AttributeRow) => number | undefined;
  flip: (row: AttributeRow) => number | undefined;
  packed: (row: AttributeRow) => number | undefined;
  dashed?: boolean;
}

export const readings: Reading[] = [
  { name: "faces", bytes: (r) => r.faces.bytes, rmse: (r) => r.faces.rmse, flip: (r) => r.faces.flip, packed: (r) => r.faces.packed?.bytes },
  { name: "vertices", bytes: (r) => r.vertices.bytes, rmse: (r) => r.vertices.rmse, flip: (r) => r.vertices.flip, packed: (r) => r.vertices.packed?.bytes },
  { name: "vertices, the nearest", bytes: (r) => r.vertices.bytes, rmse: (r) => r.vertices.nearest_rmse, flip: (r) => r.vertices.nearest_flip, packed: () => undefined, dashed: true },
];

const kinds = ["faces", "vertices"] as const;
type Kind = (typeof kinds)[number];
const byLevelAxis = { label: "level of every triangle", whole: true } as const;

/** Bytes of all packed maps at a level; nothing where some set of them was not packed. */
export function packedBytes(run: SceneAttributes, level: number, kind: Kind): number | undefined {
  const rows = run.rows.filter((r) => r.level === level);
  if (rows.some((r) => r[kind].packed === undefined)) return undefined;
  return rows.reduce((sum, r) => sum + r[kind].packed!.bytes, 0);
}

/** From which level on all maps of a kind take more than the textures, in words. */
export function beyondWords(run: SceneAttributes, kind: Kind): string {
  const level = run.beyond_textures[kind], last = Math.max(...run.totals.map((t) => t.level)), first = Math.min(...run.totals.map((t) => t.level));
  const name = kind === "faces" ? "Maps of faces" : "Maps of vertices";
  if (level > 16) return `${name} would take less than the textures at all levels up to 16, if they stayed as many as at level ${last}.`;
  if (level > last) return `${name} would take more than the textures from level ${level} on, if they stayed as many as at level ${last}.`;
  return `${name} take more than the textures from level ${level} on${level === first ? ", the lowest measured" : ""}.`;
}

function footprint(run: SceneAttributes): HTMLElement {
  if (run.totals.length === 1)
    return el(
      "div",
      { class: "wide" },
      ...kinds.map((kind) => {
        const total = run.totals[0]![kind];
        return el("p", {}, `All maps of ${kind}: ${bytes(total.bytes)}, ${percent(total.of_textures)} of the textures. ${beyondWords(run, kind)}`);
      }),
      el("p", { class: "note" }, "One level alone: --level A..B draws curves over levels."),
    );
  const crossings: Mark[][] = [];
  const line = (name: string, dashed: boolean, of: (level: number) => number | undefined, kind?: Kind): Series => ({
    name,
    line: true,
    dashed,
    look: plotLook(name),
    marks: run.totals.flatMap(({ level }) => {
      const y = of(level);
      if (y === undefined || y === 0) return [];
      const mark: Mark = { x: level, y, words: [`level ${level}`, bytes(y), `${percent(y / run.texture_bytes)} of the textures`] };
      if (kind && run.beyond_textures[kind] === level) crossings.push([mark]);
      return [mark];
    }),
  });
  const series = [
    ...kinds.map((kind) => line(kind, false, (level) => run.totals.find((t) => t.level === level)![kind].bytes, kind)),
    line("textures", false, () => run.texture_bytes),
    ...kinds.map((kind) => line(`${kind}, packed`, true, (level) => packedBytes(run, level, kind))),
  ].filter((s) => s.marks.length > 0);
  return chart({
    title: "Bytes of all maps by level",
    note: `4 bytes a value or a texel, without mips. ${kinds.map((k) => beyondWords(run, k)).join(" ")}${crossings.length > 0 ? " Ringed: the first level beyond the textures." : ""}`,
    x: byLevelAxis,
    y: { label: "bytes", log: true },
    series,
    fronts: crossings,
  });
}

/** Table 2 of the paper: how many maps there are, from the lowest level measured to the highest. */
export function countRows(run: SceneAttributes): string[][] {
  const between = (numbers: number[]) => (numbers.length > 1 ? `${grouped(numbers[0]!)}..${grouped(numbers.at(-1)!)}` : grouped(numbers[0]!));
  return run.sets.flatMap((set) => {
    const rows = run.rows.filter((r) => r.set === set.set).sort((a, b) => a.level - b.level);
    if (rows.length === 0) return [];
    return kinds.map((kind) => [
      set.set,
      kind,
      grouped(set.triangles),
      between(rows.map((r) => r[kind].maps)),
      between(rows.map((r) => set.triangles - r[kind].maps)),
      between(rows.map((r) => r[kind].constant)),
    ]);
  });
}

/** Everything that was measured of one set of attributes. */
function numbers(run: SceneAttributes, set: string): HTMLElement {
  const triangles = run.sets.find((s) => s.set === set)!.triangles;
  const optional = (x: number | undefined, words: (x: number) => string) => (x === undefined ? "" : words(x));
  const rows = run.rows
    .filter((r) => r.set === set)
    .flatMap((r) =>
      kinds.map((kind) => {
        const of = r[kind];
        return [
          String(r.level), kind, grouped(of.maps), grouped(triangles - of.maps), grouped(of.constant), grouped(of.bytes), percent(of.of_textures), optional(of.rmse, short), optional(of.flip, short),
          ...(kind === "faces" ? ["", "", optional(r.faces.unseen, percent)] : [optional(r.vertices.nearest_rmse, short), optional(r.vertices.nearest_flip, short), ""]),
        ];
      }),
    );
  const head = ["Level", "Maps of", "Maps", "Shared", "Constant", "Bytes", "Of textures", "RMSE", "FLIP", "RMSE, nearest", "FLIP, nearest", "Without texel"];
  return el("details", {}, el("summary", {}, "The numbers"), el("p", { class: "note" }, "Shared: triangles whose map is another's; constant: maps of one value; without texel: faces in which no texel's centre lies."), plainTable(`${set}, level by level`, head, rows));
}

function packedTable(run: SceneAttributes, set: string): HTMLElement | null {
  const rows = run.rows
    .filter((r) => r.set === set)
    .flatMap((r) =>
      kinds.flatMap((kind) => {
        const p = r[kind].packed;
        return p ? [[String(r.level), kind, grouped(p.plain), grouped(p.bytes), percent(p.of_plain), grouped(p.entropy), grouped(p.zstd), String(p.worst_error), short(p.rms_error)]] : [];
      }),
    );
  if (rows.length === 0) return null;
  const error = run.tool.packed_error ?? 0;
  const exactness = error === 0 ? "lossless" : `each code off by ${error} at most`;
  return el(
    "div",
    { class: "wide" },
    el("p", { class: "note" }, `Packed maps, ${exactness}. Plain: a byte a channel in use; entropy: order 0 of the residuals; zstd: level 19 of the plain bytes; errors: of what is decoded, in codes of 8 bits.`),
    plainTable(
      `${set}: bytes of packed maps`,
      ["Level", "Maps of", "Plain", "Packed", "Of plain", "Entropy", "zstd", "Worst error", "RMS error"],
      rows,
    ),
  );
}

/** How long a lookup takes at random points, in the texture and in its maps; both orders of the points. */
function timesTable(run: SceneAttributes, set: string): HTMLElement | null {
  const rows = (run.times ?? [])
    .filter((t) => t.set === set)
    .map((t) => [
      String(t.level), t.maps, grouped(t.points),
      ...[t.scattered, t.along].flatMap((o) => [short(o.texture_ns), short(o.map_ns), short(o.map_to_texture)]),
    ]);
  if (rows.length === 0) return null;
  return el(
    "div",
    { class: "wide" },
    el("p", { class: "note" }, "Nanoseconds a lookup, one thread, texture and map in turns. Scattered: each point on another triangle; along: triangle by triangle, along the curve."),
    plainTable(
      `${set}: the time of a lookup`,
      ["Level", "Maps of", "Points", "Texture, scattered", "Map, scattered", "Map to texture", "Texture, along", "Map, along", "Map to texture"],
      rows,
    ),
  );
}

export interface Measure {
  title: string;
  axis: string;
  of: (reading: Reading, row: AttributeRow) => number | undefined;
}

export const measures: Measure[] = [
  { title: "FLIP", axis: "mean FLIP", of: (reading, row) => reading.flip(row) },
  { title: "RMSE", axis: "RMSE, codes of 8 bits", of: (reading, row) => reading.rmse(row) },
];

function errorByLevel(rows: AttributeRow[], set: string, measure: Measure): HTMLElement {
  const series = readings
    .map((reading): Series => ({
      name: reading.name,
      line: true,
      dashed: !!reading.dashed,
      look: plotLook(reading.name),
      marks: rows.flatMap((row) => {
        const y = measure.of(reading, row);
        return y === undefined ? [] : [{ x: row.level, y, hollow: !!reading.dashed, words: [`level ${row.level}`, `${measure.title} ${short(y)}`] }];
      }),
    }))
    .filter((s) => s.marks.length > 0);
  return chart({ title: `${measure.title} of ${set} by level`, x: byLevelAxis, y: { label: measure.axis, from: 0 }, series });
}

/** A mark a level of each reading, packed ones besides where they lose nothing; what nothing beats in both is ringed. */
function errorByBytes(run: SceneAttributes, rows: AttributeRow[], set: string, measure: Measure): HTMLElement {
  const texture = run.sets.find((s) => s.set === set)!.texture_bytes;
  const lossless = run.tool.packed_error === 0;
  const line = (name: string, dashed: boolean, reading: Reading, size: (row: AttributeRow) => number | undefined): Series => ({
    name,
    line: true,
    dashed,
    look: plotLook(name),
    marks: rows.flatMap((row) => {
      const x = size(row), y = measure.of(reading, row);
      if (x === undefined || x === 0 || y === undefined) return [];
      return [{ x, y, hollow: !!reading.dashed, words: [`level ${row.level}`, `${bytes(x)}, ${percent(x / texture)} of the textures`, `${measure.title} ${short(y)}`] }];
    }),
  });
  const plain = readings.map((reading) => line(reading.name, !!reading.dashed, reading, reading.bytes));
  const packed = lossless ? readings.map((reading) => line(`${reading.name}, packed`, true, reading, reading.packed)) : [];
  const series = [...plain, ...packed].filter((s) => s.marks.length > 0);
  return chart({
    title: `${measure.title} of ${set} against bytes`,
    note: `A mark a level; its textures take ${bytes(texture)}. Ringed, joined by steps: what no maps of 4 bytes a value beat in both.`,
    x: { label: "bytes of its maps", log: true },
    y: { label: measure.axis, from: 0 },
    series,
    fronts: [front(plain.flatMap((s) => s.marks))],
  });
}

/** A mark a level of each kind of maps that lookups were timed in, at points along surfaces. */
export function timedSeries(run: SceneAttributes, set: string, measure: Measure): Series[] {
  const timed = (run.times ?? []).filter((t) => t.set === set);
  return [...new Set(timed.map((t) => t.maps))]
    .map((maps): Series => ({
      name: maps,
      line: true,
      dashed: false,
      look: plotLook(maps),
      marks: timed.filter((t) => t.maps === maps).flatMap((t) => {
        const row = run.rows.find((r) => r.set === set && r.level === t.level);
        const y = row && measure.of(maps === "faces" ? readings[0]! : readings[1]!, row);
        if (y === undefined) return [];
        return [{ x: t.along.map_ns, y, words: [`level ${t.level}`, `${short(t.along.map_ns)} ns, ${short(t.along.map_to_texture)} of the texture's`, `${measure.title} ${short(y)}`] }];
      }),
    }))
    .filter((s) => s.marks.length > 0);
}

function errorByTime(run: SceneAttributes, set: string, measure: Measure): HTMLElement[] {
  const series = timedSeries(run, set, measure);
  if (series.length === 0) return [];
  return [
    chart({
      title: `${measure.title} of ${set} against the time of a lookup`,
      note: "A mark a level, of points along surfaces. Ringed, joined by steps: what nothing beats in both.",
      x: { label: "ns a lookup", log: true },
      y: { label: measure.axis, from: 0 },
      series,
      fronts: [front(series.flatMap((s) => s.marks))],
    }),
  ];
}

/** One of some things, chosen from a list where there are several. */
function chosen(label: string, names: string[], make: (name: string) => HTMLElement): HTMLElement {
  const box = el("div", {}, make(names[0]!));
  if (names.length === 1) return box;
  const list = select(label, names.map((value) => ({ value, words: value })), (name) => box.replaceChildren(make(name)));
  return el("div", {}, el("div", { class: "tools" }, list.box), box);
}

function ofSet(run: SceneAttributes, set: string): HTMLElement {
  const rows = run.rows.filter((r) => r.set === set).sort((a, b) => a.level - b.level);
  const several = rows.length > 1;
  const known = measures.filter((m) => rows.some((row) => readings.some((r) => m.of(r, row) !== undefined)));
  return el(
    "div",
    { class: "charts" },
    ...(several ? known.map((m) => errorByLevel(rows, set, m)) : []),
    ...known.map((m) => errorByBytes(run, rows, set, m)),
    ...known.flatMap((m) => errorByTime(run, set, m)),
    el("div", { class: "wide" }, numbers(run, set)),
    packedTable(run, set),
    plansTable(run, set),
    mipsTable(run, set),
    timesTable(run, set),
  );
}

interface Shown {
  level: number;
  png?: string;
  why?: string;
}

function onePicture(image: string, shown: Shown): HTMLElement {
  if (shown.png === undefined) return el("p", { class: "note" }, `The picture of level ${shown.level} is not here: ${shown.why ?? "no reason known"}.`);
  const words = `${image} at level ${shown.level}: above the texture, faces and vertices; below FLIP's scale, from 0 on the left to 1, the FLIP of faces and that of vertices`;
  return el(
    "figure",
    {},
    el("div", { class: "scrolls", tabindex: "0", role: "region", "aria-label": `Picture of ${image}` }, el("div", { class: "sheet" }, el("div", { class: "columns", "aria-hidden": "true" }, el("span", {}, "texture, FLIP's scale"), el("span", {}, "faces"), el("span", {}, "vertices")), el("img", { src: `data:image/png;base64,${shown.png}`, alt: words }))),
    el("figcaption", { class: "note" }, `${words}.`),
  );
}

function pictures(report: Report, file: number, run: SceneAttributes): HTMLElement | null {
  const named = (run.pictures ?? []).map((p, k) => ({ ...p, ...report.pictures.find((shown) => shown.file === file && shown.picture === k) }));
  if (named.length === 0) return null;
  const name = (p: { set: string; image: string }) => (run.sets.length > 1 ? `${p.image}, ${p.set}` : p.image);
  const of = (words: string) => named.filter((p) => name(p) === words);
  return el(
    "div",
    {},
    el("h4", {}, "Pictures"),
    chosen("Image", [...new Set(named.map(name))], (image) => {
      const levels = of(image).map((p) => String(p.level));
      return chosen("Level of the picture", levels, (level) => onePicture(image, of(image).find((p) => String(p.level) === level)!));
    }),
  );
}

function oneRun(report: Report, file: number, name: string, run: SceneAttributes): HTMLElement {
  const left = run.left_out ?? [];
  const averages = run.tool.averaging === "codes" ? "codes are averaged as they are" : "light is averaged, and directions of normals";
  return el(
    "div",
    {},
    el("h3", {}, run.file, el("span", { class: "from" }, ` from ${name}`)),
    el(
      "p",
      {},
      `${plural(run.triangles, "triangle")} and ${plural(run.images, "texture")} of ${bytes(run.texture_bytes)}, each triangle's textures as micromaps of one level: ${ranges([...new Set(run.totals.map((t) => t.level))])}. In a face ${averages}. ` +
        `Errors are of the texels that a triangle shows, in texture space.` +
        (run.far > 0 ? ` ${plural(run.far, "map")} of triangles over 2^24 texels were left out.` : ""),
    ),
    el(
      "div",
      { class: "charts" },
      footprint(run),
      el(
        "div",
        { class: "wide" },
        el("p", { class: "note" }, "How many different maps there are, from the lowest level to the highest. Shared: triangles whose map is another's; constant: maps of one value."),
        plainTable("Maps", ["Attributes", "Maps of", "Triangles", "Maps", "Shared", "Constant"], countRows(run)),
        left.length > 0 ? plainTable("Left out", ["Why", "Primitives", "Triangles"], left.map((l) => [l.why, grouped(l.primitives), grouped(l.triangles)])) : null,
      ),
    ),
    chosen("Attributes", run.sets.map((s) => s.set), (set) => ofSet(run, set)),
    pictures(report, file, run),
  );
}

export const attributeSections = (report: Report): HTMLElement[] =>
  benches(report, "scene_attributes").map(({ file, name, content }) => oneRun(report, file, name, content));
