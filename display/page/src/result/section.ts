// A result of the native program, opened as mmverify report shows it.
import { el, fresh } from "../../../report/src/dom";
import { reportParts } from "../../../report/src/sections";
import { reportOfFiles } from "./read";

export interface ResultSection {
  nodes: HTMLElement[];
  take: (files: File[]) => void;
}

export function resultSection(): ResultSection {
  const out = el("div", { class: "came" });
  const take = async (files: File[]): Promise<void> => {
    try {
      const named = await Promise.all(files.filter((f) => /\.json$/i.test(f.name)).map(async (f) => ({ name: f.name, text: await f.text() })));
      if (named.length === 0) throw new Error(`${files.map((f) => f.name).join(", ")}: a result is a file that ends in .json.`);
      const { top, nav, sections, missing } = reportParts(reportOfFiles(named), "h3");
      out.replaceChildren(...top, nav, ...sections, ...(missing ? [missing] : []));
    } catch (error) {
      out.replaceChildren(el("p", { class: "wrong", role: "alert" }, error instanceof Error ? error.message : String(error)));
    }
  };
  const id = fresh("result");
  const input = el("input", { id, type: "file" });
  input.accept = ".json";
  input.multiple = true;
  input.addEventListener("change", () => input.files && input.files.length > 0 && void take([...input.files]));
  return {
    nodes: [
      el("p", {}, "A file that the native program wrote with ", el("code", {}, "--json"), ": verdicts, counterexamples on the triangle, a scene's plan, charts of a bench. The page shows what the file says, and runs no law again."),
      el("div", { class: "drop" }, el("p", {}, el("label", { for: id }, "Drop a result.json anywhere on this page, or choose one:")), el("div", { class: "tools" }, input)),
      out,
    ],
    take: (files) => void take(files),
  };
}
