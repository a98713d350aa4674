#include "scene/attribute/reduced_texture.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace mmverify::scene {
namespace {

CodeMeaning::Mean mean_at(const RgbTexels& texels, std::size_t texel, const CodeMeaning& meaning) {
  const std::uint8_t* const code = &texels.rgb[3 * texel];
  return meaning.mean_of({code[0], code[1], code[2], 0});
}

void add(CodeMeaning::Mean& sum, const CodeMeaning::Mean& mean, double weight) {
  for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += weight * mean[c];
}

/// Two neighbours along an axis, and the share of the second.
struct Between {
  std::size_t first, second;
  double share;
};

Between between(std::uint32_t at, std::uint32_t factor, std::uint32_t side) {
  const double x = std::clamp((at + 0.5) / factor - 0.5, 0.0, side - 1.0);
  const auto first = static_cast<std::size_t>(x);
  return {first, std::min<std::size_t>(first + 1, side - 1), x - static_cast<double>(first)};
}

}  // namespace

RgbTexels reduced(const RgbTexels& texels, std::uint32_t factor, const CodeMeaning& meaning) {
  RgbTexels small{(texels.width + factor - 1) / factor, (texels.height + factor - 1) / factor, {}};
  small.rgb.resize(std::size_t{3} * small.width * small.height);
  oneapi::tbb::parallel_for(std::uint32_t{0}, small.height, [&](std::uint32_t y) {
    for (std::uint32_t x = 0; x < small.width; ++x) {
      const std::uint32_t right = std::min(texels.width, factor * (x + 1)),
                          below = std::min(texels.height, factor * (y + 1));
      CodeMeaning::Mean sum{};
      const double weight = 1.0 / ((right - factor * x) * (below - factor * y));
      for (std::uint32_t j = factor * y; j < below; ++j)
        for (std::uint32_t i = factor * x; i < right; ++i)
          add(sum, mean_at(texels, i + std::size_t{j} * texels.width, meaning), weight);
      paint(small.rgb, x + std::size_t{y} * small.width, meaning.code_of(sum), 7);
    }
  });
  return small;
}

std::vector<std::uint8_t> enlarged(const RgbTexels& reduced, std::uint32_t factor, std::uint32_t width,
                                   std::uint32_t height, const CodeMeaning& meaning) {
  std::vector<std::uint8_t> rgb(std::size_t{3} * width * height);
  oneapi::tbb::parallel_for(std::uint32_t{0}, height, [&](std::uint32_t y) {
    const Between v = between(y, factor, reduced.height);
    for (std::uint32_t x = 0; x < width; ++x) {
      const Between u = between(x, factor, reduced.width);
      CodeMeaning::Mean sum{};
      for (const auto& [row, of_row] : {std::pair(v.first, 1 - v.share), std::pair(v.second, v.share)}) {
        add(sum, mean_at(reduced, u.first + row * reduced.width, meaning), of_row * (1 - u.share));
        add(sum, mean_at(reduced, u.second + row * reduced.width, meaning), of_row * u.share);
      }
      paint(rgb, x + std::size_t{y} * width, meaning.code_of(sum), 7);
    }
  });
  return rgb;
}

}  // namespace mmverify::scene
