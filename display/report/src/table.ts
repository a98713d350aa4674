// The verdicts: a table to filter and to sort, with what is behind each row.
import type { Verdict } from "./data";
import { button, el, fresh, plainTable, select } from "./dom";
import { grouped, plural, seconds } from "./format";
import { counterexamplesOf, type Group, levelsOf, levelsText, verdictLook, verdicts } from "./verdicts";

type Column = "law" | "subject" | "levels" | "cases" | "verdict" | "time";

const columns: { id: Column; words: string; number?: boolean }[] = [
  { id: "law", words: "Law" },
  { id: "subject", words: "Subject" },
  { id: "levels", words: "Levels" },
  { id: "cases", words: "Cases", number: true },
  { id: "verdict", words: "Verdict" },
  { id: "time", words: "Time", number: true },
];

/** Rows shown before a button shows more: a page of ten thousand rows would be slow. */
const first = 400;

const natural = new Intl.Collator("en", { numeric: true });

export const orders: Record<Column, (a: Group, b: Group) => number> = {
  law: (a, b) => natural.compare(a.law, b.law),
  subject: (a, b) => natural.compare(a.subject, b.subject),
  levels: (a, b) => (levelsOf(a).at(-1) ?? 99) - (levelsOf(b).at(-1) ?? 99) || (levelsOf(a)[0] ?? 99) - (levelsOf(b)[0] ?? 99),
  cases: (a, b) => a.cases - b.cases,
  verdict: (a, b) => verdicts.indexOf(a.verdict) - verdicts.indexOf(b.verdict),
  time: (a, b) => a.seconds - b.seconds,
};

/** Whether every word of the filter is in the row's texts. */
export function matches(group: Group, words: string): boolean {
  const text = `${group.law} ${group.subject} ${group.topic} ${verdictLook[group.verdict].words} ${group.run.name}`.toLowerCase();
  return words
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}

export function verdictMark(verdict: Verdict): HTMLElement {
  const { sign, words, means } = verdictLook[verdict];
  return el("span", { class: `verdict ${verdict}`, title: means }, el("span", { class: "sign", "aria-hidden": "true" }, sign), words);
}

function details(group: Group, files: number): HTMLElement {
  const box = el("div", { class: "details" });
  const one = group.results[0]!.result;
  if (files > 1) box.append(el("p", {}, `From ${group.run.name}.`));
  box.append(el("p", {}, `${one.method}, over ${one.domain}${group.results.length > 1 ? ", and so on" : ""}.`));
  for (const reason of new Set(group.results.flatMap((r) => r.result.reason ?? []))) box.append(el("p", {}, reason));
  const found = counterexamplesOf(group);
  for (const { counterexample: c, level } of found.slice(0, 5)) {
    box.append(
      el("p", {}, `Level ${level ?? "?"}: case `, el("code", {}, c.case), c.hex ? ` ${c.hex}` : "", ", expected ", el("strong", {}, String(c.expected)), ", got ", el("strong", { class: "wrong" }, String(c.got))),
    );
    if (c.replay) box.append(el("pre", { tabindex: "0", "aria-label": "the command that shows it again" }, c.replay));
  }
  if (found.length > 5) box.append(el("p", {}, `and ${plural(found.length - 5, "more counterexample")}.`));
  for (const d of group.run.content.diagnoses ?? [])
    if (d.law === group.law && d.subject === group.subject) box.append(el("ul", {}, ...d.lines.map((line) => el("li", {}, line))));
  if (group.results.length > 1)
    box.append(
      plainTable(
        "Level by level",
        ["Level", "Cases", "Wrong", "Verdict", "Time"],
        group.results.map(({ result: r }) => [r.level === null ? "many" : String(r.level), grouped(r.cases_run), grouped(r.mismatches), verdictMark(r.verdict), seconds(r.seconds)]),
      ),
    );
  return box;
}

export function verdictTable(groups: Group[]): HTMLElement {
  let by: Column = "verdict";
  let up = true;
  let limit = first;
  const files = new Set(groups.map((g) => g.run.file)).size;
  const open = new Set<Group>();

  const filterId = fresh("filter");
  const filter = el("input", { id: filterId, type: "search", placeholder: "law, subject, file..." });
  const topics = [...new Set(groups.map((g) => g.topic))].sort();
  const present = verdicts.filter((v) => groups.some((g) => g.verdict === v));
  const topic = select("Topic", [{ value: "", words: "all" }, ...topics.map((t) => ({ value: t, words: t }))], () => render());
  const verdict = select("Verdict", [{ value: "", words: "all" }, ...present.map((v) => ({ value: v, words: verdictLook[v].words }))], () => render());
  const count = el("p", { class: "count", "aria-live": "polite" });
  const body = el("tbody");
  const more = button("", () => {
    limit += 10 * first;
    render();
  });
  filter.addEventListener("input", () => render());

  const heads = columns.map(({ id, words, number }) => {
    const head = el("th", { scope: "col", ...(number ? { class: "number" } : {}) });
    head.append(
      button(words, () => {
        up = by === id ? !up : true;
        by = id;
        render();
      }),
    );
    return { id, head };
  });

  const row = (g: Group): HTMLElement[] => {
    const label = `${g.law}, ${g.subject}`;
    const id = fresh("details");
    const toggle = button(g.law, () => {
      if (!open.delete(g)) open.add(g);
      const shown = open.has(g);
      toggle.setAttribute("aria-expanded", String(shown));
      if (shown) made.after(below());
      else made.nextElementSibling?.remove();
    }, { class: "more", "aria-expanded": String(open.has(g)), "aria-controls": id });
    const below = () => el("tr", { class: "below", id }, el("td", { colspan: String(columns.length) }, details(g, files)));
    const cell = (name: string, number: boolean, ...content: (Node | string)[]) => el("td", { "data-label": name, ...(number ? { class: "number" } : {}) }, ...content);
    const made = el(
      "tr",
      { "data-verdict": g.verdict, "aria-label": label },
      el("th", { scope: "row", "data-label": "Law" }, toggle, files > 1 ? el("span", { class: "from" }, ` ${g.run.name}`) : null),
      cell("Subject", false, g.subject),
      cell("Levels", false, levelsText(g)),
      cell("Cases", true, el("span", {}, grouped(g.cases), g.mismatches > 0 ? el("span", { class: "wrong" }, ` ${grouped(g.mismatches)} wrong`) : "")),
      cell("Verdict", false, verdictMark(g.verdict)),
      cell("Time", true, seconds(g.seconds)),
    );
    return open.has(g) ? [made, below()] : [made];
  };

  const render = () => {
    const shown = groups.filter((g) => matches(g, filter.value) && (topic.list.value === "" || g.topic === topic.list.value) && (verdict.list.value === "" || g.verdict === verdict.list.value));
    // Equal ones stay in the order of the run.
    shown.sort((a, b) => (up ? 1 : -1) * orders[by](a, b));
    for (const { id, head } of heads) head.setAttribute("aria-sort", id === by ? (up ? "ascending" : "descending") : "none");
    body.replaceChildren(...shown.slice(0, limit).flatMap(row));
    count.textContent = shown.length === groups.length ? plural(groups.length, "row") : `${grouped(shown.length)} of ${plural(groups.length, "row")}`;
    more.hidden = shown.length <= limit;
    more.textContent = `Show more: ${grouped(shown.length - limit)} are left`;
  };
  render();

  return el(
    "div",
    {},
    el("div", { class: "tools" }, el("span", { class: "field" }, el("label", { for: filterId }, "Filter"), filter), topic.box, verdict.box, count),
    el(
      "table",
      { class: "verdicts" },
      el("caption", { class: "spoken" }, "Verdicts; the heads sort, a law's button shows what is behind its row"),
      el("thead", {}, el("tr", {}, ...heads.map((h) => h.head))),
      body,
    ),
    more,
  );
}
