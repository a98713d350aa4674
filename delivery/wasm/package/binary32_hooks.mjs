// Hooks of Node.js's loader: a module whose address bears the mark is loaded with its operations rounded to binary32, and so
// are the files that it imports.
import { fileURLToPath } from "node:url";

import { scopeNames } from "./binary32.mjs";
import { inBinary32 } from "./rewrite.mjs";

const mark = "mmverify-binary32";
const marked = (url) => url?.startsWith("file:") && new URL(url).searchParams.has(mark);

/** The words of an error about a file that is no module: who loads it may go without the rounding. */
export const noModule = "no ES module, whose arithmetic alone can be rounded";

export function withMark(url) {
  const address = new URL(url);
  address.searchParams.set(mark, "");
  return address.href;
}

export async function resolve(specifier, context, next) {
  const found = await next(specifier, context);
  return marked(context.parentURL) && found.url.startsWith("file:") ? { ...found, url: withMark(found.url) } : found;
}

export async function load(url, context, next) {
  const loaded = await next(url, context);
  if (!marked(url) || loaded.format === "json") return loaded;
  const path = fileURLToPath(url);
  if (loaded.format !== "module") throw new Error(`${path}: ${noModule}`);
  const text = typeof loaded.source === "string" ? loaded.source : new TextDecoder().decode(loaded.source);
  let rounded;
  try {
    rounded = inBinary32(text.replace(/^#!/, "//"));
  } catch (error) {
    throw new Error(`${path}: ${error.message}`);
  }
  // They stand on the first line, so that lines keep their numbers.
  const names = `const { ${scopeNames.join(", ")} } = globalThis[Symbol.for("${mark}")];`;
  return { ...loaded, source: `${names} ${rounded}` };
}
