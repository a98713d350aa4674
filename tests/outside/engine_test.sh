#!/usr/bin/env bash
# examples/engine as an engine's author builds it, with an installed mmverify and Vulkan's own headers: what it hands to Vulkan is
# counted again by engine/check.py, which finds planted mistakes.
# usage: tests/outside/engine_test.sh BUILD_FOLDER [C_COMPILER CXX_COMPILER]
# MMVERIFY_VULKAN_HEADERS: a folder with vulkan/vulkan.h that is newer than the system's; it is tried besides.
set -euo pipefail

(($# == 1 || $# == 3)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
build=$(readlink -f -- "$1")
export CC=${2:-cc} CXX=${3:-c++}
tests=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
fail() { echo "FAILED: $*"; exit 1; }
check=$tests/engine/check.py

echo '#include <vulkan/vulkan.h>' | "$CC" -fsyntax-only -xc - 2>/dev/null ||
  { echo "skipped: no vulkan/vulkan.h; apt-get install libvulkan-dev"; exit 77; }
DESTDIR='' cmake --install "$build" --prefix "$folder/installed" >"$folder/log" || { cat "$folder/log"; exit 1; }

# made NAME [CMAKE ARGUMENT...]: the sources in $folder/NAME, built in $folder/NAME/build.
made() {
  { cmake -S "$folder/$1" -B "$folder/$1/build" -D CMAKE_PREFIX_PATH="$folder/installed" \
    -D CMAKE_C_FLAGS='-std=c11 -Wall -Wextra -Werror' -D CMAKE_CXX_FLAGS='-Wall -Wextra -Werror' "${@:2}" &&
    cmake --build "$folder/$1/build"; } >"$folder/log" 2>&1 || { cat "$folder/log"; fail "examples/engine does not build: $1"; }
}
# judged NAME: both programs of a leaf print the same, and what the check counts.
judged() {
  "$folder/$1/build/leaf_cpp" >"$folder/cpp" && "$folder/$1/build/leaf_c" >"$folder/c"
  "$check" leaf <"$folder/cpp" && diff "$folder/cpp" "$folder/c"
}
cp -r "$tests/../../examples/engine" "$folder/system"
made system
judged system || fail "the structs of the leaf"
grep KHR "$folder/cpp"
if [[ -n ${MMVERIFY_VULKAN_HEADERS:-} ]]; then
  cp -r "$tests/../../examples/engine" "$folder/newer"
  made newer -D VULKAN_HEADERS="$MMVERIFY_VULKAN_HEADERS"
  judged newer || fail "the structs of the leaf, with $MMVERIFY_VULKAN_HEADERS"
  grep KHR "$folder/cpp"
fi

# The README's lines.
{ cat <<'CPP'
#include <mmverify/mmverify.hpp>
#include <vulkan/vulkan.h>
void lines(const std::uint8_t* rgba, std::uint32_t width, std::uint32_t height, std::size_t row_bytes,
           const std::vector<mmverify::impl::bake::BaseTriangle>& triangles, std::vector<std::uint32_t> levels,
           const mmverify::impl::bake::Parallel& on_my_threads) {
CPP
  sed -n '/^```cpp$/,/^```$/p' "$tests/../../README.md" | grep -v '^```'
  echo '}'; } >"$folder/readme.cpp"
grep -q copied_as "$folder/readme.cpp" || fail 'the README has no such lines'
"$CXX" -std=c++20 -fsyntax-only -I "$folder/installed/include" "$folder/readme.cpp" || fail "the README's lines do not compile"

# Vulkan-Hpp's structs.
cat >"$folder/hpp.cpp" <<'CPP'
#include <mmverify/mmverify.hpp>
#include <vulkan/vulkan.hpp>
using namespace mmverify::impl::array;
bool right(const Built& b) {
  return copied_as<vk::MicromapTriangleEXT>(b.array.records)[0].subdivisionLevel == b.array.records[0].level &&
         copied_as<vk::MicromapUsageEXT>(b.array_counts)[0].count == b.array_counts[0].count &&
         static_cast<vk::IndexType>(index_type(Encoding::u16).vulkan) == vk::IndexType::eUint16;
}
CPP
"$CXX" -std=c++20 -fsyntax-only -I "$folder/installed/include" "$folder/hpp.cpp" || fail "Vulkan-Hpp's structs"

# A GLB of this program's.
"$folder/installed/bin/mmverify" scene --quiet --no-laws -o "$folder/scene.glb" >"$folder/log" || { cat "$folder/log"; exit 1; }
"$folder/system/build/gltf" "$folder/scene.glb" >"$folder/gltf"
"$check" gltf "$folder/scene.glb" <"$folder/gltf" || fail "the structs of the GLB"
printf 'the GLB: %s records, %s indices\n' "$(grep -c ^record "$folder/gltf")" "$(grep -c ^index "$folder/gltf")"

# Mistakes that the check has to see: one histogram for the other, a level too low, another channel, unpadded rows.
cp -r "$tests/../../examples/engine" "$folder/planted"
planted() {
  cp "$tests/../../examples/engine/leaf.cpp" "$folder/planted"
  sed -i "$1" "$folder/planted/leaf.cpp"
  ! cmp -s "$tests/../../examples/engine/leaf.cpp" "$folder/planted/leaf.cpp" || fail "nothing to plant: $1"
  made planted
  ! "$folder/planted/build/leaf_cpp" | "$check" leaf 2>"$folder/why" || fail "the check does not see: $1"
  printf 'seen: %s\n' "$(cat "$folder/why")"
}
planted 's/(\*built.geometry_counts)/(built.array_counts)/'
planted 's/LEAF_HEIGHT).level/LEAF_HEIGHT, 6).level/'
planted 's/LEAF_PITCH};/LEAF_PITCH, 4, 1};/'
planted 's/LEAF_HEIGHT, LEAF_PITCH};/LEAF_HEIGHT, 4 * LEAF_WIDTH};/'
