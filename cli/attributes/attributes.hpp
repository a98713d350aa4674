// mmverify attributes: attribute micromaps of a scene in place of its textures.
#pragma once

#include <string>
#include <vector>

namespace mmverify::cli {

struct AttributeArguments {
  std::string file;  ///< empty for the built-in scene
  std::string levels = "0..5";
  std::string json, plot, pictures, files;
  bool codes = false, quiet = false;
  unsigned threads = 0;
  bool packed = false;  ///< pack the maps too
  unsigned packed_error = 0;
  bool astc = false, bc7 = false;  ///< compress the textures for comparison, by one of them
  bool time = false;               ///< time lookups in textures and maps
  bool mips = false;               ///< compare mips of textures with those of maps
  std::vector<double> plan;        ///< plan levels for these errors
};

/// Prints the tables, and writes JSON, the plot and pictures of the textures. Returns the exit code.
int measure_attributes(const AttributeArguments& arguments);

}  // namespace mmverify::cli
