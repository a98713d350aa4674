#!/usr/bin/env bash
# docs/BAKERS.md, "From nothing to a gate", pasted: every command of it, in order; and a baker that then goes wrong is
# red by the same commands.
# usage: tests/outside/subjects_walk_test.sh
set -euo pipefail

cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../.."
# shellcheck disable=SC2016  # the marks of code in Markdown
script=$(sed -n '/^## From nothing to a gate/,/^## Finished maps/p' docs/BAKERS.md | sed -n '/^```sh$/,/^```$/{/^```/d;p}')
[[ $(grep -c . <<<"$script") -ge 10 ]] || { echo "FAILED: docs/BAKERS.md has no walk"; exit 1; }
TMPDIR=$(mktemp -d)
export TMPDIR
trap 'rm -r "$TMPDIR"' EXIT
# The tree has the places of an installation.
export MMVERIFY=$TMPDIR/installed
mkdir -p "$MMVERIFY/bin" "$MMVERIFY/share/doc/mmverify"
ln -s "$PWD/build/release/cli/mmverify" "$MMVERIFY/bin/"
ln -s "$PWD/subjects/sdk" "$MMVERIFY/include"
ln -s "$PWD/examples" "$MMVERIFY/share/doc/mmverify/"
# shellcheck disable=SC2016
bash -euo pipefail -c "$script"$'\npwd >"$TMPDIR/folder"' >"$TMPDIR/log" 2>&1 || { cat "$TMPDIR/log"; echo "FAILED: the walk"; exit 1; }
grep -E 'results: |gate: green' "$TMPDIR/log"

# Then T and O are told apart by one texel of each micro-triangle: the walk's last two commands, which hold the baker to
# its baseline, are red.
export PATH=$MMVERIFY/bin:$PATH
cd "$(cat "$TMPDIR/folder")"
sed -i 's/if (all != some) return/if (0) return/' mine.c
cc -O2 -ffp-contract=off -shared -fPIC -I "$MMVERIFY/include" -o mine.so mine.c -lm
again=$(grep '^mmverify ' <<<"$script" | tail -2)
[[ $again == "mmverify prove "*$'\n'"mmverify gate "* ]] || { echo "FAILED: the walk does not end with a proof and its gate"; exit 1; }
code=0
bash -uo pipefail -c "$again"$'\nexit $?' >"$TMPDIR/log" 2>&1 || code=$?
if ((code != 1)) || ! grep -q '^worse .*verdict checked -> refuted\|^worse .*verdict proved -> refuted' "$TMPDIR/log"; then
  tail -20 "$TMPDIR/log"
  echo "FAILED: a baker that has gone wrong gives exit code $code"
  exit 1
fi
echo "a baker that has gone wrong is red"
