// Arm's ASTC encoder, to compare textures with maps.
#pragma once

#include <functional>
#include <string>

#include "scene/attribute/texture_coder.hpp"

namespace mmverify::bench {

/// The block sizes, from 8 to 0.89 bits a texel.
inline constexpr scene::BlockSize astc_blocks[] = {{4, 4}, {5, 5},   {6, 6},  {8, 6},
                                                   {8, 8}, {10, 10}, {12, 12}};

/// The block sizes of textures at lower resolutions: 0.5 and 0.22 bits a texel of the original at 1/2, and so
/// on.
inline constexpr scene::BlockSize reduced_astc_blocks[] = {{8, 8}, {12, 12}};

struct AstcencOptions {
  unsigned threads = 0;                                   ///< 0: as many as the machine has
  std::string quality = "-thorough";                      ///< a preset of its own: -fastest to -exhaustive
  std::function<void(const std::string&)> progress = {};  ///< receives each block size that begins
  std::function<void()> stop = {};                        ///< as in run_program()
};

/// The program astcenc, of the Debian package of that name, as a coder.  sRGB codes are compressed as such;
/// for normals x and y are compressed, and z is computed from them; bytes are 16 a block.  It is found on the
/// PATH as astcenc or by its instruction set, as astcenc-avx2.  The coder's name is the program's version and
/// the quality: "astcenc v4.2.0, 64-bit sse2, -thorough".
/// Its files lie in a folder that only this user may enter and that is removed in the end, whatever happens.
/// Domain of its textures: sides up to 16384, rgb.size() = 3 width height.
/// Errors: NoProgram, here, if the program is missing.  std::runtime_error, during compression, with the
/// program's words if it fails or its output is not as it must be.
scene::TextureCoder astc_coder(const AstcencOptions& options);

}  // namespace mmverify::bench
