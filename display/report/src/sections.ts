// The sections of a report, and what stands above and below them.
import { attributeSections } from "./attributes";
import { costCharts } from "./cost";
import { type AnyBench, benches, type Report, runs, type Tool, type Verdict } from "./data";
import { el, plainTable } from "./dom";
import { footprintCharts } from "./footprint";
import { grouped, plural, seconds } from "./format";
import { planSections } from "./plan";
import { differingPixels, raySections } from "./rays";
import { pathVerdict } from "./render_path";
import { savingsCharts } from "./savings";
import { verdictMark, verdictTable } from "./table";
import { tradeCharts } from "./trade";
import { triangleSection } from "./triangle";
import { groups, verdicts } from "./verdicts";
import { viewSections } from "./views";

interface Section {
  id: string;
  title: string;
  /** What would have to be given for it. */
  needs: string;
  /** Side by side where there is room. */
  charts?: boolean;
  make: (report: Report) => (HTMLElement | null)[];
}

const sections: Section[] = [
  {
    id: "verdicts",
    title: "Verdicts",
    needs: "a result of mmverify prove or mmverify scene (--json)",
    make: (report) => {
      const all = groups(runs(report));
      return all.length > 0 ? [verdictTable(all), ...mutants(report)] : [];
    },
  },
  {
    id: "refuted",
    title: "Refuted",
    needs: "",
    make: (report) => {
      const refuted = groups(runs(report)).filter((g) => g.verdict === "refuted");
      return refuted.length > 0 ? [triangleSection(report, refuted)] : [];
    },
  },
  { id: "trade", charts: true, title: "Error against run time", needs: "a result of mmverify bench --json", make: tradeCharts },
  { id: "cost", charts: true, title: "Cost against level", needs: "a result of mmverify bench --json, or of laws on three levels or more", make: costCharts },
  { id: "footprint", title: "Footprint against level", needs: "a result of mmverify scene --sizes A..B --json", make: footprintCharts },
  { id: "savings", charts: true, title: "VQ savings", needs: "a result of mmverify bench vq --json", make: savingsCharts },
  { id: "attributes", title: "Attribute micromaps", needs: "a result of mmverify attributes FILE --json", make: attributeSections },
  { id: "rays", title: "Rays", needs: "a result of mmverify render --level A..B --heat FILE.png --json, or of render --cameras N --json", make: raySections },
  { id: "views", title: "Views by attribute micromaps", needs: "a result of mmverify views --level A..B --pictures FOLDER --json", make: viewSections },
  { id: "plan", title: "The scene's plan", needs: "a result of mmverify scene --json", make: planSections },
];

function mutants(report: Report): HTMLElement[] {
  const all = runs(report).flatMap((run) => run.content.mutants ?? []);
  if (all.length === 0) return [];
  const alive = all.filter((m) => !m.killed);
  return [
    el("p", {}, `Mutants: ${grouped(all.length - alive.length)} of ${grouped(all.length)} wrong subjects were caught by their laws.`),
    ...(alive.length > 0 ? [plainTable("Mutants that survived", ["Law", "Mutant"], alive.map((m) => [m.law, m.mutant]))] : []),
  ];
}

/** How many of each verdict, in words and signs: of laws, and of the law along a scene's path of cameras. */
function summary(report: Report): HTMLElement {
  const found: Verdict[] = [...runs(report).flatMap((run) => run.content.results.map((r) => r.verdict)), ...benches(report, "render_path").map((b) => pathVerdict(b.content))];
  const items = verdicts.flatMap((v) => {
    const n = found.filter((verdict) => verdict === v).length;
    return n > 0 ? [el("li", {}, el("strong", {}, grouped(n)), " ", verdictMark(v))] : [];
  });
  const wrong = benches(report, "render").reduce((sum, b) => sum + differingPixels(b.content), 0);
  const pixels = wrong > 0 ? [el("li", {}, el("a", { class: "verdict refuted", href: "#rays" }, el("span", { class: "sign", "aria-hidden": "true" }, "✗"), `${plural(wrong, "rendered pixel")} ${wrong === 1 ? "differs" : "differ"} from the texture's`))] : [];
  if (items.length + pixels.length === 0) return el("p", { class: "summary" }, "No verdicts: figures only.");
  return el("ul", { class: "summary", "aria-label": "Results by verdict" }, found.length > 0 ? el("li", {}, `${plural(found.length, "result")}:`) : null, ...items, ...pixels);
}

function toolLine(tool: Tool): string {
  const threads = "threads" in tool && plural(tool.threads, "thread"), seed = "seed" in tool && `seed ${tool.seed}`;
  const parts = [`mmverify ${tool.version}`, tool.compiler, tool.flags, tool.cpu, threads, seed, `specification ${tool.spec_hash.slice(0, 12)}`];
  return parts.filter((p) => p).join(", ");
}

/** The command that makes a bench's figures. */
const commands: Partial<Record<AnyBench["topic"], string>> = {
  scene_attributes: "attributes",
  render: "render",
  render_path: "render --cameras",
  views: "views",
};

function sources(report: Report): HTMLElement {
  const rows = report.files.map(({ name, content }) => {
    if (content.schema === "mmverify.bench/1") return [name, commands[content.topic] ?? `bench ${content.topic}`, toolLine(content.tool)];
    const time = content.results.reduce((sum, r) => sum + r.seconds, 0);
    const shard = content.shard ? `, shard ${content.shard.number} of ${content.shard.of}: a part of a run` : "";
    return [name, `${content.scene ? "scene" : "prove"}: ${plural(content.results.length, "result")}, ${seconds(time)}${shard}`, toolLine(content.tool)];
  });
  return el("details", {}, el("summary", {}, `Made from ${plural(new Set(report.files.map((f) => f.name)).size, "file")} by mmverify ${report.tool.version}`), plainTable("Files", ["File", "Holds", "Made by"], rows));
}

/** A section that cannot be drawn says so and leaves the others alone. */
function made(section: Section, report: Report): (HTMLElement | null)[] {
  try {
    return section.make(report);
  } catch (error) {
    console.error(error);
    return [el("p", { class: "wrong", role: "alert" }, `This section could not be drawn: ${String(error)}`)];
  }
}

/** A report, part by part: the page of mmverify report and display/page put these together. */
export interface Parts {
  /** Verdicts counted, and the files that they are from. */
  top: HTMLElement[];
  nav: HTMLElement;
  sections: HTMLElement[];
  /** What was not given; null where all was. */
  missing: HTMLElement | null;
}

/** `heading`: the rank of the sections' headings. */
export function reportParts(report: Report, heading: "h2" | "h3"): Parts {
  const present = sections.map((section) => ({ section, parts: made(section, report) })).filter(({ parts }) => parts.length > 0);
  const missing = sections.filter((s) => s.needs !== "" && !present.some((p) => p.section === s));
  return {
    top: [summary(report), sources(report)],
    nav: el("nav", { "aria-label": "Sections" }, ...present.map(({ section: s }) => el("a", { href: `#${s.id}` }, s.title))),
    sections: present.map(({ section: s, parts }) => el("section", { id: s.id, "aria-labelledby": `${s.id}-title` }, el(heading, { id: `${s.id}-title` }, s.title), s.charts ? el("div", { class: "charts" }, ...parts) : el("div", {}, ...parts))),
    missing: missing.length > 0 ? el("p", {}, "Not given: ", missing.map((s) => `${s.title.toLowerCase().replace("vq", "VQ")} (${s.needs})`).join("; "), ".") : null,
  };
}
