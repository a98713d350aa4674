// Error against run time, a chart a topic, with what nothing beats in both.
import { chart, type Mark, type Series } from "./chart";
import { type AttributeBench, type BakeBench, benches, type IndexBench, type Report, type TreeBench, type VqBench, type VqEncoded, type VqRow } from "./data";
import { el, plainTable, select } from "./dom";
import { grouped, percent, short } from "./format";
import { front } from "./front";
import { plotLook } from "./looks";

/** A decade below a logarithmic axis's least: where marks lie that have no error at all. */
export const below = (least: number): number => Number(`1e${Math.floor(Math.log10(least) + 1e-9) - 1}`);

interface Entry {
  name: string;
  ns: number;
  /** 0: none found. */
  error: number;
  words: string[];
  /** Only what is of one kind is compared: it has a front of its own. */
  kind: string;
}

const frontNote = "Ringed, joined by steps: what nothing of its kind beats in both. Hollow: none found, which a logarithmic axis has no place for.";

function tradeChart(title: string, x: string, y: string, entries: Entry[], floorWords: string, note: string): HTMLElement {
  const errors = entries.map((e) => e.error).filter((e) => e > 0);
  const zero = entries.some((e) => e.error === 0);
  const floor = below(Math.min(...(errors.length > 0 ? errors : [1])));
  const marks = entries.map((e): Mark & { error: number } => ({ x: e.ns, y: e.error > 0 ? e.error : floor, words: e.words, hollow: e.error === 0, error: e.error }));
  const series = entries.map((e, k): Series => ({ name: e.name, marks: [marks[k]!], label: e.name, look: plotLook(e.name) }));
  return chart({
    title,
    note: `${note} ${frontNote}`,
    x: { label: x, log: true },
    y: { label: y, log: true, ...(zero ? { floor: { at: floor, words: floorWords } } : {}) },
    series,
    fronts: [...new Set(entries.map((e) => e.kind))].map((kind) => front(marks.filter((_, k) => entries[k]!.kind === kind))),
  });
}

const numbersBelow = (caption: string, head: string[], rows: string[][]): HTMLElement =>
  el("details", {}, el("summary", {}, "The numbers"), plainTable(caption, head, rows));

/** A chart of one of some levels, chosen from a list. */
function byLevel(levels: number[], first: number, make: (level: number) => HTMLElement): HTMLElement {
  const box = el("div", {}, make(first));
  const list = select("Level", levels.map((n) => ({ value: String(n), words: String(n) })), (value) => box.replaceChildren(make(Number(value))));
  list.list.value = String(first);
  return el("div", {}, el("div", { class: "tools" }, list.box), box);
}

export function indexEntries(bench: IndexBench, level: number): Entry[] {
  return bench.subjects.flatMap((s) => {
    // A float kind may end below the level: binary16 does.
    const at = Math.min(level, Math.max(...bench.rows.filter((r) => r.subject === s.subject).map((r) => r.level)));
    const row = bench.rows.find((r) => r.subject === s.subject && r.level === at);
    const stiff = s.errors.find((e) => e.inputs === "stiff" && e.level === at);
    const uniform = s.errors.find((e) => e.inputs === "uniform" && e.level === at);
    if (!row || !stiff || stiff.samples === 0) return [];
    const error = stiff.mismatches / stiff.samples;
    return [
      {
        name: s.subject,
        ns: row.ns_per_index,
        error,
        words: [
          `${short(row.ns_per_index)} ns an index, level ${at}`,
          stiff.mismatches === 0 ? `none wrong of ${grouped(stiff.samples)} stiff points` : `${short(error)} of the stiff points wrong (${grouped(stiff.mismatches)} of ${grouped(stiff.samples)})`,
          ...(uniform && uniform.samples > 0 ? [`${short(uniform.mismatches / uniform.samples)} of the uniform ones`] : []),
          `${s.numbers}, ${s.order === "rows" ? "row order" : s.order}`,
        ],
        kind: s.order,
      },
    ];
  });
}

function indexChart(bench: IndexBench): HTMLElement {
  const levels = [...new Set(bench.rows.map((r) => r.level))].sort((a, b) => a - b);
  return byLevel(levels, levels.at(-1)!, (level) => {
    const entries = indexEntries(bench, level);
    return el(
      "div",
      {},
      tradeChart(`Index, level ${level}`, "ns an index, one thread", "share of stiff points wrong", entries, "none", "Subjects that end below the level are shown at their last one. The curve and row order have a front each."),
      numbersBelow(`Index, level ${level}`, ["Subject", "ns", "Wrong, of stiff points"], entries.map((e) => [e.name, short(e.ns), e.error === 0 ? "none" : short(e.error)])),
    );
  });
}

function bakeChart(bench: BakeBench): HTMLElement {
  const levels = bench.rows.map((r) => r.level);
  return byLevel(levels, levels[Math.floor(levels.length / 2)]!, (level) => {
    const entries = bench.rows
      .find((r) => r.level === level)!
      .bakers.filter((b) => b.states > 0)
      .map((b): Entry => {
        const million = (n: number) => (1e6 * n) / b.states;
        return {
          name: b.baker,
          ns: b.ns,
          kind: "",
          error: million(b.wrong + b.needless),
          words: [`${short(b.ns)} ns a micro-triangle`, `${short(million(b.wrong))} wrong, ${short(million(b.needless))} needlessly unknown, of a million`, `${grouped(b.states)} states`],
        };
      });
    return el(
      "div",
      {},
      tradeChart(`Bake, level ${level}`, "ns a micro-triangle, one thread", "wrong or needless, of a million", entries, "none", "Wrong: said to be opaque or transparent and not so on all of it. Needless: unknown, and it could be said."),
      numbersBelow(`Bake, level ${level}`, ["Baker", "ns", "Wrong or needless, of a million"], entries.map((e) => [e.name, short(e.ns), e.error === 0 ? "none" : short(e.error)])),
    );
  });
}

/** Remaps, at a level at which each of them has a number. */
function attributeChart(bench: AttributeBench): HTMLElement {
  const levels = bench.remaps.map((r) => r.level);
  const sound = bench.remaps.filter((r) => r.ways.every((w) => w.no_number === 0)).map((r) => r.level);
  return byLevel(levels, sound.at(-1) ?? levels[0]!, (level) => {
    const row = bench.remaps.find((r) => r.level === level)!;
    const entries = row.ways
      .filter((w) => w.no_number === 0)
      .map((w): Entry => ({
        name: w.remap,
        ns: w.ns,
        kind: "",
        error: w.worst,
        words: [`${short(w.ns)} ns a point`, w.worst === 0 ? "no error found" : `worst ${short(w.worst)} heights`, `${grouped(row.samples)} points`],
      }));
    return el(
      "div",
      {},
      tradeChart(`Attribute: weights on the micro-triangle, level ${level}`, "ns a point, one thread", "worst error, heights of the micro-triangle", entries, "none", "In binary32. A way that has no number for some point is left out."),
      numbersBelow(`Attribute, level ${level}`, ["Remap", "ns", "Worst, heights"], entries.map((e) => [e.name, short(e.ns), e.error === 0 ? "none" : short(e.error)])),
    );
  });
}

/** All maps together: the share of O and T that became unknown, the time of a map. */
export function vqEntries(rows: VqRow[]): Entry[] {
  const of = (codec: "vq2" | "vq4", states: (row: VqRow) => number): Entry[] => {
    const all = rows.reduce((sum, row) => sum + states(row), 0);
    const encoders = new Map<string, VqEncoded[]>();
    for (const row of rows) for (const e of row[codec]) encoders.set(e.encoder, [...(encoders.get(e.encoder) ?? []), e]);
    return [...encoders].map(([encoder, each]) => {
      const lost = each.reduce((sum, e) => sum + e.substitutions, 0);
      const ms = each.reduce((sum, e) => sum + e.ms, 0) / each.length;
      const savings = each.reduce((sum, e) => sum + e.savings, 0) / each.length;
      const share = all > 0 ? lost / all : 0;
      return {
        name: `${codec.toUpperCase()} ${encoder}`,
        kind: codec,
        ns: ms,
        error: 100 * share,
        words: [`${short(ms)} ms a map`, `${percent(share)} of O and T became unknown: ${grouped(lost)} of ${grouped(all)}`, `${percent(savings)} saved in the mean`],
      };
    });
  };
  return [...of("vq2", (r) => r.states_16), ...of("vq4", (r) => r.states_32)];
}

function vqChart(bench: VqBench): HTMLElement {
  const entries = vqEntries(bench.rows);
  return el(
    "div",
    {},
    tradeChart("VQ encoders", "ms a map, one thread", "% of O and T lost", entries, "none", `${bench.rows.length} maps together. VQ2 keeps 16x16 regions, VQ4 32x32 in twice the bits; each has a front.`),
    numbersBelow("VQ encoders", ["Encoder", "ms a map", "% of O and T lost"], entries.map((e) => [e.name, short(e.ns), short(e.error)])),
  );
}

function treeCharts(bench: TreeBench): HTMLElement[] {
  const states = [...new Set(bench.rows.map((r) => r.states))];
  return states.map((s) => {
      const forms = new Map<string, Mark[]>();
      for (const row of bench.rows.filter((r) => r.states === s))
        for (const f of row.forms)
          forms.set(f.form, [
            ...(forms.get(f.form) ?? []),
            { x: f.ns_per_lookup, y: f.bits_per_micro_triangle, words: [`level ${row.level}`, `${short(f.ns_per_lookup)} ns a lookup`, `${short(f.bits_per_micro_triangle)} bits a micro-triangle`] },
          ]);
      const series = [...forms].map(([name, marks]): Series => ({ name, marks, label: name }));
      const highest = Math.max(...bench.rows.map((r) => r.level));
      const last = series.flatMap((x) => x.marks).filter((m) => m.words[0] === `level ${highest}`);
      return chart({
        title: `Tree, ${s} states: size against time`,
        note: `All forms are exact, so their price is memory: a mark a level. The front is that of level ${highest}.`,
        x: { label: "ns a lookup, one thread", log: true },
        y: { label: "bits a micro-triangle", log: true },
        series,
        fronts: [front(last)],
      });
    });
}

/** Charts of all topics that a bench was given of. */
export function tradeCharts(report: Report): HTMLElement[] {
  return [
    ...benches(report, "index").map((b) => indexChart(b.content)),
    ...benches(report, "tree").flatMap((b) => treeCharts(b.content)),
    ...benches(report, "vq").map((b) => vqChart(b.content)),
    ...benches(report, "bake").map((b) => bakeChart(b.content)),
    ...benches(report, "attribute").map((b) => attributeChart(b.content)),
  ];
}
