// Tests of a person's input: texts in any language, files, links.
import assert from "node:assert/strict";
import { test } from "node:test";

import { inBinary32 } from "../../../delivery/wasm/package/rewrite.mjs";
import { kindOf } from "../src/files/kinds";
import { examples } from "../src/judge/examples";
import { hintFor } from "../src/judge/hint";
import { addressOf, type Case, caseOf } from "../src/judge/link";
import { withLine } from "../src/program/lines";
import { withoutExports } from "../src/program/npm_script";
import { reportOfFiles } from "../src/result/read";

const texts = {
  glsl: "#version 460\nuint index(uint level, float u, float v) {\n  return uint(u * float(1u << level));\n}\n",
  hlsl: "RWStructuredBuffer<uint> answers;\n[numthreads(64, 1, 1)]\nvoid main(uint3 id : SV_DispatchThreadID) { answers[id.x] = 0; }\n",
  plain: "uint index(uint level, float u, float v) { return 0u; }",
  c: "#include <stdint.h>\nuint32_t index_of(uint32_t level, float u, float v) { return 0; }",
  rust: "#[no_mangle]\npub extern \"C\" fn index(level: u32, u: f32, v: f32) -> u32 { 0 }",
  python: "import numpy\ndef index(level, u, v):\n    return 0\n",
};

test("a text of another language gets the command that judges it", () => {
  const commands: Record<keyof typeof texts, [RegExp, RegExp]> = {
    glsl: [/^This is GLSL,/, /--subject mine\.glsl$/],
    hlsl: [/^This is HLSL,/, /--subject mine\.hlsl$/],
    plain: [/^This is GLSL or HLSL,/, /--subject mine\.glsl$/],
    c: [/^This is C or C\+\+,/, /--source mine\.cpp/],
    rust: [/^This is Rust,/, /--subject \.\/libmine\.so$/],
    python: [/^This is Python,/, /check index/],
  };
  for (const [name, [words, command]] of Object.entries(commands))
    for (const language of ["JavaScript", "WGSL"] as const) {
      const hint = hintFor(texts[name as keyof typeof texts], language)!;
      assert.match(hint.words, words);
      assert.match(hint.commands![0]!.line, command);
      assert.equal(hint.language, undefined);
    }
});

test("no hint for what the page runs in the chosen language; the other language is chosen", () => {
  for (const { language, code } of examples) {
    assert.equal(hintFor(code, language), null);
    assert.equal(hintFor(code, language === "WGSL" ? "JavaScript" : "WGSL")!.language, language);
  }
  // Words of a shader in a comment, or as names, make no shader of a script.
  assert.equal(hintFor("// like vec2 and layout(\nfunction index(level, u, v) { const float2 = u; return 0; }", "JavaScript"), null);
  assert.equal(hintFor("function index(level, u, v) { return level +* u; }", "JavaScript"), null);
});

test("a script for npm: judged where it imports nothing, else the command", () => {
  const script = "export const name = 'mine';\nexport function index_f32(level, u, v, index) { index[0] = 3; }\nexport { name as other };\n";
  const hint = hintFor(script, "JavaScript")!;
  assert.equal(hint.language, "JavaScript");
  assert.match(hint.words, /index_f32/);
  assert.match(hint.commands![0]!.line, /^npx mmverify prove index --subject/);
  const plain = withoutExports(script);
  assert.equal(plain.split("\n").length, script.split("\n").length);
  const answer = [0];
  new Function(`${plain}; return index_f32;`)()(0, [], [], answer);
  assert.deepEqual(answer, [3]);
  const imports = hintFor(`import { curve } from "./curve.mjs";\nexport const index = curve;\n`, "JavaScript")!;
  assert.match(imports.words, /with imports, which a page cannot read/);
  assert.equal(imports.language, undefined);
});

test("lines of a rewritten text are those of the text", () => {
  const text = "const a = (1 +\n  2 *\n  3);\nlet b = 1;\nb +=\n  a;\nthrow b";
  assert.equal(inBinary32(text, "script").split("\n").length, text.split("\n").length);
});

test("an error names the line of the function, above the operations that round", () => {
  const error = new ReferenceError("x is not defined");
  error.stack = "ReferenceError: x is not defined\n    at add (blob:null/1:3:7)\n    at index (blob:null/1:45:9)\n    at judge (blob:null/1:12:1)";
  assert.equal(withLine(error, 42).message, "line 3: ReferenceError: x is not defined");
  error.stack = "add@blob:null/1:3:7\nindex@blob:null/1:44:9\n";
  assert.equal(withLine(error, 42).message, "line 2: ReferenceError: x is not defined");
  assert.equal(withLine("no", 42).message, "thrown: no");
});

test("a case comes back from its address; what is cut off is said to be", async () => {
  const of: Case = { language: "JavaScript", code: "function index() {\n  return 0; // µ\n}", numbers: "binary64", levels: 4, floats: false, law: "index.rounding", level: 1, case: "v:u=1/2,v=0" };
  const address = await addressOf(of);
  assert.match(address, /^#case=[A-Za-z0-9_-]+$/);
  assert.deepEqual(await caseOf(address), of);
  assert.equal(await caseOf("#laws"), null);
  const cannot = /^Error: This link's case cannot be read/;
  await assert.rejects(caseOf(address.slice(0, -9)), cannot);
  await assert.rejects(caseOf(await addressOf({ ...of, level: 99 })), cannot);
  await assert.rejects(caseOf(await addressOf({ ...of, code: "x".repeat(300_000) })), cannot);
});

test("a dropped file goes to the section of its name", () => {
  assert.equal(kindOf(["a.glb"]), "scene");
  assert.equal(kindOf(["a.gltf", "a.json", "a.bin"]), "scene");
  assert.equal(kindOf(["RESULT.JSON"]), "result");
  assert.equal(kindOf(["mine.wgsl"]), "function");
  assert.equal(kindOf(["note.txt"]), null);
});

test("a result becomes a report; what is none is named, with the reason", () => {
  const tool = { version: "1", compiler: "c", spec_hash: "s", source_hash: "h" };
  const result = { schema: "mmverify.result/1", tool, results: [] };
  const text = (value: unknown): string => JSON.stringify(value);
  const report = reportOfFiles([{ name: "a.json", text: text(result) }, { name: "b.json", text: text({ schema: "mmverify.bench/1", topic: "vq", tool, rows: [] }) }]);
  assert.deepEqual(report.files.map((f) => f.name), ["a.json", "b.json"]);
  assert.deepEqual(report.tool, tool);
  const refused = (name: string, content: string, words: RegExp): void => assert.throws(() => reportOfFiles([{ name, text: content }]), words);
  refused("x.json", "{", /^Error: x\.json: no JSON: /);
  refused("x.json", "[1]", /^Error: x\.json: it has no "schema"/);
  refused("v.json", text({ schema: "mmverify.validate/1", tool }), /^Error: v\.json: its schema is mmverify\.validate\/1/);
  refused("r.json", text({ schema: "mmverify.result/1", tool }), /^Error: r\.json: it has no "results"/);
});
