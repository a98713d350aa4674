// The program for the page: compiled once, each run in a worker of its own, which can be stopped.
import workerText from "worker-text";

import { scopeNames } from "../../../../delivery/wasm/package/binary32.mjs";
import { inBinary32 } from "../../../../delivery/wasm/package/rewrite.mjs";
import type { Ask, Ended, Judge, Judged, Reply, Run } from "./messages";
import { withoutExports } from "./npm_script";

/** The bytes that the page carries: gzip, in base64. */
async function bytes(): Promise<ArrayBuffer> {
  const text = document.getElementById("program")!.textContent!.trim();
  const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

export interface Ready {
  module: WebAssembly.Module;
  size: number;
  seconds: number;
}
let starting: Promise<Ready> | undefined;

/** Rejects where the browser has no WebAssembly, or not its exceptions. */
export function ready(): Promise<Ready> {
  starting ??= (async () => {
    const start = performance.now();
    const program = await bytes();
    const module = await WebAssembly.compile(program);
    return { module, size: program.byteLength, seconds: (performance.now() - start) / 1000 };
  })();
  return starting;
}

export interface Task<Result> {
  done: Promise<Result>;
  /** Ends the worker; `done` rejects with these words. */
  stop: (why: string) => void;
}

/** The numbers that a function in JavaScript computes in. */
export type Arithmetic = "binary32" | "binary64";

const linesBefore = workerText.split("\n").length + 1;

/** Behind the worker's text: the function under test, in a scope of its own, and the number of lines before it. Throws, with
 * the line, what cannot be rounded. */
function withFunction(code: string, arithmetic: Arithmetic): string {
  const script = withoutExports(code);
  const [names, text] = arithmetic === "binary32" ? [scopeNames.join(", "), inBinary32(script, "script")] : ["", script];
  const found = `[typeof index === "undefined" ? undefined : index, typeof index_f32 === "undefined" ? undefined : index_f32]`;
  return `${workerText}\n;self.linesBefore = ${linesBefore}; self.underTest = ((${names}) => (() => { "use strict";\n${text}\n;return ${found}; })())(...self.binary32Scope);\n`;
}

function start<Result>(ask: Run | Judge, text: () => string, seconds: number): Task<Result> {
  let stop: Task<Result>["stop"] = () => undefined;
  const done = (async () => {
    const { module } = await ready();
    const address = URL.createObjectURL(new Blob([text()], { type: "text/javascript" }));
    const worker = new Worker(address);
    let timer = 0;
    try {
      return await new Promise<Result>((resolve, reject) => {
        stop = (why) => reject(new Error(why));
        timer = window.setTimeout(
          () => reject(new Error(`stopped after ${seconds} s, which is the time limit${ask.kind === "judge" ? ": does the function end for every level and point?" : ""}`)),
          1000 * seconds,
        );
        worker.onmessage = ({ data }: MessageEvent<Reply>) => ("failed" in data ? reject(new Error(data.failed)) : resolve(data.ended as Result));
        worker.onerror = (event) => {
          event.preventDefault();
          const line = event.lineno > linesBefore ? `line ${event.lineno - linesBefore}: ` : "";
          reject(new Error(`${line}${(event.message || "the worker could not start").replace(/^Uncaught /, "")}`));
        };
        worker.postMessage({ ...ask, module } satisfies Ask);
      });
    } finally {
      clearTimeout(timer);
      worker.terminate();
      URL.revokeObjectURL(address);
    }
  })();
  return { done, stop: (why) => stop(why) };
}

export const runProgram = (ask: Omit<Run, "kind">, seconds: number): Task<Ended> => start({ kind: "run", ...ask }, () => workerText, seconds);

/** `code` is JavaScript that names a function `index`; without it the table answers. */
export const judgeFunction = (ask: Omit<Judge, "kind">, code: string | null, arithmetic: Arithmetic, seconds: number): Task<Judged> =>
  start({ kind: "judge", ...ask }, () => (code === null ? workerText : withFunction(code, arithmetic)), seconds);

export function jsonOf<T>(ended: Ended, file: string): T {
  const found = ended.files[file];
  if (found === undefined) throw new Error(ended.stderr.trim() || `mmverify ended with exit code ${ended.code}`);
  return JSON.parse(new TextDecoder().decode(found)) as T;
}
