// A function in JavaScript or WGSL: the form, the verdict, and an address for its case.
import type { ResultFile } from "../../../report/src/data";
import { button, el, select } from "../../../report/src/dom";
import { arithmeticWords } from "../../../../delivery/wasm/package/binary32.mjs";
import { type Arithmetic, judgeFunction, jsonOf } from "../program/client";
import type { Judged } from "../program/messages";
import { subjectName } from "../program/names";
import { reportOf } from "../program/report_of";
import { TaskBox } from "../program/task_box";
import { verdictPart } from "../program/verdict_part";
import { examples, type Language } from "./examples";
import { area, check, whole } from "./fields";
import { noGpu } from "./gpu";
import { hintFor } from "./hint";
import { hintPart } from "./hint_part";
import { addressOf, type Case } from "./link";
import { notAsked } from "./not_asked";
import { judgeWgsl } from "./wgsl";

const laws = ["index.equals_reference", "index.in_range", "index.bijective", "index.nested", "index.contiguous", "index.rounding"];
/** Of these levels every cell is asked for the triangle. */
const drawn = 6;

const about: Record<Language, string> = {
  JavaScript: "A function index(level, u, v) that returns a whole number, or a script for npm with index_f32. It runs in a worker, which has no network and is ended at the time limit.",
  WGSL: "fn index(level: u32, u: f32, v: f32) -> u32. It runs on your graphics device by WebGPU; the laws' points are asked in batches.",
};

const onDevice = "as your graphics device computes it";

type Asked = Omit<Case, "law" | "level" | "case">;

/** The verdict, with what it is about and what it is not; `from`: the case that a link brought. */
function verdict(judged: Judged, asked: Asked, from: Case | null): Node[] {
  const result = jsonOf<ResultFile>(judged, "/tmp/result.json");
  const arithmetic = result.runs_on?.[0]?.about.arithmetic ?? "";
  const link = el("a", {});
  const linkLine = el("p", { class: "note" }, link, ". It holds your function; opened in this page, it runs nothing before you press Judge it.");
  linkLine.hidden = true;
  const parts = verdictPart(reportOf("your function", result, subjectName, judged.cells), {
    ...(from ? { at: from } : {}),
    shown: ({ law }, counter) => {
      linkLine.hidden = counter === undefined;
      if (!counter) return;
      const of = { ...asked, law, level: counter.shownAt, case: counter.counterexample.case };
      link.textContent = `Link to this case: ${law}, level ${of.level}, ${of.case}`;
      void addressOf(of).then((address) => link.setAttribute("href", address));
    },
  });
  return [el("p", { class: "about-verdict" }, `Your function, ${arithmetic}. Not asked: ${notAsked(asked.levels, asked.floats).join("; ")}.`), linkLine, ...parts];
}

export interface FunctionPart {
  root: HTMLElement;
  /** Puts a text into the form, in the language that it is written in. */
  put: (code: string) => void;
  open: (given: Case) => void;
}

export function functionPart(): FunctionPart {
  const code = area("The function", 16);
  code.text.wrap = "off";
  const words = el("p", { class: "note" });
  const gpuWords = el("p", { class: "note", role: "status" });
  const hint = hintPart();
  const highest = whole("Levels 0 to", 5, 0, 9);
  const seconds = whole("Time limit", 60, 1, 600, " s");
  const numbers = select("Numbers", [
    { value: "binary32", words: "binary32: each operation rounded, as in a shader" },
    { value: "binary64", words: "binary64, as JavaScript computes" },
  ], () => undefined);
  const floats = check("also a million floats near ties a level");
  const box = new TaskBox();
  let from: Case | null = null;

  const chosen = (): Language => language.list.value as Language;
  const mine = (): typeof examples => examples.filter((e) => e.language === chosen());
  const example = select("Example", [], (k) => put(mine()[Number(k)]!.code));
  const language = select("Language", (["JavaScript", "WGSL"] as const).map((value) => ({ value, words: value })), () => become(chosen(), mine()[0]!.code));
  const become = (now: Language, text: string): void => {
    language.list.value = now;
    example.list.replaceChildren(...mine().map((e, k) => el("option", { value: String(k) }, e.words)));
    code.text.value = text;
    from = null;
    hint.show(null);
    words.textContent = about[now];
    numbers.box.hidden = now === "WGSL";
    floats.set(now === "JavaScript"); // millions of points in batches are more than a page's memory holds
    gpuWords.textContent = "";
    if (now === "WGSL")
      void noGpu().then((why) => {
        if (why !== null && chosen() === "WGSL")
          gpuWords.textContent = `${why}. Run the function where you can, and give its answers below, under "A table of answers".`;
      });
  };
  const read = (): void => {
    from = null;
    const found = hintFor(code.text.value, chosen());
    if (found?.language && found.language !== chosen()) become(found.language, code.text.value);
    hint.show(found);
  };
  const put = (text: string): void => {
    code.text.value = text;
    read();
  };
  code.text.addEventListener("input", read);
  const judge = (): void => {
    const found = hintFor(code.text.value, chosen());
    if (found && found.language !== chosen()) {
      void box.run("", { done: Promise.reject(new Error("The page did not run this text: the hint below the text says why.")), stop: () => undefined }, () => []);
      return;
    }
    const levels = highest.get();
    const asked: Asked = { language: chosen(), code: code.text.value, numbers: numbers.list.value as Arithmetic, levels, floats: floats.get() };
    const args = ["prove", ...laws, "--subject", subjectName, "--levels", `0..${levels}`, "--no-mutants", "--threads", "1", "--quiet", ...(asked.floats ? [] : ["--no-companions"])];
    const wgsl = asked.language === "WGSL";
    const ask = { args, highest: Math.min(levels, drawn), arithmetic: wgsl ? onDevice : arithmeticWords[asked.numbers] };
    const limit = seconds.get();
    const task = wgsl ? judgeWgsl(ask, asked.code, limit) : judgeFunction(ask, asked.code, asked.numbers, limit);
    const linked = from;
    void box.run("Judging your function...", task, (judged) => verdict(judged, asked, linked));
  };
  const open = (given: Case): void => {
    become(given.language, given.code);
    numbers.list.value = given.numbers;
    highest.set(given.levels);
    floats.set(given.floats);
    hint.show({ words: `A link brought this function and a case on which it was wrong: ${given.law}, level ${given.level}, ${given.case}. Press Judge it to run the function here` });
    from = given;
  };
  become("JavaScript", mine()[0]!.code);
  const root = el(
    "div",
    {},
    el("div", { class: "tools" }, language.box, example.box, numbers.box),
    words,
    gpuWords,
    code.box,
    hint.root,
    el("div", { class: "tools" }, highest.box, seconds.box, floats.box, button("Judge it", judge, { class: "main" })),
    box.root,
  );
  return { root, put, open };
}
