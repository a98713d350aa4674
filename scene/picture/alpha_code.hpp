// The alpha of a texel as a byte, for pictures.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <variant>
#include <vector>

#include "scene/scene.hpp"

namespace mmverify::scene {

/// 0 to 255: the upper byte of whole numbers; floats are cut to [0, 1].  Domain: a texel of a decoded image.
inline std::uint8_t alpha_code(const Image& image, std::size_t texel) {
  return std::visit(
      [texel]<class Texel>(const std::vector<Texel>& alpha) {
        if constexpr (std::is_same_v<Texel, float>)
          return static_cast<std::uint8_t>(std::clamp(alpha[texel], 0.0f, 1.0f) * 255);
        else
          return static_cast<std::uint8_t>(alpha[texel] >> 8 * (sizeof(Texel) - 1));
      },
      image.alpha);
}

}  // namespace mmverify::scene
