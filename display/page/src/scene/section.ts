// A scene: drop it and get its findings, its plan, what micromaps save, and the micromaps themselves.
import type { ResultFile } from "../../../report/src/data";
import { button, el, fresh } from "../../../report/src/dom";
import { footprintCharts } from "../../../report/src/footprint";
import { bytes } from "../../../report/src/format";
import { planSections } from "../../../report/src/plan";
import { savingsCharts } from "../../../report/src/savings";
import { jsonOf, runProgram, type Task } from "../program/client";
import type { Ended } from "../program/messages";
import { reportOf } from "../program/report_of";
import { TaskBox } from "../program/task_box";
import { verdictPart } from "../program/verdict_part";
import { findings, type Validated } from "./findings";
import { mapsPart } from "./maps_part";
import { readMaps } from "./read_maps";

const limit = 300;
const json = "/tmp/result.json";
const baked = "/tmp/baked.glb";

interface Given {
  name: string;
  files: Record<string, Uint8Array>;
}
interface Judged {
  validated: Validated | null;
  scene: Ended;
}

/** `validate`, then `scene`: two runs, one task. */
function judgeScene(given: Given | null): Task<Judged> {
  let now: Task<Ended> | undefined;
  let stopped: string | undefined;
  const next = (args: string[], wanted: string[]): Promise<Ended> => {
    if (stopped !== undefined) throw new Error(stopped);
    now = runProgram({ args: [...args, "--json", json], files: given?.files ?? {}, wanted: [json, ...wanted] }, limit);
    return now.done;
  };
  const done = (async () => {
    const validated = given && jsonOf<Validated>(await next(["validate", `/tmp/${given.name}`], []), json);
    const scene = await next(["scene", ...(given ? [`/tmp/${given.name}`] : []), "-o", baked, "--sizes", "1..4", "--samples", "200", "--quiet"], [baked]);
    return { validated, scene };
  })();
  return {
    done,
    stop: (why) => {
      stopped = why;
      now?.stop(why);
    },
  };
}

function saveLink(file: Uint8Array<ArrayBuffer>): HTMLElement {
  const link = el("a", { href: URL.createObjectURL(new Blob([file], { type: "model/gltf-binary" })) }, `Save the scene with its micromaps (${bytes(file.length)})`);
  link.download = "micromaps.glb";
  return el("p", {}, link);
}

function part(title: string, parts: (Node | null)[]): HTMLElement[] {
  const all = parts.filter((p): p is Node => p !== null);
  return all.length > 0 ? [el("h3", {}, title), el("div", {}, ...all)] : [];
}

function shown(given: Given | null, { validated, scene }: Judged): Node[] {
  const nodes: Node[] = validated ? [findings(validated)] : [];
  if (scene.files[json] === undefined) {
    nodes.push(el("p", { class: "wrong", role: "alert" }, scene.stderr.trim() || `mmverify scene ended with exit code ${scene.code}`));
    return nodes;
  }
  const report = reportOf(given?.name ?? "the suite's own scene", jsonOf<ResultFile>(scene, json));
  nodes.push(...part("Plan", planSections(report)), ...part("Footprint", footprintCharts(report)));
  const savings = savingsCharts(report);
  nodes.push(...part("Savings of square maps", savings));
  const own = given ? readMaps(given.files[`/tmp/${given.name}`]!) : [];
  if (own.length > 0) nodes.push(mapsPart(own, "The file's own micromaps"));
  const file = scene.files[baked] as Uint8Array<ArrayBuffer> | undefined;
  if (file) {
    const maps = readMaps(file);
    if (maps.length > 0) nodes.push(mapsPart(maps, "The micromaps that were baked here"));
    nodes.push(saveLink(file));
  }
  nodes.push(el("h3", {}, "Laws, on this scene"), ...verdictPart(report));
  return nodes;
}

/** The scene among the files that were dropped, and those beside it. */
async function given(all: File[]): Promise<Given | null> {
  const main = all.find((f) => /\.(glb|gltf)$/i.test(f.name)) ?? all[0];
  if (!main) return null;
  const files: Record<string, Uint8Array> = {};
  for (const file of all) files[`/tmp/${file.name}`] = new Uint8Array(await file.arrayBuffer());
  return { name: main.name, files };
}

export interface SceneSection {
  nodes: HTMLElement[];
  take: (files: File[]) => void;
}

export function sceneSection(): SceneSection {
  const box = new TaskBox();
  const judge = (from: Given | null): void =>
    void box.run(`Judging ${from?.name ?? "the suite's own scene"}...`, judgeScene(from), (result) => shown(from, result));
  const id = fresh("scene");
  const input = el("input", { id, type: "file" });
  input.accept = ".glb,.gltf,.bin,.png,.jpg,.jpeg,.webp,.ktx2,.dds";
  input.multiple = true;
  const take = async (files: File[]): Promise<void> => {
    const from = await given(files);
    if (from) judge(from);
  };
  input.addEventListener("change", () => input.files && void take([...input.files]));
  const drop = el(
    "div",
    { class: "drop" },
    el("p", {}, el("label", { for: id }, "Drop a .glb anywhere on this page, or choose one "), "(a .gltf together with its files will do):"),
    el("div", { class: "tools" }, input, button("Use the suite's own scene", () => judge(null))),
  );
  return {
    nodes: [
      el("p", {}, `Nothing leaves this machine. The page looks for faults in the file's micromaps, plans which triangles to bake, bakes them, and measures what they take and save. Time limit: ${limit} s.`),
      drop,
      box.root,
    ],
    take: (files) => void take(files),
  };
}
