#!/bin/bash -eu
# Builds every fuzz target for OSS-Fuzz and ClusterFuzzLite, into $OUT: the targets, their seed corpora, dictionaries and
# options. The project is $SRC/mmverify; what dependencies.sh fetched is beside it. What is not beside it, is taken from
# the system: so tests/outside/oss_fuzz_test.sh runs this without a network.
project=$SRC/mmverify
installed=$WORK/installed
mkdir -p "$WORK" "$installed"

found=(-DCMAKE_PREFIX_PATH="$installed")
if [[ -d $SRC/highway ]]; then
  # Of its instruction sets, those that the targets use: MMVERIFY_ONLY_FUZZ in CMakeLists.txt.
  cmake -S "$SRC/highway" -B "$WORK/highway" -DCMAKE_BUILD_TYPE=None -DCMAKE_INSTALL_PREFIX="$installed" \
    -DCMAKE_INSTALL_LIBDIR=lib -DBUILD_SHARED_LIBS=OFF -DBUILD_TESTING=OFF -DHWY_ENABLE_CONTRIB=OFF \
    -DHWY_ENABLE_EXAMPLES=OFF -DHWY_ENABLE_INSTALL=ON \
    -DCMAKE_CXX_FLAGS="$CXXFLAGS -DHWY_DISABLED_TARGETS='(HWY_SSSE3|HWY_SSE4|(HWY_AVX2-1))'"
  cmake --build "$WORK/highway" --parallel "${JOBS:-$(nproc)}" --target install
  export PKG_CONFIG_PATH=$installed/lib/pkgconfig
fi
if [[ -d $SRC/json ]]; then
  cmake -S "$SRC/json" -B "$WORK/json" -DCMAKE_INSTALL_PREFIX="$installed" -DJSON_BuildTests=OFF
  cmake --install "$WORK/json"
fi
[[ ! -d $SRC/boost ]] || found+=(-DBOOST_ROOT="$SRC/boost" -DBoost_NO_SYSTEM_PATHS=ON)
[[ ! -d $SRC/tinygltf ]] || found+=(-DTINYGLTF_INCLUDE="$SRC/tinygltf")
[[ ! -d $SRC/stb ]] || found+=(-DSTB_INCLUDE="$SRC")

# No build type: the flags are those of $CFLAGS and $CXXFLAGS alone.
cmake -S "$project" -B "$WORK/mmverify" -DCMAKE_BUILD_TYPE=None -DMMVERIFY_ONLY_FUZZ=ON -DMMVERIFY_FUZZ=ON \
  -DMMVERIFY_FUZZ_ENGINE="$LIB_FUZZING_ENGINE" "${found[@]}"

"$project/fuzz/write-seeds" "$WORK/seeds"
cd "$WORK/seeds"
# subject attacks a library that its user names: there is none here.
targets=()
for target in *; do [[ $target == subject ]] || targets+=("$target"); done
cmake --build "$WORK/mmverify" --parallel "${JOBS:-$(nproc)}" --target "${targets[@]/#/fuzz_}"

for target in "${targets[@]}"; do
  cp "$WORK/mmverify/fuzz/fuzz_$target" "$OUT/$target"
  (cd "$target" && zip --quiet --recurse-paths - .) >"$OUT/${target}_seed_corpus.zip"
  grep -v '^#' "$project/fuzz/libfuzzer.options" >"$OUT/$target.options"
  dictionary=$project/fuzz/${target%%_*}.dict
  if [[ -f $dictionary ]]; then
    cp "$dictionary" "$OUT/$target.dict"
    printf 'dict = %s.dict\n' "$target" >>"$OUT/$target.options"
  fi
done
