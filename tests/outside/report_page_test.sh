#!/usr/bin/env bash
# The page of mmverify report: types, unit tests, and the page itself in a headless Chromium, opened from disk, offline.
# usage: tests/outside/report_page_test.sh MMVERIFY HOME        HOME: a folder for the packages of npm; exit code 77: skipped, and why
set -euo pipefail

(($# == 2)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
program=$(readlink -f -- "$1") home=$(readlink -m -- "$2")
source "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/pages.sh"
report=$root/display/report
packages_in "$home"
export NODE_PATH=$home/node_modules
said=$("$program" report /dev/null -o /dev/null 2>&1 || true)
[[ $said != *'built without its page'* ]] || skip "$said"

node "$report/types.mjs" "$home/node_modules/mmverify"
"$home/node_modules/.bin/tsc" --project "$report" --typeRoots "$home/node_modules/@types" --paths null --baseUrl "$home/node_modules"
node "$report/test.mjs" unit

find_chromium report-test
MMVERIFY_PROGRAM=$program CHROMIUM=$chromium node "$report/test.mjs" page
