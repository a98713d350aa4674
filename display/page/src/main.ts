// The page: its sections, and whether the program is there.
import { el } from "../../report/src/dom";
import { bytes, seconds } from "../../report/src/format";
import { themeButton } from "../../report/src/theme";
import { dropAnywhere } from "./files/drop";
import { frontPicture } from "./front/picture";
import { judgeSection } from "./judge/section";
import { lawsSection } from "./laws/section";
import { learnSection } from "./learn/section";
import { ready } from "./program/client";
import { resultSection } from "./result/section";
import { sceneSection } from "./scene/section";

const scene = sceneSection();
const judge = judgeSection();
const result = resultSection();
const sections: { id: string; title: string; nodes: HTMLElement[] }[] = [
  { id: "scene", title: "Your scene", nodes: scene.nodes },
  { id: "function", title: "Your index function", nodes: judge.nodes },
  { id: "result", title: "Your result file", nodes: result.nodes },
  { id: "laws", title: "Every law", nodes: lawsSection() },
  { id: "curves", title: "The two curves, and ties", nodes: learnSection() },
];

function state(): HTMLElement {
  const words = el("p", { class: "note", role: "status", id: "state" }, "Starting the program...");
  ready().then(
    ({ size, seconds: s }) => (words.textContent = `The program is ready: ${bytes(size)} of WebAssembly, unpacked and compiled in ${seconds(s)}. It is in this file; nothing is asked of a network.`),
    (error: unknown) => {
      words.className = "wrong";
      words.textContent = `The program cannot run in this browser: ${error instanceof Error ? error.message : String(error)}. It needs WebAssembly with exceptions: Chrome 95, Firefox 100, Safari 15.2 or later.`;
    },
  );
  return words;
}

const top = themeButton();
document.getElementById("page")!.replaceChildren(
  el(
    "header",
    {},
    el("div", { class: "top" }, el("h1", {}, "mmverify in a browser"), top),
    el(
      "div",
      { class: "intro" },
      el(
        "div",
        {},
        el("p", {}, "An exact referee for opacity micromaps. A triangle of a leaf is cut into micro-triangles, each opaque, transparent or unknown; programs that make and read them must agree to the last tie."),
        el("p", {}, "Paste a function, or drop a file anywhere on this page: a scene, an index function, or a result of the native program."),
        state(),
        el("nav", { "aria-label": "Sections" }, ...sections.map(({ id, title }) => el("a", { href: `#${id}` }, title))),
        dropAnywhere({ scene: scene.take, function: judge.take, result: result.take }),
      ),
      frontPicture(),
    ),
  ),
  ...sections.map(({ id, title, nodes }) => el("section", { id, "aria-labelledby": `${id}-title` }, el("h2", { id: `${id}-title` }, title), ...nodes)),
);
