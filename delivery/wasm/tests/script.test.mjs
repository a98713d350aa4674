// Scripts as subjects of the package: in which numbers they are judged, and that the verdict says so.
// usage: MMVERIFY_NPM=FOLDER node --test script.test.mjs        FOLDER: whose node_modules has acorn
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";

import { seed } from "./program.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const folder = mkdtempSync(join(tmpdir(), "mmverify-script-"));
after(() => rmSync(folder, { recursive: true, force: true }));
const package_ = join(folder, "package");
cpSync(join(here, "..", "package"), package_, { recursive: true });
cpSync(join(here, "program.mjs"), join(package_, "program.mjs"));
writeFileSync(join(package_, "mmverify.wasm"), Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0)); // a module with nothing in it
mkdirSync(join(package_, "node_modules"));
symlinkSync(resolve(process.env.MMVERIFY_NPM, "node_modules", "acorn"), join(package_, "node_modules", "acorn"));

// As its CMakeLists.txt fills it in.
const described = JSON.parse(readFileSync(join(package_, "package.json.in"), "utf8").replace(/@\w+@/g, "0.0.0"));
writeFileSync(join(package_, "package.json"), JSON.stringify(described));

const loop = (upper) => `export function index_f32(level, u, v, index) {
  const N = 2 ** level;
  for (let k = 0; k < index.length; ++k) index[k] = ${upper} ? 1 : 0;
}
`;
const scripts = {
  // The upper half by w, as a shader might have it: 1 - u - v is rounded.
  "by_w.mjs": loop("Math.floor(u[k] * N) + Math.floor(v[k] * N) + Math.ceil((1 - u[k] - v[k]) * N) < N"),
  "published.mjs": loop("((x, y) => x - Math.floor(x) + (y - Math.floor(y)) >= 1)(u[k] * N, v[k] * N)"),
  "exact.mjs": loop("((x, y) => Math.min(x, y) >= 1 - Math.max(x, y))(u[k] * N % 1, v[k] * N % 1)"),
  "w.mjs": "export function w(u, v) {\n  let rest = 1;\n  rest -= u;\n  rest -= v;\n  return rest;\n}\n",
  "imports.mjs": `import { w } from "./w.mjs";\n${loop("Math.floor(u[k] * N) + Math.floor(v[k] * N) + Math.ceil(w(u[k], v[k]) * N) < N")}`,
  "old.cjs": loop("Math.floor(u[k] * N) + Math.floor(v[k] * N) + Math.ceil((1 - u[k] - v[k]) * N) < N").replace("export function index_f32", "exports.index_f32 = function"),
  "evals.mjs": `const one = 1;\n${loop("eval('1 - u[k]') < v[k]")}`,
};
scripts["in_doubles.mjs"] = `export const arithmetic = "binary64";\n${scripts["by_w.mjs"]}`;
scripts["in_halves.mjs"] = `export const arithmetic = "binary16";\n${scripts["by_w.mjs"]}`;
scripts["both.mjs"] = `#!/usr/bin/env node\n${scripts["by_w.mjs"]}export const third = 1 / 3;\nexport function index_f64() { return 1 / 3; }\n`;
for (const [name, text] of Object.entries(scripts)) writeFileSync(join(folder, name), text);

/** The program on a script: exit code, what it says, on how many pairs the script is wrong. */
function prove(script, ...more) {
  const ran = spawnSync(process.execPath, [join(package_, "bin", "mmverify.mjs"), "prove", "--subject", `./${script}`, ...more],
    { cwd: folder, encoding: "utf8" });
  return { ...ran, wrong: Number(/^wrong: (\d+)$/m.exec(ran.stdout)?.[1]) };
}
const rounded = "arithmetic: each operation rounded to binary32, between whole numbers exact";
const doubles = "arithmetic: in binary64, as JavaScript computes; in binary32, as shaders do, it may answer otherwise";

test("a formula that binary32 rounds is wrong, and the verdict's last line says the numbers", () => {
  for (const script of ["by_w.mjs", "published.mjs", "imports.mjs"]) {
    const { status, stdout, stderr, wrong } = prove(script);
    assert.equal(status, 1, stderr);
    assert.ok(wrong > 100, `${script}: ${wrong}`);
    assert.equal(stdout.trimEnd().split("\n").at(-1), `./${script}: ${rounded}`);
  }
  assert.equal(prove("imports.mjs").wrong, prove("by_w.mjs").wrong);
  const exact = prove("exact.mjs");
  assert.deepEqual([exact.status, exact.wrong], [0, 0]);
});

test("in doubles the same formula is right, and the verdict says that it was doubles", () => {
  const { status, stdout, wrong } = prove("in_doubles.mjs");
  assert.deepEqual([status, wrong], [0, 0]);
  assert.ok(stdout.endsWith(`./in_doubles.mjs: ${doubles}\n`), stdout);
  const old = prove("old.cjs");
  assert.deepEqual([old.status, old.wrong], [0, 0]);
  assert.match(old.stdout, /in binary64, as JavaScript computes.*old[.]cjs: no ES module/);
});

test("JSON says it, in a file, on standard output, of threads", () => {
  const said = [{ subject: "./by_w.mjs", about: { arithmetic: rounded.slice("arithmetic: ".length) }, warnings: [] }];
  prove("by_w.mjs", "--json", "file.json");
  const text = readFileSync(join(folder, "file.json"), "utf8");
  assert.match(text, new RegExp(`"seed":${seed}`));
  const file = JSON.parse(text);
  assert.deepEqual(file.runs_on, said);
  assert.ok(file.results[0].wrong > 100);
  const { stdout, stderr } = prove("by_w.mjs", "--json", "-");
  assert.deepEqual(JSON.parse(stdout).runs_on, said);
  assert.match(stderr, new RegExp(rounded));
  const threads = prove("by_w.mjs", "--threads", "2", "--json", "sum.json");
  assert.equal(threads.status, 0, threads.stderr);
  assert.ok(threads.stdout.endsWith(`./by_w.mjs: ${rounded}\n`), threads.stdout);
  assert.deepEqual(JSON.parse(readFileSync(join(folder, "sum.json"), "utf8")).runs_on, said);
});

test("what cannot be rounded is refused, with its line", () => {
  const evals = prove("evals.mjs");
  assert.equal(evals.status, 4);
  assert.match(evals.stderr, /evals[.]mjs: line 4: eval: the arithmetic of text that a script makes is not rounded/);
  const halves = prove("in_halves.mjs");
  assert.equal(halves.status, 4);
  assert.match(halves.stderr, /arithmetic = "binary16": write "binary32" or "binary64"/);
});

test("entry points on doubles stay in doubles", async () => {
  const { loadScript } = await import(pathToFileURL(join(package_, "script.mjs")));
  const both = await loadScript(join(folder, "both.mjs"));
  assert.equal(both.index_f64(), 1 / 3);
  assert.equal(both.third, Math.fround(1 / 3));
  assert.match(both.arithmetic, /rounded to binary32.*; index_f64 in binary64$/);
});

test("functions that are handed over compute in doubles, and the result says so", async () => {
  const { prove: proved } = await import(pathToFileURL(join(package_, "index.mjs")));
  const { index_f32 } = await import(pathToFileURL(join(folder, "by_w.mjs")));
  const { result, text } = await proved([], { subject: { path: "mine", index_f32 } });
  assert.equal(result.results[0].wrong, 0);
  assert.equal(`arithmetic: ${result.runs_on[0].about.arithmetic}`, doubles);
  assert.match(text, /^mine: arithmetic: in binary64/m);
});

test("CommonJS has each function of the module, by require()", async () => {
  mkdirSync(join(folder, "user", "node_modules"), { recursive: true });
  symlinkSync(package_, join(folder, "user", "node_modules", "mmverify"));
  const required = createRequire(join(folder, "user", "mine.js"))("mmverify");
  const imported = await import(pathToFileURL(join(package_, "index.mjs")).href);
  const functions = Object.keys(imported).filter((name) => typeof imported[name] === "function");
  assert.deepEqual(Object.keys(required).sort(), functions.sort());
  assert.equal((await required.compile()) instanceof WebAssembly.Module, true);
  await assert.rejects(required.validate("no bytes"), /have to be a Uint8Array/);
  assert.equal(described.license, "MIT");
  assert.match(described.repository.url, /^git[+]https:/);
});
