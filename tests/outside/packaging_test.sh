#!/usr/bin/env bash
# The vcpkg port and the Conan recipe, as far as a machine without vcpkg and Conan can: the port is run with stand-ins for vcpkg's
# functions, on an archive of these sources; a project of someone else's finds what it installed, links and runs it.  Of the recipe
# what it tells CMake and its users is held against that.  Compiles the library: minutes of a processor.
# usage: tests/outside/packaging_test.sh
set -euo pipefail

tests=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
root=$(readlink -f -- "$tests/../..")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
fail() { echo "FAILED: $*"; exit 1; }
cd "$root"
version=$(sed -n 's/^project(mmverify VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)
archive=$folder/mmverify-$version.tar.gz
git ls-files -z --cached --others --exclude-standard | tar --null --files-from=- --transform "s|^|mmverify-$version/|" -czf "$archive"

scripts/release/packaging "$archive" https://example.org/v"$version" "$folder/filled"
# Without vectors and unoptimised it is compiled soon; which options a port gives is what is tried here.
cmake -D PORT="$folder/filled/vcpkg/mmverify/portfile.cmake" -D ARCHIVE="$archive" -D WORK="$folder/work" \
  -D FOR_THE_TEST="-DCMAKE_BUILD_TYPE=None;-DCMAKE_CXX_FLAGS=-O0 -DHWY_COMPILE_ONLY_STATIC" -P "$tests/packaging/vcpkg.cmake" \
  >"$folder/log" 2>&1 || { tail -n 40 "$folder/log"; fail "the port"; }
packages=$folder/work/packages/mmverify
python3 -c 'import json, sys; p = json.load(open(sys.argv[1])); assert p["version"] == sys.argv[2], p' \
  "$folder/filled/vcpkg/mmverify/vcpkg.json" "$version"
for file in lib/libmmverify_impl.a share/mmverify/mmverifyConfig.cmake share/mmverify/LICENSE include/mmverify/mmverify.hpp \
  include/mmverify_subject.h; do
  [[ -s $packages/$file ]] || fail "the port installs no $file"
done
[[ ! -e $packages/bin && ! -e $packages/libexec ]] || fail "the port installs programs"

# Its user.
mkdir "$folder/user"
cp "$tests/consumer"/uses_the_* "$folder/user"
cp examples/subject/subject.c "$folder/user/my_index.c"
cat >"$folder/user/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(user LANGUAGES C CXX)
find_package(mmverify 0.2 CONFIG REQUIRED)
add_executable(uses_the_library uses_the_library.cpp)
target_link_libraries(uses_the_library PRIVATE mmverify::impl)
add_executable(uses_the_c_face uses_the_c_face.c)
target_link_libraries(uses_the_c_face PRIVATE mmverify::impl)
add_library(my_index MODULE my_index.c)
target_link_libraries(my_index PRIVATE mmverify::subject)
if(TARGET mmverify::mmverify OR COMMAND mmverify_add_proof)
  message(FATAL_ERROR "a program was found that is not installed")
endif()
CMAKE
{ cmake -S "$folder/user" -B "$folder/user/build" -D CMAKE_PREFIX_PATH="$packages" && cmake --build "$folder/user/build"; } \
  >"$folder/log" 2>&1 || { tail -n 40 "$folder/log"; fail "a project that uses the port"; }
"$folder/user/build/uses_the_library"
"$folder/user/build/uses_the_c_face"

# An archive that is another is refused.
cp "$archive" "$folder/first.tar.gz"
echo x >>"$archive"
! cmake -D PORT="$folder/filled/vcpkg/mmverify/portfile.cmake" -D ARCHIVE="$archive" -D WORK="$folder/no" -P "$tests/packaging/vcpkg.cmake" \
  >"$folder/log" 2>&1 || fail "another archive passes"
grep -q 'the port wants SHA512' "$folder/log" || fail "another archive fails for another reason"

python3 - "$folder/filled/conan/conanfile.py" "$folder/first.tar.gz" "$packages" "$version" <<'PYTHON'
import hashlib, pathlib, re, runpy, sys, types
recipe_file, archive, packages, version = sys.argv[1:]
said = {}
class Anything:
    def __init__(self, *_): self.variables = said.setdefault("variables", {})
    def __getattr__(self, _): return lambda *a, **k: None
def get(_, url, sha256, strip_root): said.update(url=url, sha256=sha256)
def module(name, **names):
    sys.modules[name] = types.ModuleType(name)
    vars(sys.modules[name]).update(names)
module("conan", ConanFile=type("ConanFile", (), {}))
module("conan.tools")
module("conan.tools.cmake", CMake=Anything, CMakeDeps=Anything, CMakeToolchain=Anything, cmake_layout=lambda _: None)
module("conan.tools.files", copy=lambda *_: None, get=get)
module("conan.tools.gnu", PkgConfigDeps=Anything)
recipe = runpy.run_path(recipe_file)["Mmverify"]()
class Component:
    def __init__(self): self.libs, self.requires, self.properties = [], [], {}
    def set_property(self, name, value): self.properties[name] = value
class Info(Component):
    def __init__(self): super().__init__(); self.components = {"impl": Component(), "subject": Component()}
recipe.cpp_info = Info()
recipe.requires = lambda reference: said.update(requires=reference)
for step in ("requirements", "source", "generate", "package_info"): getattr(recipe, step)()
assert recipe.version == version and said["requires"].startswith("highway/")
assert said["sha256"] == hashlib.sha256(pathlib.Path(archive).read_bytes()).hexdigest()
options = set(re.findall(r"^option\((\w+)", pathlib.Path("CMakeLists.txt").read_text(), re.M))
assert said["variables"] == {"MMVERIFY_ONLY_LIBRARY": True} and set(said["variables"]) <= options, said
for library in recipe.cpp_info.components["impl"].libs:
    assert (pathlib.Path(packages) / f"lib/lib{library}.a").exists(), library
names = {c.properties["cmake_target_name"] for c in recipe.cpp_info.components.values()}
assert names == {"mmverify::impl", "mmverify::subject"}, names
PYTHON
echo "vcpkg's port by stand-ins, a project that uses it, and what the Conan recipe says"
