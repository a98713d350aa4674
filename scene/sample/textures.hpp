// The pictures of the sample scene, drawn by formulas.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/read/file.hpp"

namespace mmverify::scene {

struct Picture {
  std::string name;
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  ///< rows from the top
};

/// Alpha is the share of a texel's 4 x 4 samples that lie in a shape, so outlines are soft; elsewhere it is 0
/// or 255, except in pond().  The bytes are the same on every machine: they come from +, -, x, / and square
/// roots alone.
Picture leaves();  ///< 256 x 128: a toothed leaf, and one of many leaflets, side by side
Picture wire();    ///< 64 x 64, repeats: chain link
Picture flower();  ///< 96 x 96: five petals
Picture blades();  ///< 128 x 64: grass
Picture pond();    ///< 64 x 64: a soft disc, alpha 255 in its middle

/// 1024 x 1024 texels each, alpha 255, the value of the texel's centre.
Picture rings();  ///< base colours: rings that get finer outwards
Picture waves();  ///< normals in tangent space, of waves along both axes

/// A picture as PNG.  Errors: std::runtime_error if the library has no memory.
Bytes png(const Picture& picture);

}  // namespace mmverify::scene
