// An index function, pasted: JavaScript, WGSL, or a table of its answers.
import type { ResultFile } from "../../../report/src/data";
import { button, el, select } from "../../../report/src/dom";
import { arithmeticWords } from "../../../../delivery/wasm/package/binary32.mjs";
import { type Arithmetic, judgeFunction, jsonOf } from "../program/client";
import type { Judged } from "../program/messages";
import { subjectName } from "../program/names";
import { reportOf } from "../program/report_of";
import { TaskBox } from "../program/task_box";
import { verdictPart } from "../program/verdict_part";
import { answersPart } from "./answers_part";
import { examples, type Language } from "./examples";
import { area, check, whole } from "./fields";
import { noGpu } from "./gpu";
import { notAsked } from "./not_asked";
import { judgeWgsl } from "./wgsl";

const laws = ["index.equals_reference", "index.in_range", "index.bijective", "index.nested", "index.contiguous", "index.rounding"];
/** Of these levels every cell is asked for the triangle. */
const drawn = 6;

const about: Record<Language, string> = {
  JavaScript: "A function index(level, u, v) that returns a whole number. It runs in a worker, which has no network and is ended at the time limit.",
  WGSL: "fn index(level: u32, u: f32, v: f32) -> u32. It runs on your graphics device by WebGPU; the laws' points are asked in batches.",
};

const onDevice = "as your graphics device computes it";

/** The verdict, with what it is about and what it is not. */
function verdict(judged: Judged, left: string[]): Node[] {
  const result = jsonOf<ResultFile>(judged, "/tmp/result.json");
  const arithmetic = result.runs_on?.[0]?.about.arithmetic ?? "";
  return [
    el("p", { class: "about-verdict" }, `Your function, ${arithmetic}. Not asked: ${left.join("; ")}.`),
    ...verdictPart(reportOf("your function", result, subjectName, judged.cells)),
  ];
}

function functionPart(): HTMLElement {
  const code = area("The function", 16);
  code.text.wrap = "off";
  const words = el("p", { class: "note" });
  const gpuWords = el("p", { class: "note", role: "status" });
  const highest = whole("Levels 0 to", 5, 0, 9);
  const seconds = whole("Time limit", 60, 1, 600, " s");
  const numbers = select("Numbers", [
    { value: "binary32", words: "binary32: each operation rounded, as in a shader" },
    { value: "binary64", words: "binary64, as JavaScript computes" },
  ], () => undefined);
  const floats = check("also a million floats near ties a level");
  const box = new TaskBox();

  const mine = (): typeof examples => examples.filter((e) => e.language === language.list.value);
  const example = select("Example", [], (k) => (code.text.value = mine()[Number(k)]!.code));
  const language = select("Language", (["JavaScript", "WGSL"] as const).map((value) => ({ value, words: value })), () => change());
  const change = (): void => {
    const now = language.list.value as Language;
    example.list.replaceChildren(...mine().map((e, k) => el("option", { value: String(k) }, e.words)));
    code.text.value = mine()[0]!.code;
    words.textContent = about[now];
    numbers.box.hidden = now === "WGSL";
    floats.set(now === "JavaScript"); // millions of points in batches are more than a page's memory holds
    gpuWords.textContent = "";
    if (now === "WGSL")
      void noGpu().then((why) => {
        if (why !== null && language.list.value === "WGSL")
          gpuWords.textContent = `${why}. Run the function where you can, and give its answers below, under "A table of answers".`;
      });
  };
  const judge = (): void => {
    const to = highest.get();
    const args = ["prove", ...laws, "--subject", subjectName, "--levels", `0..${to}`, "--no-mutants", "--threads", "1", "--quiet", ...(floats.get() ? [] : ["--no-companions"])];
    const wgsl = language.list.value === "WGSL";
    const arithmetic = numbers.list.value as Arithmetic;
    const ask = { args, highest: Math.min(to, drawn), arithmetic: wgsl ? onDevice : arithmeticWords[arithmetic] };
    const limit = seconds.get();
    const left = notAsked(to, floats.get());
    const task = wgsl ? judgeWgsl(ask, code.text.value, limit) : judgeFunction(ask, code.text.value, arithmetic, limit);
    void box.run("Judging your function...", task, (judged) => verdict(judged, left));
  };
  change();
  return el(
    "div",
    {},
    el("div", { class: "tools" }, language.box, example.box, numbers.box),
    words,
    gpuWords,
    code.box,
    el("div", { class: "tools" }, highest.box, seconds.box, floats.box, button("Judge it", judge, { class: "main" })),
    box.root,
  );
}

export function judgeSection(): HTMLElement[] {
  return [
    el("p", {}, "Which micro-triangle is a point in? Paste the function that you have for it. Six laws ask it on every corner, edge and inside of each level; what is refuted is shown on the triangle, with the simplest point that shows it."),
    functionPart(),
    el("details", { class: "other" }, el("summary", {}, "A table of answers, for a function in another language"), answersPart()),
  ];
}
