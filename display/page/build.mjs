// Bundles src/main.ts, its worker, the styles, the program and template.html into one page:
//   node build.mjs PACKAGE OUT.html [FOLDER]
//     PACKAGE: the folder of mmverify's npm package, with mmverify.wasm
//     FOLDER: has page.json and src/main.ts, as this one, which is bundled where none is given
// Node.js packages are looked for in NODE_PATH, as report/packages installs them.
import { createHash } from "node:crypto";
import { builtinModules, createRequire } from "node:module";
import { existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const here = dirname(fileURLToPath(import.meta.url));
if (process.argv.length !== 4 && process.argv.length !== 5) {
  console.error("usage: node build.mjs PACKAGE OUT.html [FOLDER]");
  process.exit(2);
}
const [packaged, out, folder = here] = process.argv.slice(2).map((path) => resolve(path));
const { banner, images, ...words } = JSON.parse(readFileSync(join(folder, "page.json"), "utf8"));
for (const name of ["index.mjs", "program.mjs", "mmverify.wasm"])
  if (!existsSync(join(packaged, name))) {
    console.error(`${join(packaged, name)}: no such file; ./run wasm builds the package`);
    process.exit(2);
  }
const elsewhere = (process.env.NODE_PATH ?? "").split(":").filter((path) => path !== "");
const require = createRequire(elsewhere.length > 0 ? join(elsewhere[0], "..", "package.json") : import.meta.url);
const esbuild = require("esbuild");

const common = {
  bundle: true,
  minify: true,
  write: false,
  nodePaths: elsewhere,
  legalComments: "none",
  logLevel: "warning",
  target: "es2022",
  charset: "ascii",
  alias: { "mmverify-package": join(packaged, "index.mjs") },
};
const text = (result) => result.outputFiles[0].text.trim();

// The worker is a text of the page, which makes a worker of it with the function under test behind it.
const worker = text(
  await esbuild.build({
    ...common,
    entryPoints: [join(here, "src/program/worker.ts")],
    format: "iife",
    // What the package does in Node.js alone is never reached.
    external: ["node:*", ...builtinModules],
    define: { "import.meta.url": '"file:///mmverify/index.mjs"' },
  }),
);
const script = text(
  await esbuild.build({
    ...common,
    entryPoints: [join(folder, "src/main.ts")],
    format: "iife",
    banner: { js: `/* ${banner} */` },
    plugins: [
      {
        name: "worker",
        setup(build) {
          build.onResolve({ filter: /^worker-text$/ }, ({ path }) => ({ path, namespace: "worker" }));
          build.onLoad({ filter: /.*/, namespace: "worker" }, () => ({ contents: worker, loader: "text" }));
        },
      },
    ],
  }),
);
const style = text(await esbuild.build({ ...common, entryPoints: [join(folder, "src/style.css")] }));
for (const [name, part] of Object.entries({ script, style }))
  if (/<\/(script|style)|<!--/i.test(part)) throw new Error(`the ${name} would end its own element`);

const hash = (part) => `'sha256-${createHash("sha256").update(part).digest("base64")}'`;
// Scripts: this one, and WebAssembly. A worker of a blob: has the function under test, and asks no network either.
const policy = [
  "default-src 'none'",
  `script-src ${hash(script)} 'wasm-unsafe-eval'`,
  `style-src ${hash(style)}`,
  // Images of a dropped file are blob:, and are fetched from there.
  images ? "img-src data: blob:; connect-src blob:" : "img-src data:",
  "worker-src blob:",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");
const program = gzipSync(readFileSync(join(packaged, "mmverify.wasm")), { level: 9 }).toString("base64");

const parts = { ...words, policy, style, program, script };
// A function, as a string would have its dollar signs read.
const page = readFileSync(join(here, "template.html"), "utf8").replace(/\{(title|description|policy|style|program|script)\}/g, (_, name) => parts[name]);
mkdirSync(dirname(out), { recursive: true });
writeFileSync(`${out}.part`, page);
renameSync(`${out}.part`, out);
const size = (n) => `${(n / 1e6).toFixed(2)} MB`;
console.log(`${out}: ${size(page.length)}, of which the program ${size(program.length)}`);
