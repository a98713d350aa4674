// mmverify scene --attributes: micromaps in the place of textures.
#pragma once

#include <string>
#include <vector>

namespace mmverify::cli {

struct AttributeArguments {
  std::string file;  ///< none: the suite's own scene
  std::string levels, json, plot, pictures, files;
  bool codes = false, quiet = false;
  unsigned threads = 0;
  bool packed = false;  ///< pack the maps as well
  unsigned packed_error = 0;
  bool astc = false, bc7 = false;  ///< compress the textures beside; one of them
  bool time = false;               ///< take times of lookups in textures and maps
  bool mips = false;               ///< hold mips of textures against those of maps
  std::vector<double> plan = {};   ///< plan levels for these errors
};

/// Prints the tables, writes JSON, the picture of the figures and pictures of the textures.  Returns the exit code.
int scene_attributes(const AttributeArguments& arguments);

}  // namespace mmverify::cli
