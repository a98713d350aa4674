// The page: its sections, and whether the program is there.
import { el } from "../../report/src/dom";
import { bytes, seconds } from "../../report/src/format";
import { themeButton } from "../../report/src/theme";
import { judgeSection } from "./judge/section";
import { lawsSection } from "./laws/section";
import { learnSection } from "./learn/section";
import { ready } from "./program/client";
import { sceneSection } from "./scene/section";

const sections: { id: string; title: string; make: () => HTMLElement[] }[] = [
  { id: "scene", title: "Your scene", make: sceneSection },
  { id: "function", title: "Your index function", make: judgeSection },
  { id: "laws", title: "Every law", make: lawsSection },
  { id: "curves", title: "The two curves, and ties", make: learnSection },
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
    el("p", {}, "An exact referee for opacity micromaps. A triangle of a leaf is cut into micro-triangles, each opaque, transparent or unknown; programs that make and read them must agree to the last tie."),
    state(),
    el("nav", { "aria-label": "Sections" }, ...sections.map(({ id, title }) => el("a", { href: `#${id}` }, title))),
  ),
  ...sections.map(({ id, title, make }) => el("section", { id, "aria-labelledby": `${id}-title` }, el("h2", { id: `${id}-title` }, title), ...make())),
);
