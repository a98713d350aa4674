#!/usr/bin/env bash
# examples/device as its user builds it: without a device it says what is missing; on the stand-in of tests/outside/device
# every hit agrees and the Khronos validation layer says nothing; faults planted in the stand-in and in the program are seen.
# usage: tests/outside/device_test.sh [--brief] MMVERIFY STAND_IN.so CXX_COMPILER
# --brief: without the faults that are planted in the program, each of which builds it again.
set -euo pipefail

brief=
[[ ${1:-} != --brief ]] || { brief=1; shift; }
(($# == 3)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
mmverify=$(readlink -f -- "$1") stand_in=$(readlink -f -- "$2")
export CXX=$3
tests=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"
fail() { echo "FAILED: $*"; cat out; exit 1; }
for tool in glslangValidator cmake; do
  command -v "$tool" >/dev/null || { echo "skipped: no $tool"; exit 77; }
done

cp -r "$tests/../../examples/device" source
built() {
  { cmake -S source -B build -D CMAKE_BUILD_TYPE=Release \
    -D CMAKE_CXX_FLAGS='-Wall -Wextra -Wpedantic -Wconversion -Werror' && cmake --build build; } >out 2>&1
}
built || fail "examples/device does not build"
"$mmverify" vectors -o vectors --family index,corners >out || fail "no vectors"
vectors=vectors/mmverify_vectors.bin

# said CODE PATTERN ARGUMENT...: the program ends with that code and prints the pattern.
said() {
  local code=0
  build/device_rays "${@:3}" >out 2>&1 || code=$?
  ((code == $1)) || fail "exit code $code, not $1: device_rays ${*:3}"
  grep -qE -- "$2" out || fail "no line with: $2"
}

# Usage and bad files.
said 0 '^Exit codes: 0' --help
said 2 'the file of vectors is missing'
said 2 '17: not a whole number from 0 to 16' $vectors --levels 0..17
said 2 'the last level is below the first' $vectors --levels 4..3
said 2 '0.7: not a number' $vectors --error 0.7
said 2 '--fast: no such option' $vectors --fast 1
said 4 'no/such: it cannot be read' no/such
head -c 5000 $vectors >cut
said 4 'cut: not the whole of a mmverify_vectors.bin' cut
"$mmverify" vectors -o other --family vq >out || fail "no vectors"
said 4 'no index.points; mmverify vectors --family index,corners writes it' other/mmverify_vectors.bin

# Without a device.
export VK_ICD_FILENAMES=$folder/no_driver.json
said 5 'no Vulkan driver is installed|Vulkan has no device here' $vectors
for driver in /usr/share/vulkan/icd.d/lvp_icd.*.json; do
  [[ -e $driver ]] || { echo "left out: no lavapipe"; continue; }
  VK_ICD_FILENAMES=$driver said 5 'no device 7: Vulkan has 1' $vectors --device 7
  VK_ICD_FILENAMES=$driver said 5 '0  llvmpipe .*: lacks .*VK_EXT_opacity_micromap' $vectors
  sed -n 2p out
done

# On the stand-in.
printf '{"file_format_version": "1.0.0", "ICD": {"library_path": "%s", "api_version": "1.3.239"}}\n' "$stand_in" >stand_in.json
export VK_ICD_FILENAMES=$folder/stand_in.json
validate=
if [[ -e /usr/share/vulkan/explicit_layer.d/VkLayer_khronos_validation.json ]]; then
  validate=--validate
  # The layer of Vulkan 1.3.239 takes this extension of SPIR-V for unknown; spirv-val and the stand-in judge the shader.
  export VK_LAYER_MESSAGE_ID_FILTER=VUID-VkShaderModuleCreateInfo-pCode-04146
else
  echo "left out: no Khronos validation layer"
fi
said 0 '^agrees  all of [0-9]{5} hits$' $vectors $validate
! grep -q 'validation layer' out || fail "the validation layer has a message"
grep -q '^levels  2-state 0..12, 4-state 0..9$' out || fail "levels of the stand-in"
grep -q ' 0 a neighbour.s, 0 neither$' out || fail "ties"
cat out
said 0 '^levels  2-state 11..12$' $vectors --levels 11..12
said 4 'no hit was judged' $vectors --levels 13..16
if command -v spirv-val >/dev/null; then
  glslangValidator --target-env vulkan1.2 -o rays.spv source/rays.comp >out && spirv-val --target-env vulkan1.2 rays.spv ||
    fail "the shader is not valid"
fi

# Faults of the device, and the first hit that shows each.
while read -r fault first; do
  DEVICE_STAND_IN_FAULT=$fault said 1 "$first" $vectors --levels 0..9
  printf 'seen: %s: %s\n' "$fault" "$(sed -n '1p;2s/.*: / /p' out | tr -d '\n')"
done <<'FAULTS'
exchanged expected micro-triangle 2; got 3
rows expected micro-triangle 1; got 2
half_precision level [789], .*expected micro-triangle
drift level [789], .*expected micro-triangle
specials a triangle with special index -3$
bit_order expected T; got O
forced got no state: a candidate, forced to two states a candidate
base expected micro-triangle 0
reported differs in barycentrics alone
unwritten got no state: no answer
FAULTS
DEVICE_STAND_IN_FAULT=no_extension said 5 '0  stand-in: lacks VK_EXT_opacity_micromap$' $vectors
DEVICE_STAND_IN_FAULT=no_feature said 5 '0  stand-in: lacks feature micromap$' $vectors
[[ -z $brief ]] || exit 0

# Faults of the program's calls.
# planted FILE SCRIPT PATTERN: a change that the stand-in or the layer has to see.
planted() {
  cp "source/$1" kept
  sed -i "$2" "source/$1"
  ! cmp -s "source/$1" kept || fail "nothing to plant: $2"
  built || fail "it does not build: $2"
  said 4 "$3" $vectors --levels 0..4 $validate
  printf 'seen: %s\n' "$(grep -m1 -oE "$3" out)"
  mv kept "source/$1"
  touch "source/$1"
}
planted structures.cpp 's/job[.]geometry_counts/job.array_counts/' 'stand-in: the usage counts of the geometry are not its .*'
planted structures.cpp 's/(job[.]array_counts/(job.geometry_counts/; s/= job[.]array_counts/= job.geometry_counts/' \
  'stand-in: (the usage counts of the micromap|triangle 0 refers to record) .*'
planted structures.cpp 's/triangleArrayStride = .*/triangleArrayStride = 8;/' 'stand-in: record [0-9]+ has format .*'
planted structures.cpp 's/indexType = job.index_type/indexType = VK_INDEX_TYPE_UINT32/' 'stand-in: triangle [01] (refers to record|has index) .*'
planted structures.cpp 's/indexStride = .*/indexStride = 2 * job.index_stride;/' 'stand-in: indices are read beyond .*'
planted structures.cpp 's/baseTriangle = job.base/baseTriangle = 0/' 'stand-in: the usage counts of the geometry .*'
planted structures.cpp 's/VK_ACCESS_2_MICROMAP_READ_BIT_EXT/VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR/' \
  'stand-in: the geometry is built before its micromap is visible'
planted rays.comp '/^spirv_instruction/d; s/declared(gl_RayFlags\(.*\)EXT)/gl_RayFlags\1EXT/' 'stand-in: the shader forces micromaps .*'
if [[ -n $validate ]]; then
  planted structures.cpp \
    '/^  build_scene();/,/^}/s/VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR/VK_ACCESS_2_MICROMAP_READ_BIT_EXT/' \
    'validation layer: .*VK_ACCESS_2_MICROMAP_READ_BIT_EXT is not supported by stage mask'
fi
