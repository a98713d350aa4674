// Common parts of the laws of vectors.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "proofs/vq/subject.hpp"

namespace mmverify::proofs::vq {

/// The levels of vectors, which have 2^level regions along a side.
inline constexpr Levels both_sides{1, 2};

/// Calls f(std::integral_constant<std::size_t, side>) for a level.  Throws BadCase at other levels.
template <class F>
auto at_side(Level n, F f) {
  if (n == 1) return f(std::integral_constant<std::size_t, 2>());
  if (n == 2) return f(std::integral_constant<std::size_t, 4>());
  throw BadCase(fmt::format("level {}: vectors have 2 or 4 regions along a side, levels 1 and 2", n));
}

inline std::optional<std::string> lacks_vectors(const VqSubject& s) {
  if (!s.functions.of2.valid || !s.functions.composed)
    return s.name() + " has no entry point of vectors: they are the specification's";
  return std::nullopt;
}

}  // namespace mmverify::proofs::vq
