#!/usr/bin/env node
// mmverify on the command line of any system with Node.js: the arguments and exit codes of the native program.
import { existsSync, mkdtempSync, readdirSync, readFileSync, readSync, rmSync, statSync, writeSync } from "node:fs";
import os from "node:os";
import { isAbsolute, join, parse, resolve, sep } from "node:path";
import { isMainThread, parentPort, Worker, workerData } from "node:worker_threads";

import { compile, run } from "../index.mjs";
import { loadScript } from "../script.mjs";

const usage = 2;
const environment = 4;
let ended = false;
const oneScript = "--subject: one script at a time";

/** The program's files are the machine's: what lies in the root folder is mounted under its own name. */
function mountMachine({ FS, NODEFS }) {
  const mount = (from, to) => {
    try {
      FS.mkdirTree(to);
      FS.mount(NODEFS, { root: from }, to);
    } catch {
      // A folder that nobody may read; whoever names a file in it is told that it is not there.
    }
  };
  if (sep === "\\") {
    mount(parse(process.cwd()).root, "/machine");
    FS.chdir(inProgram(process.cwd()));
    return;
  }
  const special = new Set(["dev", "proc", "sys"]);
  for (const name of readdirSync("/")) {
    if (special.has(name)) continue;
    try {
      if (statSync(`/${name}`).isDirectory()) mount(`/${name}`, `/${name}`);
    } catch {
      // A link to nowhere.
    }
  }
  FS.chdir(process.cwd());
}

/** C:\\a\\b as the program names it.  Elsewhere names are the same. */
function inProgram(path) {
  return sep === "\\" ? `/machine/${path.slice(parse(path).root.length).replaceAll("\\", "/")}` : path;
}
const argument = (text) => (sep === "\\" && isAbsolute(text) ? inProgram(resolve(text)) : text);

function writeAll(file, bytes) {
  for (let at = 0; at < bytes.length; ) {
    try {
      at += writeSync(file, bytes, at);
    } catch (error) {
      if (error.code === "EPIPE") {
        ended = true; // nobody reads any more
        process.exit(0);
      }
      if (error.code !== "EAGAIN") throw error;
    }
  }
}

function stdinBytes() {
  const piece = new Uint8Array(1 << 16);
  let [size, at] = [0, 0];
  return () => {
    while (at === size) {
      try {
        size = readSync(0, piece, 0, piece.length, null);
      } catch (error) {
        if (error.code === "EAGAIN") continue;
        if (error.code !== "EOF") throw error;
        size = 0;
      }
      at = 0;
      if (size === 0) return null;
    }
    return piece[at++];
  };
}

/** The script that --subject names, if it is one: its functions, under the name that the program asks for. */
async function subjectOf(args) {
  const names = args.flatMap((text, k) =>
    text === "--subject" ? [args[k + 1] ?? ""] : text.startsWith("--subject=") ? [text.slice(10)] : []);
  const scripts = names.filter((name) => /\.[cm]?js$/.test(name.replace(/:[a-z0-9]+$/, "")));
  if (scripts.length === 0) return undefined;
  const path = scripts[0].replace(/:[a-z0-9]+$/, "");
  if (scripts.some((name) => name.replace(/:[a-z0-9]+$/, "") !== path)) throw new Error(oneScript);
  if (!existsSync(path)) throw new Error(`--subject ${path}: no such file`);
  try {
    return await loadScript(path);
  } catch (error) {
    throw new Error(`--subject ${path}: it cannot be loaded: ${error?.message ?? error}`);
  }
}

const here = {
  onStdout: (bytes) => writeAll(1, bytes),
  onStderr: (bytes) => writeAll(2, bytes),
  readStdin: stdinBytes(),
  mount: mountMachine,
};

/** `of`: whose --subject names the script. */
async function one(args, told = here, of = args) {
  return (await run(args.map(argument), { ...told, mount: mountMachine, subject: await subjectOf(of) })).code;
}

/** Takes --threads N out of the arguments of prove; undefined where the run cannot be divided into shards. */
function threadsOf(args) {
  const at = args.findIndex((text) => text === "--threads" || text.startsWith("--threads="));
  if (args[0] !== "prove" || at < 0) return undefined;
  const text = args[at] === "--threads" ? args[at + 1] : args[at].slice("--threads=".length);
  const rest = args.filter((_, k) => k !== at && !(args[at] === "--threads" && k === at + 1));
  const cores = os.availableParallelism?.() ?? os.cpus().length;
  const threads = text === "0" ? cores : Number(text);
  // The program says what is wrong with others.
  if (!/^[0-9]+$/.test(text ?? "") || threads < 1 || threads > 4 * cores) return undefined;
  if (rest.some((word) => word === "--threads" || word.startsWith("--threads="))) return undefined;
  const alone = ["--shard", "--journal", "--junit", "--source", "--case", "--help"];
  if (threads === 1 || rest.some((word) => alone.includes(word.split("=")[0]))) return { rest, threads: 1 };
  return { rest, threads };
}

/** A shard a thread, put together by `mmverify merge`. */
async function inThreads(args, threads) {
  const folder = mkdtempSync(join(os.tmpdir(), "mmverify-"));
  const jsonAt = args.findIndex((word) => word === "--json" || word.startsWith("--json="));
  const json = jsonAt < 0 ? undefined : args[jsonAt].startsWith("--json=") ? args[jsonAt].slice(7) : args[jsonAt + 1];
  const rest = args.filter((_, k) => jsonAt < 0 || (k !== jsonAt && !(args[jsonAt] === "--json" && k === jsonAt + 1)));
  try {
    const module = await compile();
    const shards = Array.from({ length: threads }, (_, k) => join(folder, `${k + 1}.json`));
    const ended = await Promise.all(shards.map((file, k) => new Promise((done, failed) => {
      const mine = [...rest, "--quiet", "--shard", `${k + 1}/${threads}`, "--json", file];
      const worker = new Worker(new URL(import.meta.url), { workerData: { args: mine, module } });
      worker.on("message", done);
      worker.on("error", failed);
      worker.on("exit", () => failed(new Error(`shard ${k + 1} of ${threads} ended without a verdict`)));
    })));
    const bad = ended.find(({ code }) => code !== 0 && code !== 1 && code !== 3);
    if (bad !== undefined) {
      writeAll(2, new TextEncoder().encode(bad.stderr));
      return bad.code;
    }
    const out = json === undefined || json === "-" ? join(folder, "all.json") : json;
    // Where JSON goes to standard output, the text does not.
    const told = json === "-" ? { ...here, onStdout: here.onStderr } : here;
    const code = await one(["merge", ...shards, "-o", out], told, args);
    if (json === "-" && existsSync(out)) writeAll(1, readFileSync(out));
    return code;
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

const leftOut = ["attributes", "bench", "completion", "man", "paper", "render", "report", "schema", "views"];

/** Files that lie in the root folder itself are not the program's to see: it has a root folder of its own. */
function checkPlaces(args) {
  if (sep === "\\") return;
  if (process.cwd() === "/") throw new Error("it cannot work in the folder /; change into another one");
  const there = args.map((text) => text.slice(text.startsWith("--") ? text.indexOf("=") + 1 : 0))
    .find((text) => /^\/[^/]+$/.test(text) && !(existsSync(text) && statSync(text).isDirectory()));
  if (there !== undefined) throw new Error(`${there}: files that lie in the folder / itself cannot be had; use another folder`);
}

async function main(args) {
  if (leftOut.includes(args[0])) throw new Error(`${args[0]} is not in this package; the native mmverify has it`);
  checkPlaces(args);
  const divided = threadsOf(args);
  if (divided === undefined) return one(args);
  return divided.threads === 1 ? one([...divided.rest, "--threads", "1"]) : inThreads(divided.rest, divided.threads);
}

if (isMainThread) {
  // A script under test that ends the process has not passed.
  process.on("exit", () => {
    if (ended) return;
    writeAll(2, new TextEncoder().encode("mmverify: the process was ended before there was a verdict\n"));
    process.exitCode = environment;
  });
  try {
    process.exitCode = await main(process.argv.slice(2));
  } catch (error) {
    const message = error?.message ?? String(error);
    writeAll(2, new TextEncoder().encode(`mmverify: ${message}\n`));
    process.exitCode = message === oneScript ? usage : environment;
  }
  ended = true;
} else {
  const { args, module } = workerData;
  const ended = await run(args, { module, mount: mountMachine, subject: await subjectOf(args) });
  parentPort.postMessage({ code: ended.code, stderr: ended.stderr });
}
