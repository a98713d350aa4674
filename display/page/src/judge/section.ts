// An index function, pasted or dropped: JavaScript, WGSL, or a table of its answers.
import { el } from "../../../report/src/dom";
import { answersPart } from "./answers_part";
import { functionPart } from "./function_part";
import { caseOf } from "./link";

export interface JudgeSection {
  nodes: HTMLElement[];
  take: (files: File[]) => void;
}

export function judgeSection(): JudgeSection {
  const part = functionPart();
  const message = el("p", { class: "wrong", role: "alert" });
  message.hidden = true;
  const openAddress = async (): Promise<void> => {
    message.hidden = true;
    try {
      const given = await caseOf(location.hash);
      if (given) part.open(given);
      else return;
    } catch (error) {
      message.hidden = false;
      message.textContent = error instanceof Error ? error.message : String(error);
    }
    document.getElementById("function")!.scrollIntoView();
  };
  addEventListener("hashchange", () => void openAddress());
  void openAddress();
  return {
    nodes: [
      el("p", {}, "Which micro-triangle is a point in? Paste the function that you have for it, or drop its file. Six laws ask it on every corner, edge and inside of each level; what is refuted is shown on the triangle, with the simplest point that shows it."),
      message,
      part.root,
      el("details", { class: "other" }, el("summary", {}, "A table of answers, for a function in another language"), answersPart()),
    ],
    take: ([file]) => file && void file.text().then(part.put),
  };
}
