#!/usr/bin/env bash
# fuzz/corpus is what fuzz/make_*_corpus.py write, no seed more or less; each of its folders has a generator.
# usage: tests/outside/corpora_test.sh
set -euo pipefail

(($# == 0)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../../fuzz"
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

for generator in make_*_corpus.py; do
  python3 -B "$generator" "$folder/corpus"  # -B: nothing beside the sources
  code=0
  python3 -B "$generator" 2>/dev/null || code=$?
  ((code == 2)) || { echo "FAILED: $generator without a folder: exit code $code"; exit 1; }
done
diff -rq "$folder/corpus" corpus || {
  echo "FAILED: a seed belongs into its generator; then: for g in fuzz/make_*_corpus.py; do python3 \$g fuzz/corpus; done"
  exit 1
}
find corpus -type f | wc -l | sed 's/$/ seeds, all as their generators write them/'
