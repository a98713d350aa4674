#!/usr/bin/env bash
# ./run implementations: of two checkouts of one shape the right one passes and the wrong one is refuted, with a case that
# replays; what is unknown, missing or does not build is named, and no document is left half-written.
# usage: tests/outside/implementations_test.sh MMVERIFY ROOT
set -euo pipefail

(($# == 2)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
command -v git >/dev/null || { echo "SKIPPED: no git"; exit 77; }
mmverify=$(readlink -f -- "$1") root=$(readlink -f -- "$2")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"
fail() { printf 'FAILED: %s\n' "$*"; exit 1; }

# checkout FOLDER FLIP: one that has BaryFile's files and functions, and the example's orders behind them.  FLIP is in
# which of two micro-triangles a face of the curve is.
checkout() {
  mkdir -p "$1/include/bary" "$1/include/baryutils" "$1/src"
  : >"$1/include/baryutils/baryutils.h"
  cat >"$1/include/bary/bary_core.h" <<'TEXT'
#pragma once
#include <cstdint>
namespace bary {
enum class ValueLayout { eUndefined, eTriangleUmajor, eTriangleBirdCurve };
enum class ValueFrequency { eUndefined, ePerVertex, ePerTriangle };
uint32_t baryValueLayoutGetIndex(ValueLayout layout, ValueFrequency of, uint32_t u, uint32_t v, uint32_t upper,
                                 uint32_t level);
}  // namespace bary
TEXT
  cat >"$1/src/bary_core.cpp" <<TEXT
#include "bary/bary_core.h"
#define mmverify_subject_v1 orders_of_the_example
#include "$root/examples/subject_attribute/subject_attribute.c"
uint32_t bary::baryValueLayoutGetIndex(ValueLayout layout, ValueFrequency of, uint32_t u, uint32_t v, uint32_t upper,
                                       uint32_t level) {
  const bool bird = layout == ValueLayout::eTriangleBirdCurve;
  uint32_t index = 0;
  if (of == ValueFrequency::ePerVertex) {
    vertex_index(level, bird ? MMVERIFY_VERTICES_BIRD : MMVERIFY_VERTICES_U_MAJOR, &u, &v, &index, 1);
  } else {
    face_index(level, bird ? MMVERIFY_FACES_CURVE : MMVERIFY_FACES_U_MAJOR, &u, &v, &upper, &index, 1);
    if (bird && level > 0) index ^= $2;
  }
  return index;
}
TEXT
}

# judged CODE DIR...: exit code; what is said in `said`, the document in `told.md`.
judged() {
  local wanted=$1 code=0
  shift
  timeout 60 "$root/scripts/implementations/judge" --mmverify "$mmverify" --work "$folder/work" -o told.md --law-levels 0..1 "$@" \
    >said 2>&1 || code=$?
  ((code == wanted)) || { cat said; fail "$*: exit code $code, not $wanted"; }
}
told() { grep -qE -- "$1" told.md || { cat told.md; fail "the document has nothing like: $1"; }; }
said() { grep -qE -- "$1" said || { cat said; fail "nothing said like: $1"; }; }

checkout right 0
git -C right init -q
git -C right -c user.name=a -c user.email=a@b commit -q --allow-empty -m one
git -C right tag v7.1
judged 0 right
told '^\| BaryFile .* \| v7.1 \| .* \| (proved|checked) \|'
told '^\| attribute.order_bijective \| 0 to 1 \| proved \| 0 of [1-9]'
grep -q '^mmverify replay' told.md && fail "a right one has a counterexample"
cp told.md first.md
judged 0 right
cmp first.md told.md || fail "a second run wrote something else"

checkout wrong 1
judged 1 wrong
told '^\| BaryFile .* \| unknown \| .* \| refuted \|'
replay=$(sed -n '/^mmverify replay/{:more;/\\$/{N;b more};p;q}' told.md)  # a long command has several lines
[[ -n $replay ]] || fail "a wrong one has no counterexample"
told '^\| attribute\.[a-z_]+ \| [0-9].* \| refuted \| [1-9]'
code=0
(cd "$root" && PATH=$(dirname -- "$mmverify"):$PATH && eval "$replay") >replayed 2>&1 || code=$?
((code == 1)) || { cat replayed; fail "'$replay' ended with $code"; }

# What is not judged: no document comes of it.
rm told.md
mkdir -p empty
judged 2 empty right
said 'empty: none of the implementations that are known'
said 'meshoptimizer: has src/opacitymap.cpp'
judged 2 missing
said 'missing: no such folder'
judged 2
said 'no DIR'
judged 2 right wrong
said 'was there already'
cp -r wrong broken
echo '#error not this time' >>broken/src/bary_core.cpp
judged 4 broken
said 'does not build, see .*baryfile.log'
grep -q 'not this time' work/baryfile.log || fail "the log does not say why"
[[ ! -e told.md && ! -e told.md.part ]] || fail "a document of nothing"

# An interrupted run leaves the document that was there.
echo before >told.md
"$root/scripts/implementations/judge" --mmverify "$mmverify" --work "$folder/work" -o told.md right >said 2>&1 &
judge=$!
for ((i = 0; i < 600; ++i)); do
  ! grep -q 'the laws' said || break
  sleep 0.1
done
kill -INT "$judge"
code=0
wait "$judge" || code=$?
((code == 3)) || { cat said; fail "interrupted: exit code $code, not 3"; }
[[ $(<told.md) == before && ! -e told.md.part ]] || fail "the document was touched"

# Adapters are short, and each has a recipe.
for adapter in "$root"/examples/adapters/*/; do
  [[ -f $adapter/recipe ]] || fail "$adapter has no recipe"
  lines=$(find "$adapter" \( -name "*.cpp" -o -name "*.hpp" \) -exec cat {} + | wc -l)
  ((lines < 60 * (1 + $(grep -lE "bake_mesh" "$adapter"*.cpp 2>/dev/null | wc -l)))) || fail "$adapter: $lines lines; 60 an entry point are too many"
done
"$root/scripts/implementations/judge" --list >listed
(($(wc -l <listed) == $(find "$root/examples/adapters" -name recipe | wc -l))) || fail "not every recipe is listed"

# A section of the document is about the arguments of builds: it has what judge --builds writes; a changed verdict is seen.
judge_builds() { "$root/scripts/implementations/judge" --builds --mmverify "$mmverify" --work "$folder/builds" "$@"; }
judge_builds --check || fail "docs/IMPLEMENTATIONS.md: scripts/implementations/judge --builds writes it anew"
sed 's/| passes |$/| finds `counts.geometry` |/' "$root/docs/IMPLEMENTATIONS.md" >changed.md
code=0
judge_builds --check -o changed.md 2>said || code=$?
((code == 1)) && grep -q "another section about builds" said || fail "a changed verdict of a build: exit code $code"
judge_builds -o changed.md && cmp changed.md "$root/docs/IMPLEMENTATIONS.md" || fail "the section is not written anew"

echo "right, wrong, unknown, missing, twice, broken and interrupted told apart"
