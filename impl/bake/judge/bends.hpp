// The rows near which a dilated triangle's outline turns.  Internal to impl/bake.
#pragma once

#include <array>
#include <cstddef>

#include "impl/bake/plane/points.hpp"
#include "impl/bake/texture/rows.hpp"

namespace mmverify::impl::bake::detail {

/// The rows within two of each corner, moved up and down by `grown`.
inline std::array<Bend, 6> bends(const Triangle& p, double grown) noexcept {
  std::array<Bend, 6> all;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t above = floored(p[k].y - grown), under = floored(p[k].y + grown);
    all[2 * k] = {above - 2, above + 2};
    all[2 * k + 1] = {under - 2, under + 2};
  }
  return all;
}

}  // namespace mmverify::impl::bake::detail
