// What `mmverify validate` found.
import { el } from "../../../report/src/dom";
import { plural } from "../../../report/src/format";

export interface Finding {
  code: string;
  severity: "error" | "warning" | "advice";
  pointer: string;
  found: string;
  says: string;
  source: string;
  remedy: string;
}
export interface Validated {
  file: string;
  kind: string;
  drafts: string[];
  findings: Finding[];
  errors: number;
  warnings: number;
  advice: number;
}

const signs = { error: "✗", warning: "!", advice: "–" };

export function findings(found: Validated): HTMLElement {
  const counts = [plural(found.errors, "error"), plural(found.warnings, "warning"), plural(found.advice, "piece of advice", "pieces of advice")].join(", ");
  const drafts = found.drafts.length > 0 ? ` (draft ${found.drafts.join(", ")})` : "";
  return el(
    "div",
    {},
    el("h3", {}, "Findings"),
    el("p", {}, `${found.kind}${drafts}: ${counts}.`),
    found.findings.length === 0
      ? null
      : el(
          "ul",
          { class: "findings" },
          ...found.findings.map((f) =>
            el(
              "li",
              { "data-severity": f.severity },
              el("strong", { class: f.severity === "error" ? "wrong" : "" }, `${signs[f.severity]} ${f.severity} `),
              el("code", {}, f.code),
              f.pointer === "" ? null : el("span", { class: "from" }, ` at ${f.pointer}`),
              el("p", {}, `${f.found}. Where all is well: ${f.says} (${f.source}).`),
              el("p", {}, `To mend it: ${f.remedy}.`),
            ),
          ),
        ),
  );
}
