#!/usr/bin/env bash
# Builds the fuzz targets as OSS-Fuzz and ClusterFuzzLite do, in a stand-in for their image, and runs each on its seeds.
#   [CC=... CXX=... SANITIZER=address|undefined] oss_fuzz_test.sh [HIGHWAY]
# HIGHWAY is a folder with Highway's source: it is then built and linked in as in the image, and no target may need a
# library that is not where they run; without it the system's is taken. The C++ standard library is the image's, libc++,
# where the compiler has one of C++20 (16 or later), else the compiler's own.
# Everything is built anew, which takes minutes: no part of ctest.
# What no stand-in shows: that the image has what Dockerfile installs, and dependencies.sh, which needs a network.
set -euo pipefail
highway=${1:+$(readlink -f -- "$1")}
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../.."
export SANITIZER=${SANITIZER:-address}

fail() {
  printf 'oss_fuzz_test: %s\n' "$*" >&2
  exit 1
}
said() { printf -- '-- %s\n' "$*"; }

shellcheck run fuzz/oss-fuzz/*.sh .clusterfuzzlite/build.sh tests/outside/oss_fuzz_test.sh
said "the scripts are clean by shellcheck"

python3 - <<'PYTHON'
import pathlib
import re
import yaml

def read(path):
    return yaml.safe_load(pathlib.Path(path).read_text(encoding="utf-8"))

project = read("fuzz/oss-fuzz/project.yaml")
for key in ("homepage", "main_repo", "primary_contact", "language", "fuzzing_engines", "sanitizers"):
    assert project.get(key), f"project.yaml: no {key}"
assert project["language"] == read(".clusterfuzzlite/project.yaml")["language"] == "c++"
for path in sorted(pathlib.Path("docs/ci").glob("cflite_*.yml")):
    workflow = read(path)
    assert True in workflow, f"{path}: no 'on'"  # YAML 1.1 reads the key `on` as a truth value
    for job in workflow["jobs"].values():
        uses = [step["uses"] for step in job["steps"]]
        assert uses == [f"google/clusterfuzzlite/actions/{name}_fuzzers@v1" for name in ("build", "run")], f"{path}: {uses}"
        for step in job["steps"]:
            sanitizers = job.get("strategy", {}).get("matrix", {}).get("sanitizer", [])
            assert set(sanitizers) <= set(project["sanitizers"]), f"{path}: {sanitizers}"
for folder, context in (("fuzz/oss-fuzz", "fuzz/oss-fuzz"), (".clusterfuzzlite", ".")):
    text = pathlib.Path(folder, "Dockerfile").read_text(encoding="utf-8")
    assert text.count("FROM gcr.io/oss-fuzz-base/base-builder") == 1
    for source in re.findall(r"^COPY (\S+) \$SRC/", text, re.MULTILINE):
        assert pathlib.Path(context, source).exists(), f"{folder}/Dockerfile copies {source}, which is not there"
PYTHON
said "project files and workflows are well-formed"

place=$(mktemp -d)
trap 'rm -rf -- "$place"' EXIT
export SRC=$place/src OUT=$place/out WORK=$place/work
mkdir -p "$SRC/mmverify" "$OUT" "$WORK"
git ls-files -z --cached --others --exclude-standard | xargs -0 -r ls -d 2>/dev/null | tar -cf - -T - | tar -xf - -C "$SRC/mmverify"

# The flags of the image, but for -Wno-error ones.
case $SANITIZER in
  address) flags="-fsanitize=address -fsanitize-address-use-after-scope" ;;
  undefined)
    checks=array-bounds,bool,builtin,enum,float-divide-by-zero,function,integer-divide-by-zero,null,object-size,return
    checks+=,returns-nonnull-attribute,shift,signed-integer-overflow,unreachable,vla-bound,vptr
    # There the first only guides the fuzzer.
    flags="-fsanitize=unsigned-integer-overflow,$checks -fno-sanitize-recover=$checks"
    export UBSAN_OPTIONS=silence_unsigned_overflow=1
    ;;
  *) fail "SANITIZER=$SANITIZER is neither address nor undefined" ;;
esac
flags="-O1 -fno-omit-frame-pointer -gline-tables-only -DFUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION $flags"
export CC=${CC:-clang} CXX=${CXX:-clang++} LIB_FUZZING_ENGINE=-fsanitize=fuzzer
export CFLAGS="$flags -fsanitize=fuzzer-no-link" CXXFLAGS="$flags -fsanitize=fuzzer-no-link"
may_need='linux-vdso|ld-linux|lib(c|m|gcc_s|dl|pthread|resolv|rt)\.so'
printf '#include <memory>\nauto p = std::make_unique_for_overwrite<char[]>(1);\n' >"$place/library.cpp"
if "$CXX" -std=c++20 -stdlib=libc++ -fsyntax-only "$place/library.cpp" 2>/dev/null; then
  CXXFLAGS+=" -stdlib=libc++"
  # In the image it is linked in; Debian's is a shared one, and its libFuzzer is of libstdc++.
  export LDFLAGS=-Wl,-lstdc++  # by the linker's name: clang would take the other for libc++
  may_need+='|lib(c\+\+|c\+\+abi|unwind|stdc\+\+)\.so'
  said "with libc++"
else
  may_need+='|libstdc\+\+\.so'
  said "no libc++ of C++20 here, so with the compiler's own C++ standard library"
fi
if [[ -n $highway ]]; then
  cp -r "$highway" "$SRC/highway"
else
  may_need+='|libhwy\.so'
  said "no HIGHWAY given, so with the system's"
fi
started=$SECONDS
(cd "$SRC/mmverify" && bash -eu .clusterfuzzlite/build.sh) >"$place/log" 2>&1 || { tail -n 40 "$place/log" >&2; fail "build.sh failed"; }
said "built in $((SECONDS - started)) s, $SANITIZER"

count=0
"$SRC/mmverify/fuzz/write-seeds" "$place/corpus"
for corpus in "$place/corpus"/*; do
  target=${corpus##*/}
  [[ $target != subject ]] || continue  # attacks a library that its user names
  program=$OUT/$target seeds=$place/seeds/$target
  [[ -x $program ]] || fail "no $target in \$OUT"
  needs=$(ldd "$program" | grep -vE "$may_need" || :)
  [[ -z $needs ]] || fail "$target needs what is not where it runs: $needs"
  python3 -m zipfile -e "$OUT/${target}_seed_corpus.zip" "$seeds"
  diff -r "$corpus" "$seeds" || fail "the seeds of $target are not its corpus"
  mapfile -t options < <(sed -n 's/^\([a-z_]*\) = /-\1=/p' "$OUT/$target.options")
  # As where they run: in $OUT, without the sources.
  (cd "$OUT" && "./$target" "${options[@]}" -seed=1 -runs=200 -max_total_time=60 "$seeds") >"$place/log" 2>&1 ||
    { tail -n 30 "$place/log" >&2; fail "$target failed"; }
  grep -qw INITED "$place/log" || fail "$target did not begin"
  said "$target: $(find "$corpus" -type f | wc -l) seeds, $(grep -oE 'Done [0-9]+ runs' "$place/log")"
  count=$((count + 1))
done
# Each file in $OUT without an extension is taken for a target.
[[ $(find "$OUT" -type f ! -name '*.*' | wc -l) == "$count" ]] || fail "\$OUT has $(ls "$OUT")"
said "$count targets build and run"
