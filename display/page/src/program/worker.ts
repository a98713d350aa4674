// In the worker: one run of the program; where there is a function under test, it stands behind this text.
import { run } from "mmverify-package";

import { scope } from "../../../../delivery/wasm/package/binary32.mjs";
import type { Subject } from "../../../../delivery/wasm/package/index";
import { wrongCells } from "./cells";
import { subjectFile, subjectName } from "./names";
import type { Ask, Ended, Judge, Judged, Reply, Run } from "./messages";
import { Table } from "./table";

type IndexFunction = (level: number, u: number, v: number) => number;
declare const self: { binary32Scope: unknown[]; indexFunction?: unknown; onmessage: (event: MessageEvent<Ask>) => void; postMessage(reply: Reply): void };

// For a function whose text is rewritten.
self.binary32Scope = Object.values(scope);

/** The function, with its answers looked at: what is no whole number is no index. */
function asked(index: IndexFunction): IndexFunction {
  return (level, u, v) => {
    const answer: unknown = index(level, u, v);
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
  if (!table && typeof self.indexFunction !== "function") throw new Error("there is no function of the name index");
  const index = table ? table.answer.bind(table) : asked(self.indexFunction as IndexFunction);
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
