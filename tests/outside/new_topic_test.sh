#!/usr/bin/env bash
# [night] A new topic is what CONTRIBUTING.md says: its own folders, and a row in few files that exist.  The toy of
# tests/outside/toy is added to a clone, built, proved, and refutes a wrong library.
# usage: new_topic_test.sh [BUILD OPTION...]
set -euo pipefail
root=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../..
most=8
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }

git clone --quiet --no-hardlinks "$root" "$folder/house"
cd "$folder/house"
cp -r tests/outside/toy/{spec,impl,proofs} .
python3 tests/outside/toy/rows.py .
changed=$(git diff --name-only | wc -l)
((changed <= most)) || fail "$changed files that exist are changed, at most $most may be: $(git diff --name-only)"
git diff --name-only | while read -r name; do
  grep -qF "\`$name\`" CONTRIBUTING.md || fail "the recipe of CONTRIBUTING.md does not name $name"
done

cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DMMVERIFY_BRIEF=ON "$@" >configure.log || { tail -20 configure.log; fail "cmake"; }
ninja -C build cli/mmverify-prove mmverify-worker >build.log || { tail -30 build.log; fail "the toy does not compile"; }
build/cli/mmverify-prove prove toy --quiet >proved.txt || { cat proved.txt; fail "the toy is not proved"; }
grep -q '^proved *toy.doubles' proved.txt || { cat proved.txt; fail "toy.doubles is not proved"; }
scripts/check-arrows || fail "check-arrows"
scripts/check-laws-named build/cli/mmverify-prove || fail "check-laws-named"

cc -std=c11 -shared -fPIC -I. tests/outside/toy/wrong.c -o wrong.so
code=0
build/cli/mmverify-prove prove toy --subject ./wrong.so --quiet >refuted.txt || code=$?
((code == 1)) && grep -q '7' refuted.txt || { cat refuted.txt; fail "exit code $code for a wrong library, not 1"; }
echo "a new topic: $changed files that exist are changed"
