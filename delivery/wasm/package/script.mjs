// A script of Node.js as a subject: its functions, in the numbers that they are judged in.
import { readFileSync } from "node:fs";
import * as module from "node:module";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

import { arithmeticWords, scope } from "./binary32.mjs";
import { noModule, withMark } from "./binary32_hooks.mjs";
import { declaredArithmetic } from "./rewrite.mjs";

let hooked = false;
function hook() {
  if (hooked) return;
  if (module.register === undefined) throw new Error("rounding to binary32 needs Node.js 18.19, or 20.6 or later; this is " + process.version);
  module.register("./binary32_hooks.mjs", import.meta.url);
  globalThis[Symbol.for("mmverify-binary32")] = scope;
  hooked = true;
}

/** Entry points on doubles are judged in doubles: those of the script as it is. */
const onDoubles = /_f64$/;

/**
 * The functions that a script exports, under its path.  They compute in binary32, each operation rounded, but for those on
 * doubles, or where the script says `export const arithmetic = "binary64"`, or is CommonJS; `arithmetic` says which.
 */
export async function loadScript(path) {
  const url = pathToFileURL(resolve(path)).href;
  const text = readFileSync(path, "utf8");
  const declared = /\barithmetic\b/.test(text) ? declaredArithmetic(text) : undefined;
  if (declared !== undefined && !(declared in arithmeticWords)) throw new Error(`arithmetic = ${JSON.stringify(declared)}: write "binary32" or "binary64"`);
  if (declared === "binary64") return { ...(await import(url)), path, arithmetic: arithmeticWords.binary64 };
  hook();
  let rounded;
  try {
    rounded = { ...(await import(withMark(url))) };
  } catch (error) {
    if (!String(error?.message).includes(noModule)) throw error;
    const { default: exported, ...named } = await import(url);
    return { ...exported, ...named, path, arithmetic: `${arithmeticWords.binary64}: ${error.message}` };
  }
  const doubles = Object.keys(rounded).filter((name) => onDoubles.test(name));
  if (doubles.length === 0) return { ...rounded, path, arithmetic: arithmeticWords.binary32 };
  const plain = await import(url);
  for (const name of doubles) rounded[name] = plain[name];
  return { ...rounded, path, arithmetic: `${arithmeticWords.binary32}; ${doubles.join(" and ")} in binary64` };
}
