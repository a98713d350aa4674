// The number of texels after which alpha repeats itself along an edge.  Internal to impl/bake.
#pragma once

#include <cstdint>

namespace mmverify::impl::bake::detail {

/// A closing: texels across and down, signs included.
struct Closing {
  std::int64_t columns, rows;
};

}  // namespace mmverify::impl::bake::detail
