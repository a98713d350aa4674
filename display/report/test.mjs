// Bundles the tests and runs them: node test.mjs unit|page [WING], as tests/outside/report_page_test.sh does.
// WING: whose tests/ are run; this one's where it is not given.
import { createRequire } from "node:module";
import { mkdtempSync, readdirSync, rmSync } from "node:fs";
import { spawnSync } from "node:child_process";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const elsewhere = (process.env.NODE_PATH ?? "").split(":").filter((path) => path !== "");
const require = createRequire(elsewhere.length > 0 ? join(elsewhere[0], "..", "package.json") : import.meta.url);
const esbuild = require("esbuild");

const kind = process.argv[2] === "page" ? ".page.ts" : ".test.ts";
const tests = join(resolve(process.argv[3] ?? here), "tests");
const files = readdirSync(tests).filter((name) => name.endsWith(kind));
if (files.length === 0) throw new Error(`no tests end in ${kind}`);
const out = mkdtempSync(join(tmpdir(), "mmverify-report-"));
try {
  await esbuild.build({
    entryPoints: files.map((name) => join(tests, name)),
    outdir: out,
    outExtension: { ".js": ".cjs" },
    bundle: true,
    platform: "node",
    format: "cjs",
    target: "node18",
    external: ["playwright-core"],
    nodePaths: elsewhere,
    logLevel: "warning",
  });
  const built = files.map((name) => join(out, name.replace(/\.ts$/, ".cjs")));
  const run = spawnSync(process.execPath, ["--test", ...built], {
    stdio: "inherit",
    env: { ...process.env, MMVERIFY_SOURCE: join(here, "..", ".."), NODE_PATH: [...elsewhere, join(here, "node_modules")].join(":") },
  });
  process.exitCode = run.status ?? 1;
} finally {
  rmSync(out, { recursive: true, force: true });
}
