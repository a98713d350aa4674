#!/usr/bin/env bash
# prove index.floats --source: functions that are wrong on a few pairs are refuted, by pairs on which the compiled function
# is wrong; what cannot be judged is named.
# usage: tests/outside/source_test.sh MMVERIFY ROOT [--every]    --every: proves the right one, too, which takes minutes
set -euo pipefail

(($# >= 2)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
mmverify=$(readlink -f -- "$1") root=$(readlink -f -- "$2")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"
wrong=$root/tests/subjects/wrong_source.c
failures=0
fail() { printf 'FAILED: %s\n' "$*"; failures=$((failures + 1)); }

# judged CODE PATTERN ARGS...: exit code, and a line of what is said.
judged() {
  local wanted=$1 pattern=$2 code=0
  shift 2
  "$mmverify" prove index.floats --quiet --flag="-I$root" "$@" >said 2>&1 || code=$?
  ((code == wanted)) || { cat said; fail "$*: exit code $code, not $wanted"; }
  grep -qE -- "$pattern" said || { cat said; fail "$*: nothing said like: $pattern"; }
}

judged 2 'no such file' --source missing.c
grep -q 'llvm-14-dev' said && { echo "SKIPPED: $(cat said)"; exit 77; }

for function in one_pair by_bits flushed over undefined by_product; do
  judged 1 "^refuted index.floats level 1 case u=.* expected [0-9]+ got [0-9]+" --source "$wrong" --function "$function" --levels 1
  # The line runs the compiled function again.
  again=$(sed -n 's/.*replay: mmverify //p' said | head -1)
  code=0
  eval "\"\$mmverify\" $again" >again 2>&1 || code=$?
  if [[ $function == undefined ]]; then
    grep -q 'undefined: lshr: a shift too far' said || { cat said; fail "undefined: the cause is not named"; }
  elif ((code != 1)) || ! grep -q '^refuted index.floats level 1' again; then
    cat said again
    fail "$function: its counterexample does not show again"
  fi
  printf '%s: %s\n' "$function" "$(grep -o 'case u=.*replay' said | head -1)"
done

judged 2 'wrong_source.c:[0-9]+: (br|switch): a loop that no constant ends' --source "$wrong" --function endless --levels 1
judged 2 'wrong_source.c:[0-9]+: load: memory is no constant' --source "$wrong" --function remembers --levels 1
judged 2 "no function is called 'index_off'; there are: .*right" --source "$wrong" --function index_off
judged 2 "'no_index' is float \(float, float\); due is uint32_t \(uint32_t level, float u, float v\)" --source "$wrong" --function no_index
judged 2 'index.floats is proved of a source, and nothing else' index.nested --source "$wrong"
printf 'unsigned index_of(unsigned level, float u, float v) { return leve; }\n' >typo.c
judged 2 "typo.c:1:[0-9]+: error: use of undeclared identifier 'leve'" --source typo.c
MMVERIFY_CLANG=no-clang judged 2 'no-clang: there is no such compiler; install the Debian package clang' --source "$wrong" --function right
MMVERIFY_SOURCE_READER=$folder/none judged 2 'none: there is no program of that name|llvm-14-dev' --source "$wrong" --function right

if [[ ${3-} == --every ]]; then
  judged 0 '^proved \(bit vectors\) index.floats .* level 0 ' --source "$wrong" --function right --levels 0
  judged 0 '^proved \(bit vectors\) index.floats .* level 0 ' --source "$root/examples/subject/subject.c" --levels 0
fi
((failures == 0)) || { echo "$failures failed"; exit 1; }
echo 'source_test: all refuted and named'
