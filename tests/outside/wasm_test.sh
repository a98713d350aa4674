#!/usr/bin/env bash
# The package of npm: installed from its tarball as a user would, and held to the native program: the same digests, cases,
# verdicts, files and exit codes.
# usage: tests/outside/wasm_test.sh MMVERIFY TARBALL        exit code 77: skipped, and why
set -euo pipefail

(($# == 2)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
native=$(readlink -f -- "$1") tarball=$(readlink -f -- "$2")
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
for program in node npm; do
  command -v "$program" >/dev/null || { echo "skipped: no $program"; exit 77; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
failures=0
fail() {
  printf 'FAILED: %s\n' "$*"
  failures=$((failures + 1))
}
# expect CODE COMMAND...: its output lies in the file `said`.
expect() {
  local wanted=$1 code=0
  shift
  "$@" >said 2>&1 || code=$?
  ((code == wanted)) || { fail "exit code $code, not $wanted: $*"; tail -n 5 said; }
}
says() { grep -qF -- "$1" said || { fail "it does not say '$1'"; head -n 5 said; }; }

# Nothing of it is fetched: the package has no dependencies.
mkdir project
(cd project && npm install --offline --no-audit --no-fund --loglevel error "$tarball" >/dev/null)
start=$(date +%s%N)
mmverify=$folder/project/node_modules/.bin/mmverify
"$mmverify" prove index.in_range --levels 0..3 --no-mutants --quiet >/dev/null
printf 'the first verdict: %d ms after the start; the package: %s\n' $((($(date +%s%N) - start) / 1000000)) \
  "$(du -sh --apparent-size project/node_modules/mmverify | cut -f1)"

# Digests: every law that needs no prover, on small levels.
"$native" prove --quiet --no-mutants --levels 0..2 --json native.json >/dev/null || fail "native prove"
"$mmverify" prove --quiet --no-mutants --levels 0..2 --json wasm.json >/dev/null || fail "prove as WebAssembly"
python3 "$here/same_results.py" native.json wasm.json || fail "the results differ"
# Loops of encoders that a compiler once made wrong vectors of.
"$native" prove vq2.optimum vq2.effort --quiet --no-mutants --json native.json >/dev/null || fail "native vq2"
"$mmverify" prove vq2.optimum vq2.effort --quiet --no-mutants --json wasm.json >/dev/null || fail "vq2 as WebAssembly"
python3 "$here/same_results.py" native.json wasm.json || fail "the results of vq2 differ"
# Mutants: of one law a topic.
laws=(index.in_range tree.round_trip micromap.pack_round_trip dag.as_flat)
known=$("$native" list --quiet 2>/dev/null || "$native" list)
chosen=()
for law in "${laws[@]}"; do [[ $known != *"$law"* ]] || chosen+=("$law"); done
"$native" prove "${chosen[@]}" --quiet --levels 0..3 --json native.json >/dev/null || fail "native mutants"
"$mmverify" prove "${chosen[@]}" --quiet --levels 0..3 --threads 3 --json wasm.json >/dev/null || fail "mutants in threads"
python3 "$here/same_results.py" native.json wasm.json || fail "the results of three threads differ"

# JUnit and pictures: the same bytes, but for times.
"$native" prove index.in_range --levels 0..2 --quiet --junit native.xml >/dev/null
"$mmverify" prove index.in_range --levels 0..2 --quiet --junit wasm.xml >/dev/null
for file in native.xml wasm.xml; do sed -i -E 's/time="[^"]*"/time=""/g' "$file"; done
cmp native.xml wasm.xml || fail "JUnit differs"

# Scenes, findings, pipes.  What was measured is another machine's.
times='s/ +[0-9.]+ (ms|s|ns|us|thread|threads)\b/ TIME/g; s/[0-9.]+ (million micro-triangles|M)\/s//; s/ +$//'
"$native" scene -o sample.glb --quiet >/dev/null
for command in "scene sample.glb --quiet" "validate sample.glb" "gen index --level 3"; do
  # shellcheck disable=SC2086  # words of a command
  "$native" $command >native.txt 2>&1 || fail "native $command"
  # shellcheck disable=SC2086
  "$mmverify" $command >wasm.txt 2>&1 || fail "$command"
  for file in native.txt wasm.txt; do sed -i -E "$times" "$file"; done
  if ! diff native.txt wasm.txt >differences; then
    fail "mmverify $command says something else"
    head -n 10 differences
  fi
done
"$native" vectors -o native-vectors >/dev/null && "$mmverify" vectors -o wasm-vectors >/dev/null || fail "vectors"
diff -r native-vectors wasm-vectors >differences || { fail "the vectors differ"; head -n 5 differences; }
expect 4 "$mmverify" scene missing.glb
says missing.glb
expect 2 "$mmverify" prove no.such_law
expect 4 "$mmverify" prove index.in_range --subject ./mine.so --levels 0..1

# Scripts as subjects.
cat >right.mjs <<'JS'
export const name = "the published formula";
const spread = (x) => { x = (x | (x << 8)) & 0xff00ff; x = (x | (x << 4)) & 0xf0f0f0f; x = (x | (x << 2)) & 0x33333333;
  return (x | (x << 1)) & 0x55555555; };
export function index_f64(n, u, v, index) {
  for (let k = 0; k < index.length; ++k) {
    const N = 2 ** n, clamp = (x) => Math.min(Math.max(x, 0), 1);
    const a = clamp(u[k]) * N, b = clamp(v[k]) * N;
    let i = Math.floor(a), j = Math.floor(b), low = N - 1;
    const upper = a - i + (b - j) >= 1;
    i = Math.min(i, low); j = Math.min(j, low);
    if (i + j >= N) i -= i + j - N + 1;
    let iw = ~(i + j);
    if (upper && i + j < low) --iw;
    const b0 = ~(i ^ iw) & low, t = (i ^ j) & b0;
    let f = t;
    for (let s = 1; s < 16; s *= 2) f ^= f >>> s;
    index[k] = (spread(b0) | (spread(((f ^ i) & ~b0) & low | t) << 1)) >>> 0;
  }
}
JS
sed 's/>= 1;/> 1;/' right.mjs >ties.mjs
sed 's/index\[k\] = .*/throw new Error("not today");/' right.mjs >throws.mjs
sed 's/index\[k\] = .*/if (k !== 1) index[k] = 0;/' right.mjs >leaves.mjs
echo 'export const x = 1;' >nothing.mjs
# The same on floats, each operation rounded, as a shader would: what its sum misplaces shows.
sed 's/index_f64/index_f32/; s/a - i + (b - j) >= 1/1 - u[k] - v[k] <= (N - 1 - i - j) \/ N/' right.mjs >by_w.mjs
(echo 'export const arithmetic = "binary64";' && cat by_w.mjs) >in_doubles.mjs
# The formula is exact on the points of the grid, and in binary64 not on all others.
expect 0 "$mmverify" prove index.equals_reference --subject ./right.mjs --levels 0..4 --quiet --no-companions
says proved
expect 1 "$mmverify" prove index.exact_on_floats --subject ./right.mjs --levels 4 --quiet
expect 1 "$mmverify" prove index.equals_reference --subject ./by_w.mjs --levels 3 --quiet --json by_w.json
says "index.exact_on_floats"
says "./by_w.mjs: arithmetic: each operation rounded to binary32"
grep -q '"arithmetic": "each operation rounded' by_w.json || fail "the result does not say in which numbers"
"$(dirname -- "$here")/../scripts/check-schema" by_w.json >/dev/null || fail "the schema of a script's result"
expect 0 "$mmverify" prove index.equals_reference --subject ./in_doubles.mjs --levels 3 --quiet --no-companions
says "arithmetic: in binary64, as JavaScript computes"
expect 1 "$mmverify" prove index.equals_reference --subject ./ties.mjs --levels 0..4 --quiet
says refuted
expect 1 "$mmverify" prove index.equals_reference --subject ./throws.mjs --levels 1 --quiet
says "not today"
expect 1 "$mmverify" prove index.equals_reference --subject ./leaves.mjs --levels 2 --quiet
says "left its output unwritten"
expect 4 "$mmverify" prove index.equals_reference --subject ./nothing.mjs --levels 1 --quiet
says "no function of it is named as an entry point"
expect 4 "$mmverify" prove index.equals_reference --subject ./gone.mjs --levels 1 --quiet
says "no such file"

# As a module.
cat >project/module.mjs <<'JS'
import { prove, validate } from "mmverify";
import { readFileSync } from "node:fs";
const { result, code } = await prove(["index.in_range"], { levels: "0..2" });
const { result: findings } = await validate(readFileSync("../sample.glb"), "sample.glb");
console.log(code, result.schema, findings.schema, result.results.every((r) => ["proved", "checked"].includes(r.verdict)));
JS
(cd project && node module.mjs) >said
says "0 mmverify.result/1 mmverify.validate/1 true"
echo 'require("mmverify").prove(["index.in_range"], { levels: "0..2" }).then(({ code, result }) => console.log(code, result.schema));' \
  >project/old.cjs
(cd project && node old.cjs) >said
says "0 mmverify.result/1"
grep -q '^Files: inside/acorn$' project/node_modules/mmverify/THIRD_PARTY_LICENSES || fail "the package lacks the licences of what is inside"

((failures == 0)) || { printf '%d failed\n' "$failures"; exit 1; }
echo "the package does as the native program does"
