// Values that faults keep between calls or share between threads.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>

#include "tests/foreign/index/numbers.hpp"

namespace mmverify::tests::foreign::index {

template <typename Real>
struct Kept {
  Real u = -1, v = -1;
  Word level = ~Word{0};
  Word index = 0;
};

inline constexpr std::size_t scratch_size = 4096;
template <typename Real>
inline std::array<std::atomic<Real>, scratch_size>
    scratch;  // one for all threads, of the faults that share it

/// A place in a cache of 4096.
inline Word place_of(Word a, Word b) { return ((a * 31 + b) * 0x9e3779b1) >> 20; }

/// The high bits of a number.
inline Word high_bits(float x) { return std::bit_cast<Word>(x) >> 12; }
inline Word high_bits(double x) { return high_bits(static_cast<float>(x)); }

}  // namespace mmverify::tests::foreign::index
