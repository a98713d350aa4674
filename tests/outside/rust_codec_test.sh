#!/usr/bin/env bash
# prove --source of a codec in Rust: the example is proved, copies with one fault each are refuted, and a compiler that
# cannot serve is named.
# usage: tests/outside/rust_codec_test.sh MMVERIFY ROOT
set -euo pipefail

(($# == 2)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
mmverify=$(readlink -f -- "$1") root=$(readlink -f -- "$2")
command -v clang >/dev/null || { echo 'SKIPPED: no clang'; exit 77; }
[[ -x $(dirname "$mmverify")/mmverify-codec ]] || { echo 'SKIPPED: no mmverify-codec in this build'; exit 77; }
newest=$(clang --version | sed -n 's/.*clang version \([0-9]*\).*/\1/p')
found=
for compiler in "${MMVERIFY_RUSTC:-rustc}" rustc /usr/bin/rustc; do
  llvm=$("$compiler" --version --verbose 2>/dev/null | sed -n 's/^LLVM version: \([0-9]*\).*/\1/p') || continue
  if [[ -n $llvm ]] && ((llvm <= newest)); then found=$compiler; break; fi
done
[[ -n $found ]] || { echo "SKIPPED: no rustc of LLVM $newest or older (Debian 12: apt-get install rustc)"; exit 77; }
export MMVERIFY_RUSTC=$found
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"
failures=0
fail() { printf 'FAILED: %s\n' "$*"; failures=$((failures + 1)); }
codec=$root/examples/subject_rust/subject_tree.rs

# judged CODE PATTERN ARGS...: exit code, and a line of what is said.
judged() {
  local wanted=$1 pattern=$2 code=0
  shift 2
  "$mmverify" prove --quiet "$@" >said 2>&1 || code=$?
  ((code == wanted)) || { cat said; fail "$*: exit code $code, not $wanted"; }
  grep -qE -- "$pattern" said || { cat said; fail "$*: nothing said like: $pattern"; }
}
# wrong WAS IS: the codec with one place changed.
wrong() {
  python3 - "$codec" wrong.rs "$1" "$2" <<'EOF'
import sys
text = open(sys.argv[1]).read()
if text.count(sys.argv[3]) != 1:
    sys.exit(f"'{sys.argv[3]}' stands there {text.count(sys.argv[3])} times, not once")
open(sys.argv[2], "w").write(text.replace(sys.argv[3], sys.argv[4]))
EOF
}

judged 0 '^20 results: 20 proved' --source "$codec" --levels 0..1
judged 0 '^proved +tree.round_trip .* level 2, 2-state and 4-state: every map, up to 4\^16' tree.round_trip --source "$codec" --levels 2 --json right.json
grep -q 'LLVM bitcode of rustc ' right.json || fail 'the compiler is not in the result'

wrong '(1..states(level)).all' '(2..states(level)).all'
judged 1 '^refuted +tree.round_trip wrong.rs level 1' tree.round_trip --source wrong.rs --levels 1
# A panic is named where it begins, and aborts the compiled codec.
wrong 'nodes == 8 * tree.len()' 'nodes == 8 * tree.len() + 1'
judged 1 'wrong.rs:[0-9]+: core::panicking::panic_bounds_check is called, which does not return; the compiled codec ends by signal 6' tree.malformed --source wrong.rs --levels 0
wrong 'code.fill(0);' 'code.fill(64);'
judged 1 '^refuted +tree.round_trip wrong.rs level 0' tree.equals_spec tree.round_trip --source wrong.rs --levels 0

# The same as bitcode of the caller's own making.
"$found" --edition=2021 --crate-type=staticlib --emit=llvm-bc -C lto=fat -C opt-level=1 -C panic=abort -C overflow-checks=off -o own.bc "$codec"
judged 0 '^8 results: 8 proved' tree.round_trip tree.malformed --source own.bc --levels 0..1

printf 'fn' >broken.rs
judged 2 'broken.rs: rustc does not compile it' --source broken.rs
MMVERIFY_RUSTC=$folder/none judged 4 'there is no such compiler; install it' --source "$codec"
printf '#!/bin/sh\necho release: 9.9.9\necho LLVM version: 99.1\n' >new
chmod +x new
MMVERIFY_RUSTC=$folder/new judged 4 'new 9.9.9 makes bitcode of LLVM 99.1, which clang version' --source "$codec"

((failures == 0)) || { printf '%d failures\n' "$failures"; exit 1; }
echo ok
