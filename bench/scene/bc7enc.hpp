// Richard Geldreich's BC7 encoder, to compare textures with maps.
#pragma once

#include <functional>
#include <string>

#include "scene/attribute/texture_coder.hpp"

namespace mmverify::bench {

/// The block size of BC7, 8 bits a texel; at lower resolutions 2 bits a texel of the original at 1/2, and so
/// on.
inline constexpr scene::BlockSize bc7_block{4, 4};

struct Bc7encOptions {
  unsigned threads = 0;                                   ///< 0: as many as the machine has
  unsigned quality = 6;                                   ///< 0, fast, to 6, thorough
  std::function<void(const std::string&)> progress = {};  ///< receives each size that begins
  std::function<void()> stop = {};                        ///< as in run_program()
};

/// The program bc7enc (of bc7enc_rdo; npm's package @gpu-tex-enc/bc has it) as a coder.  It compresses all
/// three channels, of normals too; errors are of codes, not of perceived colours; bytes are 16 a block of
/// 4x4.  It is found on the PATH as bc7enc or, as in that package, bc7enc-linux.  The coder's name is the
/// program's version and the quality: "bc7enc v1.08, -u6".
/// Its files lie in a program::Folder.
/// Domain of its textures: sides up to 16384, rgb.size() = 3 width height.
/// Errors: NoProgram, here, if the program is missing.  std::runtime_error, during compression, with the
/// program's words if it fails or its output is not as it must be.
scene::TextureCoder bc7_coder(const Bc7encOptions& options);

}  // namespace mmverify::bench
