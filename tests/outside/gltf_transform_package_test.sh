#!/usr/bin/env bash
# The npm package @mmverify/gltf-transform, packed and unpacked as a user gets it, with the real glTF-Transform; the program
# judges the files that it writes.  Then the commands of docs/GLTF_TRANSFORM.md.
# usage: tests/outside/gltf_transform_package_test.sh MMVERIFY        exit code 77: skipped, and why
set -euo pipefail

(($# == 1)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
MMVERIFY_PROGRAM=$(readlink -f -- "$1")
root=$(readlink -f -- "$(dirname -- "${BASH_SOURCE[0]}")/../..")
packages=$(readlink -m -- "${MMVERIFY_GLTF_TRANSFORM:-$root/build/gltf-transform}")
command -v python3 >/dev/null || { echo "SKIPPED: no python3"; exit 77; }
command -v npm >/dev/null || { echo "SKIPPED: no npm to pack with"; exit 77; }
"$root/scripts/npm-packages" "$root/scripts/gltf-transform" "$packages" "glTF-Transform"
MMVERIFY_FOLDER=$(mktemp -d)
trap 'rm -r "$MMVERIFY_FOLDER"' EXIT
export MMVERIFY_PROGRAM MMVERIFY_FOLDER
cd "$MMVERIFY_FOLDER"

for how in meshopt draco; do
  "$MMVERIFY_PROGRAM" scene "$root/tests/scene/files/leaf_$how.glb" --level 0 --no-laws --quiet >out 2>&1 || true
  ! grep 'built without' out || { echo "SKIPPED: the program cannot judge compressed files"; exit 77; }
done
package=$("$root/delivery/gltf-transform/pack" packed)
mkdir -p node_modules/@mmverify written
for one in "$packages"/node_modules/*; do ln -s "$one" node_modules/; done
tar -xzf "$package" -C node_modules/@mmverify
mv node_modules/@mmverify/package node_modules/@mmverify/gltf-transform
"$root/tests/outside/gltf_transform/leaves.py" .
cp -R "$root/delivery/gltf-transform/tests" .
node --test --test-reporter=spec tests/

# The document's blocks of sh, in a folder below the packages.
mkdir -p document installed/bin
ln -s "$MMVERIFY_PROGRAM" installed/bin/mmverify
script=$(sed -n '/^```sh$/,/^```$/{/^```/d;p}' "$root/docs/GLTF_TRANSFORM.md")
(($(grep -c . <<<"$script") >= 9)) || { echo "FAILED: docs/GLTF_TRANSFORM.md has no commands"; exit 1; }
(cd document && MMVERIFY=$MMVERIFY_FOLDER/installed bash -euo pipefail -c "$script") >out 2>&1 ||
  { cat out; echo "FAILED: the commands of docs/GLTF_TRANSFORM.md"; exit 1; }
for line in '^ordered.glb (gltf, draft ext-2): 0 errors' '^ordered.glb: .* triangles with maps' 'UVs moved by up to' '^baked.glb: written'; do
  grep -q -- "$line" out || { cat out; echo "FAILED: docs/GLTF_TRANSFORM.md prints no $line"; exit 1; }
done
echo "docs/GLTF_TRANSFORM.md: done"
