// Richard Geldreich's BC7 encoder, of textures for comparison.
#pragma once

#include <functional>
#include <string>

#include "scene/attribute/texture_coder.hpp"

namespace mmverify::bench {

/// The block size of BC7, 8 bits a texel: of the original, and of textures at lower resolutions 2 bits at 1/2, and so on.
inline constexpr scene::BlockSize bc7_block{4, 4};

struct Bc7encOptions {
  unsigned threads = 0;                                   ///< 0: as many as the machine has
  unsigned quality = 6;                                   ///< 0, fast, to 6, thorough
  std::function<void(const std::string&)> progress = {};  ///< told of each size that begins
  std::function<void()> stop = {};                        ///< as in run_program()
};

/// The program bc7enc (of bc7enc_rdo; npm's package @gpu-tex-enc/bc has it) as a coder: all three channels, of normals, too;
/// errors are of codes, not of perceived colours; bytes are 16 a block of 4x4.  Found on the PATH as bc7enc or, as that
/// package calls it, bc7enc-linux; its name is what it says of itself and the quality: "bc7enc v1.08, -u6".
/// Its files lie in a program::Folder.
/// Domain of what it compresses: sides up to 16384, rgb.size() = 3 width height.
/// Errors: NoProgram, here, where there is none.  std::runtime_error, when it compresses, with the program's words where
/// it fails or what it leaves is not as it must be.
scene::TextureCoder bc7_coder(const Bc7encOptions& options);

}  // namespace mmverify::bench
