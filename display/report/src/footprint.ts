// Bytes of a scene's opacity, form by form; and by level, where it was asked with --sizes.
import { chart, type Series } from "./chart";
import { type Footprint, type Report, type Saved, scenes } from "./data";
import { el, plainTable } from "./dom";
import { bytes, grouped, percent } from "./format";

const forms: { name: string; of: (f: Footprint) => number; dashed?: boolean }[] = [
  { name: "micromaps, 4-state", of: (f) => f.modes[1]!.data_bytes },
  { name: "micromaps, 2-state", of: (f) => f.modes[0]!.data_bytes, dashed: true },
  { name: "tree, 4-state", of: (f) => f.modes[1]!.tree_bytes },
  { name: "tree, 2-state", of: (f) => f.modes[0]!.tree_bytes, dashed: true },
  { name: "tree for random access, 4-state", of: (f) => f.modes[1]!.random_access_tree_bytes },
  { name: "bitmask, 4-state", of: (f) => f.modes[1]!.bitmask_bytes },
  { name: "texture", of: (f) => f.texture_bytes },
  { name: "records and indices", of: (f) => f.record_bytes + f.index_bytes },
];

const shares: { name: string; of: (s: Saved) => number }[] = [
  { name: "opaque", of: (s) => s.opaque },
  { name: "transparent", of: (s) => s.transparent },
  { name: "unknown: the shader is called", of: (s) => s.unknown },
];

function sizesTable(f: Footprint): HTMLElement {
  const [two, four] = [f.modes[0]!, f.modes[1]!];
  const pair = (words: string, of: (m: typeof two) => number) => [words, bytes(of(two)), bytes(of(four))];
  const both = (words: string, n: number) => [words, bytes(n), bytes(n)];
  return plainTable(
    `The baked scene: ${grouped(f.micromaps)} micromaps, ${grouped(f.special_indices)} special indices`,
    ["", "2 states", "4 states"],
    [
      pair("micromaps, packed", (m) => m.data_bytes),
      pair("tree", (m) => m.tree_bytes),
      pair("tree for random access", (m) => m.random_access_tree_bytes),
      pair("bitmask of the textures", (m) => m.bitmask_bytes),
      both("alpha textures", f.texture_bytes),
      both("records and indices", f.record_bytes + f.index_bytes),
      both("vertex data", f.vertex_data_bytes),
    ],
  );
}

export function footprintCharts(report: Report): HTMLElement[] {
  return scenes(report).flatMap(({ name, scene }) => {
    if (!scene.footprint) return [];
    const made: HTMLElement[] = [];
    const title = el("h3", {}, scene.file, el("span", { class: "from" }, ` from ${name}`));
    const { sizes } = scene;
    if (sizes && sizes.length > 1) {
      const series = forms
        .map((form): Series => ({
          name: form.name,
          line: true,
          dashed: !!form.dashed,
          marks: sizes.flatMap((s) => {
            const y = form.of(s.footprint);
            return y > 0 ? [{ x: s.level, y, words: [`every triangle at level ${s.level}`, bytes(y)] }] : [];
          }),
        }))
        .filter((s) => s.marks.length > 0);
      made.push(chart({ title: "Footprint by level", x: { label: "level of every triangle", whole: true }, y: { label: "bytes", log: true }, series }));
      made.push(
        chart({
          title: "Where no shader is called, by level",
          note: "Shares of the placed area.",
          x: { label: "level of every triangle", whole: true },
          y: { label: "%", from: 0, to: 100 },
          series: shares.map((share): Series => ({
            name: share.name,
            line: true,
            marks: sizes.map((s) => ({ x: s.level, y: 100 * share.of(s.saved), words: [`level ${s.level}`, percent(share.of(s.saved))] })),
          })),
        }),
      );
    } else made.push(el("p", { class: "note" }, "No sizes by level: mmverify scene --sizes A..B adds them."));
    made.push(sizesTable(scene.footprint));
    return [title, el("div", { class: "charts" }, ...made)];
  });
}
