// Bundles src/main.ts, the styles and template.html into one page without data: node build.mjs OUT.html [OUT.cpp]
// OUT.cpp has the same bytes for the program, as display/report/page.hpp declares.
// Packages are looked for beside this file and in NODE_PATH.
import { createRequire } from "node:module";
import { mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const elsewhere = (process.env.NODE_PATH ?? "").split(":").filter((path) => path !== "");
const require = createRequire(elsewhere.length > 0 ? join(elsewhere[0], "..", "package.json") : import.meta.url);
const esbuild = require("esbuild");

const out = resolve(process.argv[2] ?? join(here, "report.html"));
const common = { bundle: true, minify: true, write: false, nodePaths: elsewhere, legalComments: "none", logLevel: "warning" };
const text = (result) => result.outputFiles[0].text.trim();

const script = text(
  await esbuild.build({
    ...common,
    entryPoints: [join(here, "src/main.ts")],
    format: "iife",
    target: "es2022",
    charset: "ascii",
    // uPlot's licence asks for its notice.
    banner: { js: "/* with uPlot, (c) Leon Sorokin, MIT licence, https://github.com/leeoniya/uPlot */" },
  }),
);
const style = text(await esbuild.build({ ...common, entryPoints: [join(here, "src/style.css")] }));
for (const [name, part] of Object.entries({ script, style }))
  if (/<\/(script|style)|<!--/i.test(part)) throw new Error(`the ${name} would end its own element`);

// A function, as a string would have its dollar signs read.
const page = readFileSync(join(here, "template.html"), "utf8")
  .replace("/*{style}*/", () => style)
  .replace("/*{script}*/", () => script);
if (page.split("{data}").length !== 2) throw new Error("the page must have one place for data");
function write(file, contents) {
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(`${file}.part`, contents);
  renameSync(`${file}.part`, file);
}
write(out, page);

if (process.argv[3] !== undefined) {
  const numbers = [...Buffer.from(page)].join(",").replace(/(.{100}\d*,)/g, "$1\n");
  write(
    resolve(process.argv[3]),
    `#include "display/report/page.hpp"

namespace mmverify::report {
namespace {
// Numbers, as a compiler may limit the length of a string.
const unsigned char bytes[] = {
${numbers}};
}  // namespace

std::string_view page() { return {reinterpret_cast<const char*>(bytes), sizeof bytes}; }
std::string_view why_no_page() { return {}; }

}  // namespace mmverify::report
`,
  );
}
