// Verdicts as the report page shows them: the table, and the triangle of what is refuted.
import { type Report, runs } from "../../../report/src/data";
import { el } from "../../../report/src/dom";
import { verdictMark, verdictTable } from "../../../report/src/table";
import { type Showing, triangleSection } from "../../../report/src/triangle";
import { groups, verdicts } from "../../../report/src/verdicts";

export function verdictPart(report: Report, showing: Showing = {}): HTMLElement[] {
  const all = groups(runs(report));
  if (all.length === 0) return [el("p", {}, "No law applies.")];
  const counts = verdicts.flatMap((v) => {
    const n = all.filter((g) => g.verdict === v).length;
    return n > 0 ? [el("li", {}, el("strong", {}, String(n)), " ", verdictMark(v))] : [];
  });
  const refuted = all.filter((g) => g.verdict === "refuted" && g.results.some((r) => r.result.counterexample !== null));
  return [
    el("ul", { class: "summary", "aria-label": "Laws by verdict" }, ...counts),
    ...(refuted.length > 0 ? [triangleSection(report, refuted, showing)] : []),
    verdictTable(all),
  ];
}
