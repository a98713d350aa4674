#!/usr/bin/env bash
# The page of page/: types, unit tests, and the page itself in a headless Chromium, opened from disk, offline.
# usage: tests/outside/page_test.sh MMVERIFY PACKAGE HOME
#   PACKAGE: the folder of mmverify's npm package, with mmverify.wasm      HOME: a folder for npm's packages and the page
# Exit code 77: skipped, and why.
set -euo pipefail

(($# == 3)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
program=$(readlink -f -- "$1") package=$(readlink -m -- "$2") home=$(readlink -m -- "$3")
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/pages.sh"
packages_in "$home"
export NODE_PATH=$home/node_modules

node "$root/display/report/types.mjs" "$home/node_modules/mmverify"
"$home/node_modules/.bin/tsc" --project "$root/display/page" --typeRoots "$home/node_modules/@types" --paths null --baseUrl "$home/node_modules"
node "$root/display/report/test.mjs" unit "$root/display/page"

[[ -f $package/mmverify.wasm ]] || skip "$package has no mmverify.wasm: emscripten makes it, ./run page builds it"
find_chromium page-test
node "$root/display/page/build.mjs" "$package" "$home/mmverify.html"
MMVERIFY_PAGE=$home/mmverify.html MMVERIFY_PROGRAM=$program CHROMIUM=$chromium node "$root/display/report/test.mjs" page "$root/display/page"
