#!/usr/bin/env bash
# Scripts of JavaScript under test: the numbers that they are judged in, in the npm package and on the page; without
# WebAssembly, so that each change has it.
# usage: tests/outside/script_test.sh HOME        HOME: where display/report/packages has put acorn and esbuild, if it has
# Exit code 77: skipped, and why.
set -euo pipefail

(($# == 1)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
home=$(readlink -m -- "$1")
root=$(readlink -f -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../..")
command -v node >/dev/null || { echo "skipped: no Node.js: ./run install node"; exit 77; }
[[ -d $home/node_modules/acorn && -d $home/node_modules/esbuild ]] || {
  echo "skipped: $home has no acorn or no esbuild: npm's registry did not answer; ./run build asks again"
  exit 77
}
MMVERIFY_NPM=$home node --test "$root"/delivery/wasm/tests/script.test.mjs
NODE_PATH=$home/node_modules node "$root/display/report/test.mjs" unit "$root/display/page"
