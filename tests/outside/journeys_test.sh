#!/usr/bin/env bash
# The README's three journeys, pasted: the commands between "## Three journeys" and the next heading, with the minute of
# fuzzing cut to seconds. And what each is for: a wrong function, codec and result are caught by the same commands.
# usage: tests/outside/journeys_test.sh [--brief]     --brief: the codec at levels 0..1, a tenth of the time
set -euo pipefail

cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../.."
# shellcheck disable=SC2016  # the marks of code in Markdown
script=$(sed -n '/^## Three journeys/,/^## Install it/p' README.md | sed -n '/^```sh$/,/^```$/{/^```/d;p}' | sed 's/fuzz subject 60/fuzz subject 2/')
if [[ ${1-} == --brief ]]; then
  [[ $script == *codec.so\ --levels\ 0..4* ]] || { echo "FAILED: the README proves no codec at levels 0..4"; exit 1; }
  script=${script/codec.so --levels 0..4/codec.so --levels 0..1}
fi
[[ $(grep -c . <<<"$script") -ge 10 ]] || { echo "FAILED: the README has no journeys"; exit 1; }
TMPDIR=$(mktemp -d)
export TMPDIR
trap 'rm -r "$TMPDIR"' EXIT
bash -euo pipefail -c "$script" >"$TMPDIR/log" 2>&1 || { cat "$TMPDIR/log"; echo "FAILED: the journeys"; exit 1; }
grep -E 'results: |gate: green' "$TMPDIR/log"

# The same, with an upper micro-triangle taken for a lower one, and with padding that the codec no longer looks at.
wrong=$(sed -e '/^cc .* mine.so/i sed -i "s/(upper /(level > 7 ? 0 : upper /" mine.c' \
  -e '/^clang/i sed -i "s/if (get(code + tree_bytes, 1, t)) return 0/if (0) return 0/" codec.c' <<<"$script")
caught() { # COMMAND'S BEGINNING, WORDS THAT IT SAYS
  local code=0
  bash -uo pipefail -c "$(sed "/^$1/q" <<<"$wrong")"$'\nexit $?' >"$TMPDIR/log" 2>&1 || code=$?
  if ((code != 1)) || ! grep -q "$2" "$TMPDIR/log"; then
    tail -20 "$TMPDIR/log"
    echo "FAILED: '$1' on a wrong one gives exit code $code"
    exit 1
  fi
}
caught "mmverify prove index" "^refuted index"
caught "MMVERIFY_SUBJECT" "^fuzz_subject: tree.malformed"
echo "a wrong function and a wrong codec are caught"
