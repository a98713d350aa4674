#!/usr/bin/env bash
# Khronos's validator finds no error in what is written: the sample scene, it with micromaps, and real scenes where there
# are any. And it finds the one that is planted here.
# usage: tests/outside/gltf_validator_test.sh WRITTEN_SCENES SCENES        exit code 77: skipped, and why
set -euo pipefail

(($# == 2)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
program=$1 scenes=$2
validate=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../../scripts/gltf-validate
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

real=()
for name in lattice_fence scatter_grove shapespark_garden; do
  [[ ! -f $scenes/$name/$name.gltf ]] || real+=("$scenes/$name/$name.gltf")
done
((${#real[@]} > 0)) || echo "no real scenes in $scenes: the sample scene alone"
"$program" "$folder" "${real[@]}"
"$validate" "$folder"/*.glb

printf '{"asset": {"version": "2.0"}, "scene": 3}' >"$folder/planted.gltf"
code=0
"$validate" "$folder/planted.gltf" || code=$?
((code == 1)) || { echo "FAILED: a planted error gave exit code $code"; exit 1; }
