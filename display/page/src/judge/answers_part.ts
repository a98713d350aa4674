// A table of answers, for a function that runs elsewhere: its points, a place for its answers, the verdict.
import type { ResultFile } from "../../../report/src/data";
import { button, el } from "../../../report/src/dom";
import { plural } from "../../../report/src/format";
import { jsonOf, runProgram } from "../program/client";
import { reportOf } from "../program/report_of";
import { TaskBox } from "../program/task_box";
import { verdictPart } from "../program/verdict_part";
import { wrongAnswers } from "./answers_text";
import { area, whole } from "./fields";

const json = "/tmp/result.json";
const seconds = 60;

export function answersPart(): HTMLElement {
  const level = whole("Level", 2, 0, 8);
  const points = area("Points, a line each: number, u, v. Floats in hexadecimal, which C and Python read exactly", 6);
  points.text.readOnly = true;
  const answers = area("Answers, a line each: number, index", 6);
  const box = new TaskBox();
  let asked: { level: number; text: string } | undefined;
  const make = (): void => {
    const n = level.get();
    void box.run("Writing the points...", runProgram({ args: ["gen", "index", "--level", String(n)] }, seconds), ({ stdout }) => {
      asked = { level: n, text: stdout };
      points.text.value = stdout;
      return [el("p", {}, `${plural(stdout.split("\n").length - 2, "point")}: one inside each micro-triangle, one on each edge and each corner. Paste your answers below them.`)];
    });
  };
  const judge = (): void => {
    if (!asked) {
      points.text.value = "";
      make();
      return;
    }
    const { level: n, text } = asked;
    const given = answers.text.value;
    void box.run("Judging the answers...", runProgram({ args: ["check", "index", "--level", String(n), "--quiet", "--json", json], stdin: `${given.trim()}\n`, wanted: [json] }, seconds), (ended) => {
      const result = jsonOf<ResultFile>(ended, json);
      return [
        el("p", { class: "about-verdict" }, `The answers at the points above. Not asked: levels other than ${n}; floats beside the grid's points.`),
        ...verdictPart(reportOf("the answers", result, result.results[0]?.subject ?? "", [wrongAnswers(text, given, n)])),
      ];
    });
  };
  return el(
    "div",
    { id: "answers" },
    el("div", { class: "tools" }, level.box, button("Write the points", make)),
    points.box,
    answers.box,
    el("div", { class: "tools" }, button("Judge the answers", judge)),
    box.root,
  );
}
