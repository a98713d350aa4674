// mmverify check maps: checks finished maps against their textures.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/scene/bake_effort.hpp"

namespace mmverify::cli {

/// An array as in the buffers of a build: files with its bytes.
struct RawArray {
  std::string data, records, indices;  ///< without indices, triangle t has record t
  std::string index_type = "u32";
  std::uint32_t base_triangle = 0;
  std::string primitive;  ///< "MESH/PRIMITIVE" in the glTF file
};

struct CheckMapsOptions {
  std::string file;  ///< or a folder of files
  std::string json, junit, sarif, replay, at, picture;
  RawArray raw;
  BakeEffort effort;
  std::uint64_t seed = 1;
  std::size_t errors = 1;
  std::optional<int> states = {};  ///< 2 or 4; none: as the file's records say, else 4
  float margin = 0;
  bool quiet = false;
};

/// Reads the maps, checks that they are well-formed, and runs the laws of baking on them; of a folder those of each glTF
/// file with micromaps.  Returns the exit code, of several files the worst.
/// Throws UsageError, EnvironmentError, BadScene.
int check_maps(const CheckMapsOptions& options);

}  // namespace mmverify::cli
