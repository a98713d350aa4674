#!/bin/bash -eu
# Fetches into $SRC what the fuzz targets are built from besides the project: the releases of Debian 12, which all else
# here is tested with. Sources, and for build.sh alone: a library of the image's distribution may be of another C++
# standard library, and is not there where the targets run.
#   boost      rationals and big integers of the specification, headers
#   highway    SIMD with run-time dispatch, the one library that is compiled
#   json       headers
#   stb        images, headers
#   tinygltf   the structure of glTF files, a header
# And CMake 3.25 or later, where the image has an older one.

fetch() {  # FOLDER TAG REPOSITORY
  git clone --quiet --depth 1 --branch "$2" "$3" "$SRC/$1"
}
fetch highway 1.0.3 https://github.com/google/highway
fetch json v3.11.2 https://github.com/nlohmann/json
fetch tinygltf v2.7.0 https://github.com/syoyo/tinygltf
# It has no releases.
git clone --quiet https://github.com/nothings/stb "$SRC/stb"
git -C "$SRC/stb" checkout --quiet 8b5f1f3

mkdir -p "$SRC/boost"
curl --fail --silent --show-error --location https://archives.boost.io/release/1.81.0/source/boost_1_81_0.tar.gz |
  tar -xz -C "$SRC/boost" --strip-components=1 boost_1_81_0/boost

if ! cmake --version 2>/dev/null | grep -qE 'version (3\.(2[5-9]|[3-9][0-9])|[4-9])'; then
  curl --fail --silent --show-error --location \
    https://github.com/Kitware/CMake/releases/download/v3.29.2/cmake-3.29.2-linux-x86_64.tar.gz |
    tar -xz -C /usr/local --strip-components=1
fi
