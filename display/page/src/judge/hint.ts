// Hints for pasted texts that the page cannot run: their language, and the command that judges them.
import { inBinary32 } from "../../../../delivery/wasm/package/rewrite.mjs";
import type { Language } from "./examples";

export interface Command {
  /** What it judges the text on, or as. */
  on: string;
  line: string;
}

export interface Hint {
  words: string;
  /** Commands that judge the text; none where the page does. */
  commands?: Command[];
  /** The page runs the text in this language. */
  language?: Language;
}

const withoutComments = (code: string): string => code.replace(/\/\*[^]*?\*\/|\/\/[^\n]*/g, " ");

/** Whether it is JavaScript, not counting what binary32 cannot round. */
function isScript(code: string, kind: "script" | "module"): boolean {
  try {
    inBinary32(code, kind);
    return true;
  } catch (error) {
    return !/SyntaxError/.test(String(error));
  }
}

const shader = (name: string, ending: string): { words: string; commands: Command[] } => ({
  words: `This is ${name}, and the page has no compiler for it. The native program judges it`,
  commands: [
    { on: "on a Vulkan device", line: `mmverify prove index --subject mine.${ending}` },
    { on: "on every float", line: `mmverify prove index.floats --source mine.${ending} --function index` },
  ],
});

/** Signs of each language, the surest first. */
const foreign: { signs: RegExp; words: string; commands: Command[] }[] = [
  {
    signs: /#\[no_mangle\]|\bpub\s+(extern\s+"C"\s+)?fn\b|\blet\s+mut\b|\bas\s+u32\b/,
    words: "This is Rust, and the page has no compiler for it. The native program judges a shared library",
    commands: [{ on: "", line: "mmverify prove index --subject ./libmine.so" }],
  },
  { signs: /\[\s*numthreads|\bSV_\w+|\b(RW)?StructuredBuffer\b|\bcbuffer\b|\b(float|uint|int)[234]\b|\[shader\(/, ...shader("HLSL", "hlsl") },
  { signs: /#\s*version\b|\blayout\s*\(|\bgl_[A-Z]\w*|\b[ui]?vec[234]\b|\bprecision\s+(high|medium|low)p\b/, ...shader("GLSL", "glsl") },
  {
    signs: /#\s*include\b|\buint(8|16|32|64)_t\b|\bextern\s+"C"|\bstd::|\bstatic_cast\b|\bunsigned\s+\w+\s*\(|\bunsigned\s+int\b/,
    words: "This is C or C++, and the page has no compiler for it. The native program judges it",
    commands: [
      { on: "from its source, on every float", line: "mmverify prove index.floats --source mine.cpp --function index" },
      { on: "as a shared library", line: "mmverify prove index --subject ./libmine.so" },
    ],
  },
  { signs: /\buint\s+\w+\s*\(/, ...shader("GLSL or HLSL", "glsl") },
  {
    signs: /^\s*def\s+\w+\s*\(|^\s*import\s+numpy\b/m,
    words: 'This is Python, which the page does not run. Paste its answers below, under "A table of answers", or judge them',
    commands: [{ on: "with the native program", line: "mmverify gen index --level 3 | python3 mine.py | mmverify check index --level 3" }],
  },
];

const npmWords = "This is a script for npm";
const npmCommands: Command[] = [{ on: "", line: "npx mmverify prove index --subject ./mine.mjs" }];

/** Null where the text is in the chosen language, or in none that is known. */
export function hintFor(code: string, chosen: Language): Hint | null {
  const text = withoutComments(code);
  if (/\bfn\s+index\s*\(/.test(text) && !foreign[0]!.signs.test(text)) return chosen === "WGSL" ? null : { words: "This is WGSL, so the language is WGSL now", language: "WGSL" };
  if (isScript(code, "script")) return chosen === "WGSL" && /\bindex\b/.test(text) ? { words: "This is JavaScript, so the language is JavaScript now", language: "JavaScript" } : null;
  if (/^\s*(import|export)\b/m.test(text) && isScript(code, "module"))
    return /^\s*import\b/m.test(text)
      ? { words: `${npmWords} with imports, which a page cannot read. The npm package judges it`, commands: npmCommands }
      : { words: `${npmWords}: the page asks its index, or its index_f32. The npm package asks all of its functions`, commands: npmCommands, language: "JavaScript" };
  const found = foreign.find(({ signs }) => signs.test(text));
  return found ? { words: found.words, commands: found.commands } : null;
}
