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
said 0 '^Exit codes:' --help
said 0 '^Exit codes:' $vectors --help
said 2 'the file of vectors is missing'
for levels in 0..13 16 5.. ..5 5...7 5..7x -1; do
  said 2 "^device_rays: --levels ${levels//./[.]}: neither A[.][.]B nor A, whole numbers from 0 to 12$" $vectors --levels $levels
done
said 2 '--levels 4..3: the last level is below the first' $vectors --levels 4..3
said 2 '--levels: its value is missing' $vectors --levels
said 2 '--device 1x: not a whole number from 0 to 1000' $vectors --device 1x
said 2 '--error 0.7: not a number' $vectors --error 0.7
for option in --fast --levels=3 -v; do said 2 "^device_rays: $option: no such option$" $vectors $option; done
said 2 'second: one file of vectors is enough' $vectors second
said 4 'no/such: it cannot be read' no/such
said 4 '^device_rays: vectors: it cannot be read$' vectors
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
  VK_ICD_FILENAMES=$driver said 5 '^device_rays: device 0, llvmpipe .*, lacks .*VK_EXT_opacity_micromap' $vectors --device 0
  VK_ICD_FILENAMES=$driver said 5 '0  llvmpipe .*: lacks .*VK_EXT_opacity_micromap' $vectors
  sed -n 2p out
done

# The stand-in drives these runs.
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
said 4 'no hit was judged' $vectors --levels 0..2 --error 0.4
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
index_stride level 2, 2-state, .*a triangle with special index -2$
both got no state: a candidate and a hit, forced to two states a hit
unwritten got no state: no answer
FAULTS
# Barycentrics that --error does not allow come first, and a larger --error allows them where they are numbers.
DEVICE_STAND_IN_FAULT=reported said 3 'first: level 1, 2-state, at u 0[.]66.* v 0[.]16.*: the device says u 0[.]16[0-9]* v 0[.]16[0-9]*$' $vectors --levels 0..9
head -n 4 out
sed -n 1p out | grep -q '^off     u or v of a judged opaque hit is off by up to 0[.]99.*, more than --error 9[.]54e-07$' || fail "the first line"
sed -n 4p out | grep -q '^agrees  all of ' || fail "the states agree"
DEVICE_STAND_IN_FAULT=shifted said 3 'is off by up to 0[.]000244, more than --error 9[.]54e-07$' $vectors --levels 0..9
grep -q '^differs ' out || fail "no state differs"
DEVICE_STAND_IN_FAULT=shifted said 0 '^agrees  all of ' $vectors --levels 0..9 --error 0x1.8p-12
DEVICE_STAND_IN_FAULT=nan said 3 '^off     u or v of a judged opaque hit is -?nan$' $vectors --levels 0..9
DEVICE_STAND_IN_FAULT=nan said 3 'first: level 1, .*: the device says u .* v -?nan$' $vectors --levels 0..9 --error 0.01
DEVICE_STAND_IN_FAULT=no_extension said 5 '0  stand-in: lacks VK_EXT_opacity_micromap$' $vectors
DEVICE_STAND_IN_FAULT=no_feature said 5 '0  stand-in: lacks feature micromap$' $vectors
DEVICE_STAND_IN_FAULT=no_feature said 5 '^device_rays: device 0, stand-in, lacks feature micromap$' $vectors --device 0
DEVICE_STAND_IN_FAULT=no_device said 5 'Vulkan has no device here' $vectors
DEVICE_STAND_IN_FAULT=enumeration said 4 '^device_rays: vkEnumeratePhysicalDevices: VkResult -1$' $vectors
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
planted structures.cpp 's/indexStride = .*/indexStride = 2 * job.index_stride;/' 'stand-in: the usage counts of the geometry .*'
planted structures.cpp 's/baseTriangle = job.base/baseTriangle = 0/' 'stand-in: the usage counts of the geometry .*'
planted structures.cpp 's/VK_ACCESS_2_MICROMAP_READ_BIT_EXT/VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR/' \
  'stand-in: the geometry is built before its micromap is visible'
planted structures.cpp 's/input_alignment = 256/input_alignment = 64/' 'stand-in: the address of the states is 64 above a multiple of 256'
planted structures.cpp '/info[.]triangleArray[.]deviceAddress/s/= /= 16 + /' 'stand-in: the address of the records is 16 above .*'
planted structures.cpp '/instances[.]data[.]deviceAddress/s/= /= 8 + /' 'stand-in: the address of instances is 8 above a multiple of 16'
planted structures.cpp '/return rounded_up/s/alignment);/1);/' 'stand-in: the address of scratch memory is 64 above .*'
planted rays.comp '/^spirv_instruction/d; s/declared(gl_RayFlags\(.*\)EXT)/gl_RayFlags\1EXT/' 'stand-in: the shader forces micromaps .*'
if [[ -n $validate ]]; then
  planted structures.cpp \
    '/^  build_scene();/,/^}/s/VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR/VK_ACCESS_2_MICROMAP_READ_BIT_EXT/' \
    'validation layer: .*VK_ACCESS_2_MICROMAP_READ_BIT_EXT is not supported by stage mask'
fi
