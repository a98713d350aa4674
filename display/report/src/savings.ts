// VQ savings, map by map in ascending order of the source's: what share of hits needs no shader.
import { chart, type Series } from "./chart";
import { benches, type Report, scenes, type VqRow } from "./data";
import { el, plainTable } from "./dom";
import { bytes, grouped, percent } from "./format";

type Line = { name: string; of: (row: VqRow) => number | undefined; dashed?: boolean };

const encoded = (codec: "vq2" | "vq4", encoder: string) => (row: VqRow) => row[codec].find((e) => e.encoder === encoder)?.savings;

const panels: { title: string; lines: Line[] }[] = [
  {
    title: "VQ2: 16x16 regions in 256 bits",
    lines: [
      { name: "source", of: (r) => r.savings["16x16"] },
      { name: "VQ2 optimal", of: encoded("vq2", "optimal") },
      { name: "the paper's Algorithm 1", of: encoded("vq2", "paper") },
      { name: "two of 64 sub-triangles, 2 bits each", of: (r) => r.savings["64x2"], dashed: true },
    ],
  },
  {
    title: "VQ4: 32x32 regions in 512 bits",
    lines: [
      { name: "source", of: (r) => r.savings["32x32"] },
      { name: "VQ4 balanced", of: encoded("vq4", "balanced") },
      { name: "the paper's Algorithm 2", of: encoded("vq4", "paper") },
      { name: "16x16, 2 bits each", of: (r) => r.savings["16x16"], dashed: true },
    ],
  },
];

export function savingsCharts(report: Report): HTMLElement[] {
  const made = benches(report, "vq").flatMap(({ content }) =>
    panels.map(({ title, lines }) => {
      const rows = [...content.rows].sort((a, b) => lines[0]!.of(a)! - lines[0]!.of(b)!);
      const series = lines
        .map((line): Series => ({
          name: line.name,
          line: true,
          dashed: !!line.dashed,
          marks: rows.flatMap((row, k) => {
            const y = line.of(row);
            return y === undefined ? [] : [{ x: k + 1, y: 100 * y, words: [row.map, `${percent(y)} saved`] }];
          }),
        }))
        .filter((s) => s.marks.length > 0);
      return chart({ title, note: "Savings: the share of a map that is known to be opaque or transparent.", x: { label: "maps, in order of the source", whole: true }, y: { label: "savings, %", from: 0, to: 100 }, series });
    }),
  );
  const coded = scenes(report).flatMap(({ scene }) =>
    (["vq2", "vq4"] as const).flatMap((codec) => {
      const v = scene[codec];
      if (!v || v.regions === 0) return [];
      return [[scene.file, codec.toUpperCase(), grouped(v.maps), grouped(v.uniform), bytes(v.bytes), percent(1 - v.unknown / v.regions), percent(1 - (v.unknown + v.substitutions) / v.regions)]];
    }),
  );
  if (coded.length > 0)
    made.push(
      el("div", { class: "wide" }, plainTable("Pairs of triangles of scenes as square maps", ["Scene", "Code", "Maps", "Uniform", "Bytes", "Savings, source", "Savings, coded"], coded)),
    );
  return made;
}
