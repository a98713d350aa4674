// A texture sampled point by point, as in a software renderer.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "bench/attribute/obvious.hpp"
#include "scene/read/image.hpp"
#include "scene/scene.hpp"

namespace mmverify::bench {

/// A bilinear sampler at level 0 in binary32, whatever filter the sampler names; codes are mixed as they are,
/// each channel rounded half up.
class TextureSample {
 public:
  /// The image must outlive the sampler.  Domain: decoded.
  TextureSample(const scene::ColourImage& image, const scene::Sampler& sampler)
      : rgba_(image.rgba.data()),
        x_{static_cast<std::int32_t>(image.width), static_cast<float>(image.width), sampler.wrap_u},
        y_{static_cast<std::int32_t>(image.height), static_cast<float>(image.height), sampler.wrap_v} {}

  /// A sample, r | g << 8 | b << 16 | a << 24.  Domain: |u|, |v| < 2^20.
  std::uint32_t at(float u, float v) const {
    const Between x = x_.between(u), y = y_.between(v);
    return mixed_bilinear({texel(x.first, y.first), texel(x.second, y.first), texel(x.first, y.second),
                           texel(x.second, y.second)},
                          x.fraction, y.fraction);
  }

 private:
  /// Two texels along an axis, and the fraction of the way from the first one's centre to the second's.
  struct Between {
    std::int32_t first, second;
    float fraction;
  };

  struct Axis {
    std::int32_t texels;
    float length;
    scene::Wrap wrap;

    Between between(float coordinate) const {
      // The coordinate within one period; mirrored periods are folded, and meet at clamped texels.
      float t = coordinate;
      if (wrap == scene::Wrap::repeat) {
        t -= std::floor(t);
      } else if (wrap == scene::Wrap::mirrored_repeat) {
        t -= 2 * std::floor(t * 0.5f);
        t = t > 1 ? 2 - t : t;
      } else {
        t = t < 0 ? 0 : t > 1 ? 1 : t;
      }
      // Half a texel to the right instead of half to the left keeps the number positive.
      const float right = t * length + 0.5f;
      const auto whole = static_cast<std::int32_t>(right);
      std::int32_t first = whole - 1, second = whole;
      if (wrap == scene::Wrap::repeat) {
        first = first < 0 ? texels - 1 : first;
        second = second >= texels ? second - texels : second;
      } else {
        first = first < 0 ? 0 : first;
        second = second >= texels ? texels - 1 : second;
      }
      return {first, second, right - static_cast<float>(whole)};
    }
  };

  std::uint32_t texel(std::int32_t x, std::int32_t y) const {
    const auto place =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(x_.texels) + static_cast<std::size_t>(x);
    std::uint32_t value;
    std::memcpy(&value, rgba_ + 4 * place, sizeof value);
    return value;
  }

  const std::uint8_t* rgba_;
  Axis x_, y_;
};

}  // namespace mmverify::bench
