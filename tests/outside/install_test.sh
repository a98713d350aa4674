#!/usr/bin/env bash
# The installed tree serves a project of someone else's: find_package, pkg-config, a proof of its index function.
# usage: tests/outside/install_test.sh BUILD_FOLDER [C_COMPILER CXX_COMPILER]
set -euo pipefail

(($# == 1 || $# == 3)) || { sed -n 's/^# usage: /usage: /p' "$0" >&2; exit 2; }
build=$(readlink -f -- "$1")
export CC=${2:-cc} CXX=${3:-c++}
tests=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
fail() { echo "FAILED: $*"; exit 1; }

# A build of other targets, such as ./run prove makes, installs nothing: it says what is missing.
mkdir "$folder/partly"
sed "s|$build/cli/mmverify\"|$build/cli/no-mmverify\"|" "$build/cmake_install.cmake" >"$folder/partly/cmake_install.cmake"
! cmake -D CMAKE_INSTALL_PREFIX="$folder/partly/installed" -P "$folder/partly/cmake_install.cmake" >"$folder/install.log" 2>&1 ||
  fail "a build without the program is installed"
grep -q 'not built' "$folder/install.log" && grep 'cli/no-mmverify' "$folder/install.log"
[[ ! -e $folder/partly/installed ]] || fail "half of a build is installed"
DESTDIR='' cmake --install "$build" --prefix "$folder/installed" >"$folder/install.log" || { cat "$folder/install.log"; exit 1; }
"$folder/installed/bin/mmverify" --version
for described in man/man1/mmverify.1 bash-completion/completions/mmverify zsh/site-functions/_mmverify fish/vendor_completions.d/mmverify.fish; do
  grep -q -- validate "$folder/installed/share/$described" || fail "no share/$described, or not this program's"
done

# Each link of an installed document leads to an installed file, and the manual page names no other document.
"$tests/installed_links.py" "$folder/installed/share/doc/mmverify" "$folder/installed/share/man/man1/mmverify.1" ||
  fail "links of installed documents"

# As the user's project: the example's source is theirs.
cp -r "$tests/consumer" "$folder/consumer"
cp "$tests/../../examples/subject/subject.c" "$folder/consumer/my_index.c"
cmake -S "$folder/consumer" -B "$folder/consumer/build" -D CMAKE_PREFIX_PATH="$folder/installed" >"$folder/configure.log" ||
  { cat "$folder/configure.log"; exit 1; }
cmake --build "$folder/consumer/build" >"$folder/build.log" || { cat "$folder/build.log"; exit 1; }
ctest --test-dir "$folder/consumer/build" --output-on-failure --no-tests=error --output-junit "$folder/ctest.xml"
grep -q 'testcase name="my_index_is_right"' "$folder/ctest.xml" || fail "ctest's JUnit file has no such test"
[[ -s $folder/consumer/build/my_index_is_right.xml ]] || fail "the proof left no JUnit file"

# The gate on that proof: green on itself, red once the function is wrong.
gate=("$folder/installed/bin/mmverify" gate --baseline "$folder/baseline.json" "$folder/consumer/build/my_index_is_right.json")
"${gate[@]}" --bless
"${gate[@]}"
sed -i 's/uf + vf could/&/; s/if (j > n - 1) j = n - 1;/if (level == 8 \&\& j == 3) i ^= 1;/' "$folder/consumer/my_index.c"
cmake --build "$folder/consumer/build" >"$folder/build.log" || { cat "$folder/build.log"; exit 1; }
! ctest --test-dir "$folder/consumer/build" -R my_index >"$folder/ctest.log" || fail "a wrong index function passes"
code=0
"${gate[@]}" >"$folder/gate.log" || code=$?
((code == 1)) || fail "the gate on a wrong index function gives exit code $code"
grep 'verdict proved -> refuted' "$folder/gate.log"

# A project of language C: the C compiler links, by CMake and by pkg-config.
mkdir "$folder/of_c"
cp "$tests/consumer/uses_the_c_face.c" "$folder/of_c"
cat >"$folder/of_c/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(of_c LANGUAGES C)
find_package(mmverify REQUIRED)
add_executable(uses_the_c_face uses_the_c_face.c)
target_link_libraries(uses_the_c_face PRIVATE mmverify::impl)
CMAKE
{ cmake -S "$folder/of_c" -B "$folder/of_c/build" -D CMAKE_PREFIX_PATH="$folder/installed" && cmake --build "$folder/of_c/build"; } \
  >"$folder/build.log" 2>&1 || { cat "$folder/build.log"; exit 1; }
"$folder/of_c/build/uses_the_c_face"

# Without Highway all but the library is there, and an error names it.
mkdir "$folder/without"
cp "$tests/../../examples/subject/subject.c" "$folder/without/my_index.c"
cat >"$folder/without/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(without LANGUAGES C CXX)
find_package(mmverify REQUIRED)
if(mmverify_impl_FOUND)
  message(FATAL_ERROR "mmverify::impl is there")
endif()
enable_testing()
add_library(my_index MODULE my_index.c)
target_link_libraries(my_index PRIVATE mmverify::subject)
mmverify_add_proof(my_index_is_right SUBJECT my_index LAWS index.in_range LEVELS 0..2)
CMAKE
without_highway() {
  PKG_CONFIG_LIBDIR=/nowhere cmake -S "$folder/without" -B "$folder/without/build" -D CMAKE_PREFIX_PATH="$folder/installed" \
    -D CMAKE_DISABLE_FIND_PACKAGE_hwy=ON >"$folder/configure.log" 2>&1
}
without_highway || { cat "$folder/configure.log"; exit 1; }
cmake --build "$folder/without/build" >"$folder/build.log" || { cat "$folder/build.log"; exit 1; }
ctest --test-dir "$folder/without/build" --no-tests=error | tail -1
cp "$folder/without/CMakeLists.txt" "$folder/fine.txt"
for use in 'add_executable(uses my_index.c)\ntarget_link_libraries(uses PRIVATE mmverify::impl)' \
  'find_package(mmverify REQUIRED COMPONENTS impl)'; do
  echo -e "$use" >>"$folder/without/CMakeLists.txt"
  ! without_highway || fail "without Highway CMake takes: $use"
  grep -i 'needs.highway' "$folder/configure.log" || { cat "$folder/configure.log"; fail "the error does not name Highway"; }
  cp "$folder/fine.txt" "$folder/without/CMakeLists.txt"
done
# A keyword that an unset variable left without its value would judge less than was asked.
for left in 'SUBJECT my_index LAWS LEVELS 0..2' 'SUBJECT my_index LAWS index.in_range LEVELS' 'LAWS index.in_range' \
  'SUBJECT no_target LAWS index.in_range'; do
  sed -i "s/(my_index_is_right .*)/(my_index_is_right $left)/" "$folder/without/CMakeLists.txt"
  PKG_CONFIG_LIBDIR=/nowhere cmake "$folder/without/build" >"$folder/configure.log" 2>&1 && fail "mmverify_add_proof takes $left"
  grep 'mmverify_add_proof(NAME SUBJECT TARGET' "$folder/configure.log"
done

# By pkg-config.
PKG_CONFIG_PATH=$(dirname "$(find "$folder/installed" -name mmverify.pc)")
export PKG_CONFIG_PATH
read -ra flags < <(pkg-config --cflags --libs mmverify)
"$CXX" -std=c++20 "$tests/consumer/uses_the_library.cpp" -o "$folder/by_pkg_config" "${flags[@]}"
"$folder/by_pkg_config"
read -ra of_c < <(pkg-config --static --cflags --libs mmverify)
"$CC" "$tests/consumer/uses_the_c_face.c" -o "$folder/by_pkg_config" "${of_c[@]}"
"$folder/by_pkg_config"

# Each installed header stands by itself, and docs/API.md offers them all and no other.
(cd "$folder/installed/include" && find mmverify -name '*.h' -o -name '*.hpp') | LC_ALL=C sort >"$folder/headers"
grep -oE '<mmverify/[a-z0-9_/]*\.hp*>' "$(find "$folder/installed" -name API.md)" | tr -d '<>' | LC_ALL=C sort -u >"$folder/offered"
diff "$folder/headers" "$folder/offered" || fail "installed (<) is not what docs/API.md offers (>)"
while read -r header; do
  echo "#include <$header>" >"$folder/alone.cpp"
  "$CXX" -std=c++20 -fsyntax-only "${flags[@]}" "$folder/alone.cpp" || fail "$header does not stand by itself"
done <"$folder/headers"
grep -rq '"impl/' "$folder/installed/include" && fail "an installed header includes impl/"

# The installed program finds the worker that a library is run in.
code=0
"$folder/installed/bin/mmverify" prove index.equals_reference --levels 8 --quiet --no-mutants \
  --subject "$folder/consumer/build/libmy_index.so" >"$folder/prove.log" || code=$?
((code == 1)) || fail "the installed program on a wrong index function gives exit code $code"
tail -1 "$folder/prove.log"
