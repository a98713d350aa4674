// mmverify as a module: each call is one run of the program, in an instance of its own.
import { arithmeticWords } from "./binary32.mjs";
import createProgram from "./program.mjs";

const inNode = typeof process === "object" && process.versions?.node !== undefined;
let compiled;

/** The compiled program, once a process.  `source`: its bytes, where they do not lie beside this file. */
export function compile(source) {
  compiled ??= (async () => {
    if (source !== undefined) return WebAssembly.compile(await source);
    const address = new URL("./mmverify.wasm", import.meta.url);
    if (!inNode) return WebAssembly.compile(await (await fetch(address)).arrayBuffer());
    const { readFile } = await import("node:fs/promises");
    return WebAssembly.compile(await readFile(address));
  })();
  compiled.catch(() => (compiled = undefined)); // another try may do better
  return compiled;
}

/** What emscripten's module expects of Node.js, and modules do not have. */
async function nodeGlobals() {
  if (!inNode || globalThis.require !== undefined) return;
  const { createRequire } = await import("node:module");
  const { dirname } = await import("node:path");
  const { fileURLToPath } = await import("node:url");
  globalThis.require = createRequire(import.meta.url);
  globalThis.__dirname = dirname(fileURLToPath(import.meta.url));
}

/** Bytes of a stream: told in pieces as they come, or kept, and their text in the end. */
function collector(tell) {
  const pieces = [];
  let piece = new Uint8Array(1 << 15);
  let size = 0;
  let last = 0;
  const flush = () => {
    if (size === 0) return;
    (tell ?? ((bytes) => pieces.push(bytes)))(piece.slice(0, size));
    size = 0;
    last = Date.now();
  };
  return {
    put(byte) {
      if (byte === null) return;
      piece[size++] = byte;
      // Lines are told at once, unless there are thousands of them.
      if (size === piece.length || (tell && byte === 10 && Date.now() - last > 20)) flush();
    },
    flush,
    text() {
      const decoder = new TextDecoder();
      return pieces.map((bytes) => decoder.decode(bytes, { stream: true })).join("") + decoder.decode();
    },
  };
}

/** The value of an option of the command line, the last where it is given again. */
function valueOf(args, option) {
  const at = args.findLastIndex((word) => word === option || word.startsWith(`${option}=`));
  return at < 0 ? undefined : args[at] === option ? args[at + 1] : args[at].slice(option.length + 1);
}

/** A result that says in which numbers a script computed; shards are sealed, and their sum says it.  All else stays as it is
 *  written: a seed may have more digits than a number of JavaScript. */
function withArithmetic(text, path, arithmetic) {
  if (JSON.parse(text).shard !== undefined) return text;
  const runsOn = [{ subject: path, about: { arithmetic }, warnings: [] }];
  return text.replace("{", () => `{\n "runs_on": ${JSON.stringify(runsOn)},`);
}

/**
 * Runs `mmverify ARGS`.  A verdict on `options.subject` says in which numbers it computed: in binary64, as functions of
 * JavaScript do, or what its `arithmetic` says.
 *
 * Resolves to { code, stdout, stderr, files }: the exit code of the command line's contract, what was said, unless
 * onStdout or onStderr were told, and the contents of those files that `wanted` names.
 * Rejects where WebAssembly cannot run or the program aborts, for want of memory for instance.
 */
export async function run(words, options = {}) {
  const args = words.map(String);
  const module = await (options.module ?? compile());
  if (!(module instanceof WebAssembly.Module)) throw new TypeError("run: options.module is no WebAssembly.Module");
  await nodeGlobals();
  const judges = options.subject !== undefined && (args[0] === "prove" || args[0] === "merge");
  const json = judges ? valueOf(args, args[0] === "prove" ? "--json" : "-o") : undefined;
  const out = collector(json === "-" ? undefined : options.onStdout);
  const errors = collector(options.onStderr);
  let given = 0;
  const input = options.stdin === undefined ? undefined : new TextEncoder().encode(options.stdin);
  const failed = {};
  const failure = new Promise((_, reject) => (failed.with = reject));
  failure.catch(() => {});
  const program = await Promise.race([failure, createProgram({
    noInitialRun: true,
    thisProgram: "mmverify",
    subject: options.subject,
    instantiateWasm(imports, receive) {
      WebAssembly.instantiate(module, imports).then((instance) => receive(instance, module), failed.with);
      return {};
    },
    preRun: [(its) => its.FS.init(options.readStdin ?? (() => (input && given < input.length ? input[given++] : null)),
      out.put, errors.put)],
  })]);
  const { FS } = program;
  options.mount?.(program);
  for (const [name, contents] of Object.entries(options.files ?? {})) {
    const folder = name.slice(0, name.lastIndexOf("/"));
    if (folder !== "") FS.mkdirTree(folder);
    FS.writeFile(name, contents);
  }
  const code = program.callMain(args);
  out.flush();
  let stdout = out.text();
  if (judges && code !== 2 && code !== 4) {
    const { path, arithmetic = arithmeticWords.binary64 } = options.subject;
    const said = (text) => withArithmetic(text, path, arithmetic);
    if (json !== undefined && json !== "-" && FS.analyzePath(json).exists)
      FS.writeFile(json, said(FS.readFile(json, { encoding: "utf8" })));
    if (json === "-") stdout = said(stdout);
    for (const byte of new TextEncoder().encode(`${path}: arithmetic: ${arithmetic}\n`)) (json === "-" ? errors : out).put(byte);
    out.flush();
    if (json !== "-") stdout = out.text();
  }
  if (json === "-") options.onStdout?.(new TextEncoder().encode(stdout));
  errors.flush();
  const files = {};
  for (const name of options.wanted ?? []) if (FS.analyzePath(name).exists) files[name] = FS.readFile(name);
  return { code, stdout, stderr: errors.text(), files };
}

/** The last part of a name, where a file of such bytes lies for the program. */
function given(bytes, name) {
  if (!(bytes instanceof Uint8Array)) throw new TypeError("the file's contents have to be a Uint8Array");
  return `/tmp/given/${String(name).split(/[\\/]/).pop() || "file"}`;
}

async function runForJson(args, options) {
  const json = "/tmp/answer/result.json";
  const ended = await run([...args, "--json", json], {
    ...options,
    files: { "/tmp/answer/.keep": "", ...options.files },
    wanted: [json],
  });
  const bytes = ended.files[json];
  if (bytes === undefined) throw new Error(ended.stderr.trim() || `mmverify ended with exit code ${ended.code}`);
  return { code: ended.code, text: ended.stdout, result: JSON.parse(new TextDecoder().decode(bytes)) };
}

/** Proves laws; `what` are laws or topics.  The result follows docs/result.schema.json. */
export async function prove(what = [], options = {}) {
  const args = ["prove", ...what, "--quiet"];
  if (options.levels !== undefined) args.push("--levels", String(options.levels));
  if (options.subject !== undefined) {
    if (typeof options.subject.path !== "string") throw new TypeError("prove: options.subject has no path, by which it is named");
    args.push("--subject", options.subject.path);
  }
  if (options.mutants === false) args.push("--no-mutants");
  return runForJson(args, options);
}

/** What is wrong with a file; see docs/VALIDATE.md.  The result follows docs/validate.schema.json. */
export async function validate(bytes, name = "scene.glb", options = {}) {
  const file = given(bytes, name);
  return runForJson(["validate", file], { ...options, files: { ...options.files, [file]: bytes } });
}

/** The plan of a scene and what its micromaps save; see docs/SCENE.md. */
export async function scene(bytes, name = "scene.glb", options = {}) {
  const file = given(bytes, name);
  return runForJson(["scene", file, "--quiet", ...(options.arguments ?? [])],
    { ...options, files: { ...options.files, [file]: bytes } });
}
