// A reader of the alpha of pictures, from PNG files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace mmverify::bench {

/// The alpha of one picture, rows from the top.
struct AlphaTexture {
  std::string file;
  int width = 0, height = 0;
  std::vector<std::uint8_t> alpha;
};

/// All PNG files in and below a folder, in order of name.  Throws std::runtime_error, which names the file or
/// the folder, if one cannot be read or there is none.
std::vector<AlphaTexture> alpha_textures(const std::string& folder);

}  // namespace mmverify::bench
