// In the worker: one run of the program; where there is a function under test, it stands behind this text.
import { run } from "mmverify-package";

import { scope } from "../../../../delivery/wasm/package/binary32.mjs";
import type { Subject } from "../../../../delivery/wasm/package/index";
import { wrongCells } from "./cells";
import { withLine } from "./lines";
import { subjectFile, subjectName } from "./names";
import type { Ask, Ended, Judge, Judged, Reply, Run } from "./messages";
import { Table } from "./table";

type IndexFunction = (level: number, u: number, v: number) => unknown;
type IndexFloats = (level: number, u: Float32Array, v: Float32Array, index: Uint32Array) => unknown;
/** Set by the text behind this one: the functions `index` and `index_f32`, where it has them. */
declare const self: { binary32Scope: unknown[]; linesBefore: number; underTest?: [unknown, unknown]; onmessage: (event: MessageEvent<Ask>) => void; postMessage(reply: Reply): void };

// For a function whose text is rewritten.
self.binary32Scope = Object.values(scope);

/** The function as a call for one point; a script for npm answers arrays. */
function underTest(): IndexFunction {
  const [index, floats] = self.underTest ?? [];
  if (typeof index === "function") return index as IndexFunction;
  if (typeof floats !== "function") throw new Error("there is no function of the name index, and none of the name index_f32");
  const answer = new Uint32Array(1);
  return (level, u, v) => {
    (floats as IndexFloats)(level, Float32Array.of(u), Float32Array.of(v), answer);
    return answer[0];
  };
}

/** The function, with its answers looked at: what is no whole number is no index. An error names its line. */
function asked(index: IndexFunction): (level: number, u: number, v: number) => number {
  return (level, u, v) => {
    let answer: unknown;
    try {
      answer = index(level, u, v);
    } catch (error) {
      throw withLine(error, self.linesBefore);
    }
    if (typeof answer !== "number" || !Number.isInteger(answer))
      throw new Error(`index(${level}, ${u}, ${v}) returned ${String(answer)}, which is no whole number`);
    return answer >>> 0;
  };
}

async function program(ask: Run, module: WebAssembly.Module, subject?: Subject): Promise<Ended> {
  const { args, files, wanted, stdin } = ask;
  return run(args, { module, files: files ?? {}, wanted: [...(wanted ?? [])], ...(stdin === undefined ? {} : { stdin }), ...(subject ? { subject } : {}) });
}

async function judge(ask: Judge, module: WebAssembly.Module): Promise<Judged> {
  const table = ask.table && new Table(ask.table);
  const index = table ? table.answer.bind(table) : asked(underTest());
  const subject: Subject = {
    path: subjectName,
    name: subjectName,
    maxLevel: 12,
    arithmetic: ask.arithmetic,
    index_f32(level, u, v, answers) {
      for (let k = 0; k < answers.length; ++k) answers[k] = index(level, u[k]!, v[k]!);
    },
  };
  const json = "/tmp/result.json";
  const ended = await program({ kind: "run", args: [...ask.args, "--json", json], files: { [subjectFile]: new Uint8Array() }, wanted: [json] }, module, subject);
  const cells = [];
  try {
    for (let level = 0; level <= ask.highest; ++level) cells.push(wrongCells(level, (u, v) => index(level, u, v)));
  } catch {
    // The program has said which answer it threw at; the picture goes without the rest.
  }
  return { ...ended, cells, missing: table?.missing() ?? [] };
}

self.onmessage = async ({ data: { module, ...ask } }) => {
  try {
    self.postMessage({ ended: await (ask.kind === "judge" ? judge(ask, module) : program(ask, module)) });
  } catch (error) {
    self.postMessage({ failed: error instanceof Error ? error.message : String(error) });
  }
};
