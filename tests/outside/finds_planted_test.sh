#!/usr/bin/env bash
# A harness finds what was planted: it aborts, and the last line on stderr is the finding's own. Any other failure, a program
# or a library that does not load say, is not that.
# usage: tests/outside/finds_planted_test.sh PROGRAM CORPUS FINDING        FINDING: the line, an extended regular expression
set -euo pipefail

(($# == 3)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
program=$1 corpus=$2 finding=$3
log=$(mktemp)
trap 'rm "$log"' EXIT

code=0
"$program" "$corpus" >/dev/null 2>"$log" || code=$?
tail -2 "$log"
((code == 128 + 6)) || { echo "FAILED: exit code $code; a finding aborts, which is 134"; exit 1; }
tail -1 "$log" | grep -qxE -- "$finding" || { echo "FAILED: the last line is not the finding's: $finding"; exit 1; }
