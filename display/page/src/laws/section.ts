// Every law: what it says, where that is from, and a button that runs it here.
import { type ResultFile, runs } from "../../../report/src/data";
import { button, el, fresh, plainTable, select } from "../../../report/src/dom";
import { grouped, plural, seconds } from "../../../report/src/format";
import { verdictMark } from "../../../report/src/table";
import { counterexamplesOf, groups, levelsText } from "../../../report/src/verdicts";
import { check } from "../judge/fields";
import { jsonOf, runProgram } from "../program/client";
import type { Ended } from "../program/messages";
import { reportOf } from "../program/report_of";
import { TaskBox } from "../program/task_box";
import { type Law, type Listed, smallLevels, whyNotHere } from "./law";

const json = "/tmp/result.json";
const limit = 120;

function outcome(law: Law, ended: Ended): Node[] {
  const result = jsonOf<ResultFile>(ended, json);
  const all = groups(runs(reportOf(law.law, result)));
  const nodes: Node[] = [
    plainTable(
      "What was found",
      ["Law", "Subject", "Levels", "Cases", "Verdict", "Time"],
      all.map((g) => [g.law, g.subject, levelsText(g), grouped(g.cases), verdictMark(g.verdict), seconds(g.seconds)]),
    ),
  ];
  for (const g of all) {
    const c = counterexamplesOf(g)[0];
    if (c) nodes.push(el("p", {}, `${g.subject}, level ${c.level ?? "?"}: case `, el("code", {}, c.counterexample.case), `, expected ${c.counterexample.expected}, got `, el("strong", { class: "wrong" }, String(c.counterexample.got)), "."));
    const reasons = new Set(g.results.flatMap((r) => r.result.reason ?? []));
    for (const reason of reasons) nodes.push(el("p", { class: "note" }, `${g.subject}: ${reason}.`));
  }
  const mutants = result.mutants ?? [];
  if (mutants.length > 0)
    nodes.push(el("p", {}, `Of ${plural(mutants.length, "subject")} that ${mutants.length === 1 ? "is" : "are"} wrong on purpose, ${mutants.filter((m) => m.killed).length} ${mutants.length === 1 ? "was" : "were"} refuted.`));
  return nodes;
}

function lawBody(law: Law, mutants: () => boolean): HTMLElement {
  const why = whyNotHere(law);
  const rows: [string, string][] = [
    ["From", law.source],
    ["Over", law.domain],
    ["How", `${law.method}${law.tiers.fast ? `; natively, ${law.tiers.fast.levels.replace(/^(?=\d)/, "levels ")} in about ${law.tiers.fast.expected_seconds} s` : ""}`],
    ["Asked of", law.subjects.join(", ")],
  ];
  if (law.mutants.length > 0) rows.push(["Wrong on purpose, to be caught", law.mutants.join("; ")]);
  const body = el("div", { class: "law-body" }, el("dl", {}, ...rows.flatMap(([term, words]) => [el("dt", {}, term), el("dd", {}, words)])));
  if (why) {
    body.append(el("p", { class: "note" }, `Not here: ${why}`));
    return body;
  }
  const levels = smallLevels(law);
  const box = new TaskBox();
  const run = (): void => {
    const args = ["prove", law.law, "--no-companions", "--threads", "1", "--quiet", "--json", json, ...(levels ? ["--levels", levels] : []), ...(mutants() ? [] : ["--no-mutants"])];
    void box.run(`Running ${law.law}...`, runProgram({ args, wanted: [json] }, limit), (ended) => outcome(law, ended));
  };
  body.append(el("div", { class: "tools" }, button(`Run it here${levels ? `, levels ${levels}` : ""}`, run, { "aria-label": `Run ${law.law} here${levels ? `, levels ${levels}` : ""}` })), box.root);
  return body;
}

function lawItem(law: Law, mutants: () => boolean): HTMLElement {
  const item = el("details", { class: "law", "data-law": law.law }, el("summary", {}, el("code", {}, law.law), " ", el("span", {}, law.statement)));
  // The bodies of 259 laws would be thousands of elements.
  item.addEventListener("toggle", () => item.open && item.childElementCount === 1 && item.append(lawBody(law, mutants)));
  return item;
}

function lawList({ laws }: Listed): Node[] {
  const id = fresh("filter");
  const filter = el("input", { id, type: "search", placeholder: "word of a law..." });
  const topics = [...new Set(laws.map((l) => l.topic))];
  const topic = select("Topic", [{ value: "", words: "all" }, ...topics.map((t) => ({ value: t, words: t }))], () => apply());
  const mutants = check("with the subjects that are wrong on purpose");
  const count = el("p", { class: "count", "aria-live": "polite" });
  const items = laws.map((law) => ({ law, item: lawItem(law, mutants.get), text: `${law.law} ${law.statement} ${law.source}`.toLowerCase() }));
  const apply = (): void => {
    const words = filter.value.toLowerCase().split(/\s+/);
    let n = 0;
    for (const { law, item, text } of items) {
      item.hidden = !(words.every((w) => text.includes(w)) && (topic.list.value === "" || law.topic === topic.list.value));
      if (!item.hidden) ++n;
    }
    const native = laws.filter((l) => whyNotHere(l) !== null).length;
    count.textContent = `${n === laws.length ? plural(n, "law") : `${n} of ${plural(laws.length, "law")}`}; ${native} of all need the native program.`;
  };
  filter.addEventListener("input", apply);
  apply();
  return [
    el("div", { class: "tools" }, el("span", { class: "field" }, el("label", { for: id }, "Filter"), filter), topic.box, mutants.box, count),
    el("div", { class: "laws", role: "group", "aria-label": "Laws" }, ...items.map((i) => i.item)),
  ];
}

export function lawsSection(): HTMLElement[] {
  const box = new TaskBox();
  void box.run("Asking the program for its laws...", runProgram({ args: ["list", "--json"] }, limit), ({ stdout }) => lawList(JSON.parse(stdout) as Listed));
  return [
    el("p", {}, `A law is a sentence that an implementation must obey. Open one to see where it comes from, and run it on the subjects that are built in, at its lowest levels. Proved: every case of the named domain was run. Checked: a sample passed. Time limit: ${limit} s.`),
    box.root,
  ];
}
