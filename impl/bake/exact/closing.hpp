// The number of texels after which alpha repeats itself along an edge.  Internal to impl/bake.
#pragma once

#include <cstdint>

#include "impl/common/few.hpp"

namespace mmverify::impl::bake::detail {

/// A closing: texels across and down, signs included.
struct Closing {
  std::int64_t columns, rows;
};

/// One for each axis, and one for each edge of the base triangle.
using Closings = Few<Closing, 2 + 3>;

}  // namespace mmverify::impl::bake::detail
