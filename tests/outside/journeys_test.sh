#!/usr/bin/env bash
# docs/DRIVER.md, CODEC.md and CONTENT.md, pasted, by the installed program alone: their blocks of sh, in order.  The wrong
# functions in them are refuted.  Then CODEC.md's fuzzing, in the checkout, the minute cut to seconds: it finds a wrong codec.
# usage: tests/outside/journeys_test.sh [--brief] [PREFIX]     PREFIX: where it is installed; without it build/release is
# --brief: the codec at level 0 alone
set -euo pipefail

root=$(readlink -f -- "$(dirname -- "${BASH_SOURCE[0]}")/../..")
brief=${1-}
[[ $brief != --brief ]] || shift
TMPDIR=$(mktemp -d)
export TMPDIR
trap 'rm -r "$TMPDIR"' EXIT
fail() { echo "FAILED: $*"; exit 1; }
export MMVERIFY=${1:-$TMPDIR/installed}
[[ -n ${1-} ]] || DESTDIR='' cmake --install "$root/build/release" --prefix "$MMVERIFY" >"$TMPDIR/log" || { cat "$TMPDIR/log"; exit 1; }

block() { # PAGE KIND: its blocks of code of that kind
  sed -n "/^\`\`\`$2\$/,/^\`\`\`\$/{/^\`\`\`/d;p}" "$root/docs/$1.md"
}
# journey PAGE LINES-OF-OUTPUT...
journey() {
  local page=$1 script
  script=$(block "$page" sh)
  (($(grep -c . <<<"$script") >= 9)) || fail "docs/$page.md has no journey"
  [[ $brief != --brief ]] || script=${script//--levels 0..1/--levels 0}
  bash -euo pipefail -c "$script" >"$TMPDIR/log" 2>&1 || { cat "$TMPDIR/log"; fail "docs/$page.md"; }
  shift
  for line in "$@"; do
    grep -q -- "$line" "$TMPDIR/log" || { cat "$TMPDIR/log"; fail "docs/$page.md prints no $line"; }
    [[ $line != *wrong.so* ]] || grep -qF -- "${line#^}" "$root/docs/$page.md" || fail "docs/$page.md does not show: $line"
  done
  echo "docs/$page.md: done"
}
journey DRIVER '^subject ./mine.so: nothing is refuted' '^subject ./wrong.so: refuted (5 laws refuted, 3 proved)' \
  '^proved *index.equals_reference' '^proved *traverse.decision' '^gate: green'
journey CODEC '^subject ./codec.so: nothing is refuted' '^subject ./wrong.so: refuted (3 laws refuted, 7 proved, 2 checked)' '^gate: green'
journey CONTENT '^leaves.glb (gltf' 'laws  *[0-9]* proved' '^leaves.glb: right already' '^gate: green'

cd "$TMPDIR"
cp "$root/examples/subject_tree/subject_tree.c" codec.c
fuzzing=$(block CODEC bash | sed "s|subjects/sdk|$root/subjects/sdk|; s|\./run fuzz subject 60|$root/run fuzz subject 2|")
[[ $fuzzing == *"fuzz subject 2" ]] || fail "docs/CODEC.md does not fuzz"
bash -euo pipefail -c "$fuzzing" >log 2>&1 || { cat log; fail "the fuzzing of docs/CODEC.md"; }
sed -i "s/if (get(code + tree_bytes, 1, t)) return 0/if (0) return 0/" codec.c
code=0
bash -euo pipefail -c "$fuzzing" >log 2>&1 || code=$?
((code == 1)) && grep '^fuzz_subject: tree.malformed' log || { tail -20 log; fail "fuzzing a wrong codec gives exit code $code"; }
