// Maps of the alpha textures of real scenes.
#pragma once

#include <string>
#include <vector>

#include "impl/tree_stream.hpp"

namespace mmverify::bench {

/// Alpha of one picture, rows from the top.
struct AlphaTexture {
  std::string file;
  int width = 0, height = 0;
  std::vector<std::uint8_t> alpha;
};

/// All PNG files in and below a folder, in order of name.  Throws std::runtime_error, naming the file or the
/// folder, where one cannot be read or there is none.
std::vector<AlphaTexture> alpha_textures(const std::string& folder);

/// The two half-square triangles of each texture, (0,0) (1,0) (0,1) and (1,1) (0,1) (1,0), one map each.
///   opaque where the texel under the centre of the micro-triangle has alpha >= 128; with four states unknown
///   (transparent or opaque by the centre) where the centre and the three corners do not agree
/// A sample, not the exact baker.  Domain: level 0..12.
std::vector<std::vector<std::uint8_t>> texture_maps(const std::vector<AlphaTexture>& textures,
                                                    impl::tree::Level level, impl::tree::Bits bits);

}  // namespace mmverify::bench
