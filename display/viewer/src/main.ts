// The viewer: drop a .glb, see its maps over its textures, and what mmverify finds.
import { findings, type Validated } from "../../page/src/scene/findings";
import { jsonOf, runProgram } from "../../page/src/program/client";
import { button, el, fresh } from "../../report/src/dom";
import { themeButton } from "../../report/src/theme";
import { load } from "./load";
import { panel } from "./panel";
import { Stage } from "./stage";

const limit = 300;
const json = "/tmp/result.json", baked = "/tmp/baked.glb";
const picture = el("div", { class: "stage" });
const shown = el("div", {}), found = el("div", {});
const status = el("p", { role: "status", class: "status" }, "Drop a .glb anywhere on this page. Nothing leaves this machine.");
let stage: Stage | undefined;
let turn = 0;

const alert = (error: unknown): HTMLElement => el("p", { class: "wrong", role: "alert" }, error instanceof Error ? error.message : String(error));

/** Shows `words` until `task` has ended; what a later file made obsolete is dropped. */
async function during<Result>(words: string, task: Promise<Result>, place: HTMLElement, show: (result: Result) => (Node | string)[]): Promise<void> {
  const mine = turn;
  place.replaceChildren(el("p", { class: "note" }, words));
  try {
    const result = await task;
    if (mine === turn) place.replaceChildren(...show(result));
  } catch (error) {
    if (mine === turn) place.replaceChildren(alert(error));
  }
}

async function bake(name: string | null, bytes: Uint8Array | null): Promise<void> {
  const mine = ++turn;
  status.textContent = `Baking ${name ?? "the suite's own scene"}...`;
  try {
    const ended = await runProgram({ args: ["scene", ...(name ? [`/tmp/${name}`] : []), "-o", baked, "--no-laws", "--quiet"], files: name && bytes ? { [`/tmp/${name}`]: bytes } : {}, wanted: [baked] }, limit).done;
    if (mine !== turn) return;
    const file = ended.files[baked];
    if (!file) throw new Error(ended.stderr.trim() || `mmverify scene ended with exit code ${ended.code}`);
    await take(name ? `${name}, baked here` : "garden.glb", file, "garden.glb");
  } catch (error) {
    if (mine === turn) status.replaceChildren(alert(error));
  }
}

async function take(title: string, bytes: Uint8Array, name: string): Promise<void> {
  ++turn;
  status.textContent = title;
  stage?.dispose();
  stage = undefined;
  picture.replaceChildren();
  shown.replaceChildren();
  const file = `/tmp/${name}`;
  const validated = runProgram({ args: ["validate", file, "--json", json], files: { [file]: bytes }, wanted: [json] }, limit).done;
  const judged = during("Looking for faults...", validated, found, (ended) => [findings(jsonOf<Validated>(ended, json))]);
  // A copy of its own: three.js takes the buffer as it is.
  await during("Reading...", load(bytes.slice().buffer), shown, (loaded) => {
    if (loaded.mapped.length === 0)
      return [el("p", {}, "This file has no opacity micromaps."), button("Bake them here", () => void bake(name, bytes))];
    stage = new Stage(loaded);
    picture.replaceChildren(stage.canvas);
    return [panel(stage, loaded.mapped)];
  });
  await judged;
}

async function takeFiles(files: File[]): Promise<void> {
  const file = files.find((one) => /\.glb$/i.test(one.name)) ?? files[0];
  if (file) await take(file.name, new Uint8Array(await file.arrayBuffer()), file.name);
}

const id = fresh("file"), input = el("input", { id, type: "file" });
input.accept = ".glb";
input.addEventListener("change", () => void takeFiles([...(input.files ?? [])]));
document.addEventListener("dragover", (event) => event.preventDefault());
document.addEventListener("drop", (event) => {
  event.preventDefault();
  void takeFiles([...(event.dataTransfer?.files ?? [])]);
});
document.getElementById("page")!.replaceChildren(
  picture,
  el(
    "aside",
    {},
    el("div", { class: "top" }, el("h1", {}, "Opacity micromaps of a file"), themeButton()),
    el("div", { class: "tools" }, el("label", { for: id }, "A .glb"), input, button("The suite's own scene", () => void bake(null, null))),
    status,
    shown,
    found,
  ),
);
