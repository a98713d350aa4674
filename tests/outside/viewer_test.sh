#!/usr/bin/env bash
# The viewer of micromaps, display/viewer: types, and the page itself in a headless Chromium, opened from disk, offline.
# usage: tests/outside/viewer_test.sh MMVERIFY PACKAGE HOME
#   PACKAGE: the folder of mmverify's npm package, with mmverify.wasm      HOME: a folder for npm's packages and the page
# Exit code 77: skipped, and why.
set -euo pipefail

(($# == 3)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
program=$(readlink -f -- "$1") package=$(readlink -m -- "$2") home=$(readlink -m -- "$3")
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/pages.sh"
packages_in "$home/page"
"$root/scripts/npm-packages" "$root/display/viewer" "$home/three" "three.js"
tools=$home/page/node_modules three=$home/three/node_modules
export NODE_PATH=$tools:$three

node "$root/display/report/types.mjs" "$tools/mmverify"
cat >"$home/tsconfig.json" <<JSON
{
  "extends": "$root/display/viewer/tsconfig.json",
  "compilerOptions": { "typeRoots": ["$tools/@types"], "baseUrl": "$tools",
    "paths": { "*": ["$tools/@types/*", "$three/@types/*", "$tools/*", "$three/*"] } },
  "include": ["$root/display/viewer/src/**/*.ts", "$root/display/viewer/tests/**/*.ts", "$root/display/page/src/program/modules.d.ts"]
}
JSON
"$tools/.bin/tsc" --project "$home/tsconfig.json"

[[ -f $package/mmverify.wasm ]] || skip "$package has no mmverify.wasm: emscripten makes it, ./run viewer builds it"
find_chromium page-test
node "$root/display/page/build.mjs" "$package" "$home/viewer.html" "$root/display/viewer"
MMVERIFY_PAGE=$home/viewer.html MMVERIFY_PROGRAM=$program CHROMIUM=$chromium node "$root/display/report/test.mjs" page "$root/display/viewer"
