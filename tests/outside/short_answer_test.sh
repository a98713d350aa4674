#!/usr/bin/env bash
# The short answer of mmverify prove: at most 25 lines for any library of tests/subjects, for several topics and for many
# libraries at once; the verdict first, and a counterexample or a break for each wrong library; --details has the rest.
# usage: tests/outside/short_answer_test.sh MMVERIFY SUBJECTS [STRIDE]     STRIDE: every how manieth library; 1 where not given
set -euo pipefail

(($# >= 2)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
mmverify=$(readlink -f -- "$1") subjects=$(readlink -f -- "$2") stride=${3:-1}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"
most=25 failures=0 wrong=0
fail() { printf 'FAILED: %s\n' "$*"; failures=$((failures + 1)); }

# asked ARGS...: the answer in the file said; code=the exit code. A run that is interrupted after `limit` seconds answers as well.
limit=6
asked() {
  code=0
  timeout --preserve-status "$limit" "$mmverify" prove --no-mutants --no-companions --quiet --timeout 1 --threads 1 "$@" >said 2>complaint || code=$?
  local lines
  lines=$(wc -l <said)
  ((lines <= most)) || { cat said; fail "$*: $lines lines, more than $most"; }
}

shopt -s nullglob
libraries=("$subjects"/*.so)
((${#libraries[@]})) || { echo "FAILED: no library in $subjects"; exit 1; }
for ((k = 0; k < ${#libraries[@]}; k += stride)); do
  library=${libraries[k]}
  asked --levels 0..1 --subject "$library"
  ((code == 1)) || continue
  wrong=$((wrong + 1))
  # Warnings, and a library's words about its machine, come before.
  verdict=$(grep -vE '^(warning: |/[^ ]+: [a-z]+: )' said | head -n 1)
  [[ $verdict == "subject $library"*': '@(refuted|broken)' '* ]] || { cat said; fail "$library: the verdict is not first"; }
  grep -qE '^(refuted|broken) [a-z0-9]+\.[a-z0-9_]+ level [0-9]+' said || { cat said; fail "$library: no counterexample, no break"; }
  ! grep -q '^n/a' said || fail "$library: laws that do not apply are printed"
done
((wrong)) || fail "no library is wrong"

# Many at once.
many=()
for library in "${libraries[@]}"; do
  [[ $library == */@(hostile|bake|mesh|dag|array|large)_* ]] || ((${#many[@]} >= 40)) || many+=(--subject "$library")
done
asked --levels 0..1 index.in_range tree.round_trip "${many[@]}"

# Two topics are two subjects; a busy machine needs its time to reach the second.
limit=60
if [[ -e $subjects/c_face.so ]]; then
  asked --levels 0..1 --subject "$subjects/c_face.so"
  grep -q '^subject .*c_face.so: ' said && grep -q '^subject .*c_face.so:tree: ' said || { cat said; fail "c_face.so: a subject is not named"; }
fi

# The details are longer.
asked --subject step-appendix-ties index --levels 2
grep -q '^[0-9]* laws do not apply (--details names them)$' said || { cat said; fail "the laws that do not apply are not counted"; }
"$mmverify" prove index --subject step-appendix-ties --levels 2 --no-mutants --quiet --details >said || :
(($(grep -c '^n/a' said) > 1)) && grep -q '^           domain: ' said || fail "--details has no laws that do not apply, or no domains"
"$mmverify" prove index --subject step-appendix-ties --levels 2 --no-mutants --quiet --verbose >other || :
diff <(awk '{ print $1, $2 }' said) <(awk '{ print $1, $2 }' other) >/dev/null || fail "--verbose is not --details"

((failures == 0)) || exit 1
echo "at most $most lines; $wrong wrong libraries, each with its verdict first"
