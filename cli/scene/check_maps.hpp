// mmverify check maps: finished maps against the textures that they are of.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace mmverify::cli {

/// An array as it lies in the buffers of a build: files of its bytes.
struct RawArray {
  std::string data, records, indices;  ///< no indices: triangle t has record t
  std::string index_type = "u32";
  std::uint32_t base_triangle = 0;
  std::string primitive;  ///< "MESH/PRIMITIVE", of glTF
};

struct CheckMapsOptions {
  std::string file, json, junit, replay, at;
  RawArray raw;
  std::uint64_t samples = 60000, seed = 1;
  std::size_t errors = 1;
  int states = 4;
  float margin = 0;
  bool exhaustive = false, quiet = false;
};

/// Reads the maps, finds them well-formed, and runs the laws of baking on them.  Returns the exit code.
/// Throws UsageError, EnvironmentError, BadScene.
int check_maps(const CheckMapsOptions& options);

}  // namespace mmverify::cli
