#!/usr/bin/env bash
# A scene with micromaps that glTF-Transform has compressed, by meshoptimizer and by Draco, with its micromaps copied as
# they were: the file is valid, the cause of its wrong maps is named, and a repair makes them right without baking.
# usage: tests/outside/gltf_transform_test.sh MMVERIFY        exit code 77: skipped, and why
set -euo pipefail

(($# == 1)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
mmverify=$(readlink -f -- "$1")
root=$(readlink -f -- "$(dirname -- "${BASH_SOURCE[0]}")/../..")
packages=${MMVERIFY_GLTF_TRANSFORM:-$root/build/gltf-transform}
command -v python3 >/dev/null || { echo "SKIPPED: no python3"; exit 77; }
"$root/scripts/npm-packages" "$root/scripts/gltf-transform" "$packages" "glTF-Transform"
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
fail() { printf 'FAILED: %s\n' "$*"; exit 1; }

"$root/tests/outside/gltf_transform/leaves.py" "$folder"

# ended CODE WHAT ARGUMENTS...: runs mmverify; its words are in `out`.
ended() {
  local wanted=$1 code=0
  shift
  "$mmverify" "$@" >"$folder/out" 2>&1 || code=$?
  ((code == wanted)) || { cat "$folder/out"; fail "$*: exit code $code, not $wanted"; }
}
cd "$folder"
ended 0 scene leaves.gltf --level 4 -o maps.glb --no-laws --quiet
ended 0 check maps maps.glb --quiet
for how in meshopt draco; do
  node "$root/scripts/gltf-transform/compressed.mjs" "$packages" "$how" maps.glb "$how.glb"
  code=0
  "$mmverify" scene "$how.glb" --level 0 --no-laws --quiet >out 2>&1 || code=$?
  if ((code == 4)) && grep -q 'built without' out; then
    echo "$how: not decoded: $(grep -m 1 'built without' out)"
    continue
  fi
  ended 0 validate "$how.glb"
  grep -q 'bake\.stale' out || { cat out; fail "$how: the record of the bake does not tell"; }
  ended 1 check maps "$how.glb" --quiet --json found.json
  python3 - found.json <<'PYTHON'
import json, sys

cause = json.load(open(sys.argv[1]))["cause"]
print(cause["says"])
assert cause["code"] == "corners+other_triangles", cause
assert cause["explained"] == cause["wrong"] > 50, cause
PYTHON
  grep -q "^next: mmverify repair $how.glb -o OUT.glb\$" out || { cat out; fail "$how: another advice"; }
  ended 0 repair "$how.glb" -o "repaired_$how.glb" --quiet
  ended 0 validate "repaired_$how.glb"
  ended 0 check maps "repaired_$how.glb" --quiet
  echo "$how: valid, diagnosed and repaired"
done
