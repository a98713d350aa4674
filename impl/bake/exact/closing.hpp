// After how many texels alpha repeats itself along an edge.  Internal to impl/bake.
#pragma once

#include <cstdint>

namespace mmverify::impl::bake::detail {

/// Texels across and down, signs included.
struct Closing {
  std::int64_t columns, rows;
};

}  // namespace mmverify::impl::bake::detail
