#!/usr/bin/env bash
# Every harness has seeds, every folder of seeds a harness, and two runs of the generators write the same bytes.
# usage: tests/outside/corpora_test.sh
set -euo pipefail

(($# == 0)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../../fuzz"
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

./write-seeds "$folder/first"
./write-seeds "$folder/second"
diff -rq "$folder/first" "$folder/second"
for generator in corpus/make_*.py; do
  code=0
  python3 -B "$generator" 2>/dev/null || code=$?
  ((code == 2)) || { echo "FAILED: $generator without a folder: exit code $code"; exit 1; }
done
for harness in "$folder/first"/*; do
  [[ -n $(find "$harness" -type f -print -quit) ]] || { echo "FAILED: ${harness##*/} has no seeds"; exit 1; }
done
diff <(printf '%s\n' "$folder/first"/* | sed 's|.*/||') <(grep -l LLVMFuzzerTestOneInput ./*.cpp | grep -v replay_main | sed 's|.*/||; s|[.]cpp$||' | LC_ALL=C sort) || {
  echo "FAILED: seeds without a harness (<), or a harness without seeds (>)"
  exit 1
}
find "$folder/first" -type f | wc -l | sed 's/$/ seeds, the same in two runs/'
