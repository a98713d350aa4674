// The page: reads its data, puts the sections together.
import type { Report } from "./data";
import { el } from "./dom";
import { reportParts } from "./sections";
import { themeButton } from "./theme";

function page(report: Report): HTMLElement[] {
  const { top, nav, sections, missing } = reportParts(report, "h2");
  return [
    el("header", {}, el("div", { class: "top" }, el("h1", {}, "mmverify report"), themeButton()), ...top, nav),
    ...sections,
    el("footer", {}, missing),
  ];
}

const data = document.getElementById("data")!.textContent!;
document.getElementById("page")!.replaceChildren(...page(JSON.parse(data) as Report));
