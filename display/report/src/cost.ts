// Cost against level: of the benches, and of the laws that were run.
import { chart, type Mark, type Series } from "./chart";
import { benches, type Report, runs } from "./data";
import { el, plainTable, select } from "./dom";
import { grouped, seconds, short } from "./format";
import { plotLook } from "./looks";
import { type Group, groups } from "./verdicts";

const lines = (of: Map<string, Mark[]>): Series[] =>
  [...of].filter(([, marks]) => marks.length > 0).map(([name, marks]) => ({ name, marks, line: true, look: plotLook(name) }));

function add(of: Map<string, Mark[]>, name: string, x: number, y: number, words: string[]): void {
  if (!(y > 0)) return;
  of.set(name, [...(of.get(name) ?? []), { x, y, words: [`level ${x}`, ...words] }]);
}

const level = { label: "level", whole: true } as const;

function lawTimes(groups: Group[]): HTMLElement | null {
  const long = groups.filter((g) => new Set(g.results.filter((r) => r.result.cases_run > 0).map((r) => r.result.level)).size >= 3);
  if (long.length === 0) return null;
  const laws = [...new Set(long.map((g) => g.law))];
  const make = (law: string) => {
    const of = new Map<string, Mark[]>();
    const mine = long.filter((x) => x.law === law);
    const name = (g: Group) => (mine.some((o) => o !== g && o.subject === g.subject) ? `${g.subject}, ${g.run.name}` : g.subject);
    for (const g of mine)
      for (const { result: r } of g.results)
        if (r.level !== null && r.cases_run > 0)
          add(of, name(g), r.level, r.seconds, [seconds(r.seconds), `${grouped(r.cases_run)} cases, ${short(r.cases_run / Math.max(r.seconds, 1e-9) / 1e6)} million a second`]);
    return chart({ title: `Time of ${law}`, note: "As it was run, on as many threads as the run had.", x: level, y: { label: "seconds", log: true }, series: lines(of) });
  };
  // The law that took longest is the one that says most about cost.
  const time = (law: string) => long.filter((g) => g.law === law).reduce((sum, g) => sum + g.seconds, 0);
  const first = laws.reduce((a, b) => (time(b) > time(a) ? b : a));
  const box = el("div", {}, make(first));
  const list = select("Law", laws.map((l) => ({ value: l, words: l })), (law) => box.replaceChildren(make(law)));
  list.list.value = first;
  return el("div", {}, laws.length > 1 ? el("div", { class: "tools" }, list.box) : null, box);
}

export function costCharts(report: Report): HTMLElement[] {
  const made: HTMLElement[] = [];
  for (const { content: b } of benches(report, "index")) {
    const of = new Map<string, Mark[]>();
    for (const r of b.rows) add(of, r.subject, r.level, r.ns_per_index, [`${short(r.ns_per_index)} ns an index`]);
    made.push(chart({ title: "Index: time of one", x: level, y: { label: "ns an index", log: true }, series: lines(of) }));
  }
  for (const { content: b } of benches(report, "tree"))
    for (const states of new Set(b.rows.map((r) => r.states))) {
      const of = new Map<string, Mark[]>();
      for (const r of b.rows.filter((x) => x.states === states)) for (const f of r.forms) add(of, f.form, r.level, f.ns_per_lookup, [`${short(f.ns_per_lookup)} ns a lookup`]);
      made.push(chart({ title: `Tree, ${states} states: time of a lookup`, x: level, y: { label: "ns a lookup", log: true }, series: lines(of) }));
    }
  for (const { content: b } of benches(report, "bake")) {
    const of = new Map<string, Mark[]>();
    for (const r of b.rows) for (const x of r.bakers) add(of, x.baker, r.level, x.ns, [`${short(x.ns)} ns a micro-triangle`]);
    made.push(chart({ title: "Bake: time of a state", x: level, y: { label: "ns a micro-triangle", log: true }, series: lines(of) }));
  }
  for (const { content: b } of benches(report, "attribute")) {
    const of = new Map<string, Mark[]>();
    for (const r of b.rows) {
      if (r.bilinear_ns !== undefined) add(of, "bilinear texture", r.level, r.bilinear_ns, [`${short(r.bilinear_ns)} ns a sample`]);
      if (r.bilinear_simd_ns !== undefined) add(of, "bilinear texture, batched", r.level, r.bilinear_simd_ns, [`${short(r.bilinear_simd_ns)} ns a sample`]);
      for (const o of r.orders) if (o.lookup_ns !== undefined) add(of, o.order, r.level, o.lookup_ns, [`${short(o.lookup_ns)} ns a value`]);
    }
    made.push(chart({ title: "Attribute: time of a value", x: level, y: { label: "ns a value of RGBA8", log: true }, series: lines(of) }));
  }
  for (const { content: b } of benches(report, "scene")) {
    const of = new Map<string, Mark[]>();
    for (const r of b.rows) {
      add(of, "ours, exact", r.level, r.fastest_ns, [`${short(r.fastest_ns)} ns a micro-triangle`]);
      add(of, "centre sample", r.level, r.centre_ns, [`${short(r.centre_ns)} ns a micro-triangle`]);
    }
    made.push(chart({ title: `Bake of ${b.file}: time of a state`, x: level, y: { label: "ns a micro-triangle", log: true }, series: lines(of) }));
  }
  for (const { content: b } of benches(report, "sweep")) {
    const of = new Map<string, Mark[]>();
    for (const r of b.levels) {
      for (const name of ["step", "impl"] as const) add(of, name, r.level, r[name].seconds, [seconds(r[name].seconds), `${grouped(r.cells)} cells`]);
      if (r.plain_per_second) add(of, "plain loop", r.level, r.cells / r.plain_per_second, [seconds(r.cells / r.plain_per_second), `${grouped(r.cells)} cells`]);
    }
    made.push(chart({ title: `A sweep of index.equals_reference, ${b.threads} threads`, x: level, y: { label: "seconds", log: true }, series: lines(of) }));
  }
  const subjects = benches(report, "subject");
  if (subjects.length > 0)
    made.push(
      plainTable(
        "What judging a library costs, ns each",
        ["Library", "Level", "In a loop", "In a worker process", "Judged"],
        subjects.map(({ content: s }) => [s.subject, String(s.level), short(s.bare_ns), short(s.isolated_ns), short(s.judged_ns)]),
      ),
    );
  const laws = lawTimes(groups(runs(report)));
  if (laws) made.push(laws);
  return made;
}
