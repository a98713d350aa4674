// The obvious ways of lookup: figure 4 as printed, and a texture sampled bilinearly.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

namespace mmverify::bench {

/// Indices of the three micro-vertices around (u, v) in W-minor order, in binary32.
/// Source: Color and Attribute Micromaps, figure 4: wminor_uv2triangle_index, then wminor_uv2vertex_index.
inline std::array<std::uint32_t, 3> figure_4_triplet(float u, float v, std::uint32_t level) {
  const std::uint32_t N = 1u << level;
  const auto side = static_cast<float>(N);
  const float w = 1.0f - (u + v);
  const std::uint32_t of_row = std::min(N - 1, static_cast<std::uint32_t>((1.0f - w) * side));
  const std::uint32_t of_col = std::min(of_row, static_cast<std::uint32_t>(v * side));
  const std::uint32_t dia = std::min(N - 1, static_cast<std::uint32_t>((1.0f - u) * side));
  const std::uint32_t index = of_row * of_row + of_col + (dia - (N - 1 - of_row));
  const auto row = static_cast<std::uint32_t>(std::sqrt(static_cast<float>(index)));
  const std::uint32_t col = index - row * row;
  const auto to_index = [](std::uint32_t r, std::uint32_t c) { return r * (r + 1) / 2 + c; };
  if (col % 2 == 0)
    return {to_index(row, col / 2), to_index(row + 1, col / 2), to_index(row + 1, col / 2 + 1)};
  return {to_index(row, col / 2), to_index(row + 1, col / 2 + 1), to_index(row, col / 2 + 1)};
}

/// RGBA8 between four texels, c[x + 2y]: f of the way to the right and g down, each channel rounded half up.
/// Domain: f, g in [0, 1).
inline std::uint32_t mixed_bilinear(const std::array<std::uint32_t, 4>& c, float f, float g) {
  const float w3 = f * g, w2 = g - w3, w1 = f - w3, w0 = 1 - f - w2;
  std::uint32_t out = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const auto channel = [shift](std::uint32_t texel) {
      return static_cast<float>(static_cast<std::int32_t>(texel >> shift & 0xff));
    };
    const float sum =
        (w0 * channel(c[0]) + w1 * channel(c[1])) + (w2 * channel(c[2]) + (w3 * channel(c[3]) + 0.5f));
    out |= static_cast<std::uint32_t>(static_cast<std::int32_t>(sum)) << shift;
  }
  return out;
}

/// A square texture of 2^level RGBA8 texels a side, repeated.
struct SquareTexture {
  std::span<const std::uint32_t> texels;
  std::uint32_t level;
};

/// A bilinear sample, texel centres at halves, each channel rounded half up.  Domain: u, v in [0, 1].
inline std::uint32_t bilinear_rgba8(const SquareTexture& t, float u, float v) {
  const std::uint32_t last = (1u << t.level) - 1;
  const auto side = static_cast<float>(1 << t.level);
  // Half a texel to the right instead of half to the left keeps numbers positive; the mask subtracts the 1
  // again.
  const float x = u * side + 0.5f, y = v * side + 0.5f;
  const auto right = static_cast<std::int32_t>(x), below = static_cast<std::int32_t>(y);
  const float f = x - static_cast<float>(right), g = y - static_cast<float>(below);
  const auto r = static_cast<std::uint32_t>(right), b = static_cast<std::uint32_t>(below);
  const std::uint32_t x1 = r & last, x0 = (r - 1) & last;
  const std::uint32_t y1 = (b & last) << t.level, y0 = ((b - 1) & last) << t.level;
  return mixed_bilinear({t.texels[y0 + x0], t.texels[y0 + x1], t.texels[y1 + x0], t.texels[y1 + x1]}, f, g);
}

/// The same samples in SIMD, chosen at run time; bit for bit equal.  Domain: three spans of one length.
void bilinear_rgba8(const SquareTexture& t, std::span<const float> u, std::span<const float> v,
                    std::span<std::uint32_t> out);

}  // namespace mmverify::bench
