// Arm's ASTC encoder, of textures for comparison.
#pragma once

#include <functional>
#include <string>

#include "scene/attribute/texture_coder.hpp"

namespace mmverify::bench {

/// The block sizes, from 8 to 0.89 bits a texel.
inline constexpr scene::BlockSize astc_blocks[] = {{4, 4}, {5, 5},   {6, 6},  {8, 6},
                                                   {8, 8}, {10, 10}, {12, 12}};

/// Of textures at lower resolutions: 0.5 and 0.22 bits a texel of the original at 1/2, and so on.
inline constexpr scene::BlockSize reduced_astc_blocks[] = {{8, 8}, {12, 12}};

struct AstcencOptions {
  unsigned threads = 0;                                   ///< 0: as many as the machine has
  std::string quality = "-thorough";                      ///< a preset of its own: -fastest to -exhaustive
  std::function<void(const std::string&)> progress = {};  ///< told of each block size that begins
  std::function<void()> stop = {};                        ///< as in run_program()
};

/// The program astcenc, of the Debian package of that name, as a coder: sRGB codes are compressed as such; of normals x
/// and y, from which z comes back; bytes are 16 a block.  Found on the PATH as astcenc or by its instruction set, as
/// astcenc-avx2; its name is what it says of itself and the quality: "astcenc v4.2.0, 64-bit sse2, -thorough".
/// Its files lie in a folder that only this user may enter and that is removed in the end, whatever happens.
/// Domain of what it compresses: sides up to 16384, rgb.size() = 3 width height.
/// Errors: NoProgram, here, where there is none.  std::runtime_error, when it compresses, with the program's words where
/// it fails or what it leaves is not as it must be.
scene::TextureCoder astc_coder(const AstcencOptions& options);

}  // namespace mmverify::bench
