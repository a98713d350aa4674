// The index algorithms by another hand, in whole numbers: a barycentric x stands as the integer x `one`.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "proofs/index/subject.hpp"
#include "tests/foreign/inside/inside.hpp"

namespace mmverify::tests::foreign {

using Level = proofs::Level;
using Integer = boost::multiprecision::cpp_int;

enum class Reading { printed, middle, ties, names };

template <class Int>
struct Bary {
  Int u, v, one;
};

inline Bary<std::int64_t> whole_numbers(const proofs::points::GridPoint& p) {
  return {p.u.raw(), p.v.raw(), std::int64_t{1} << 30};
}

inline Bary<Integer> whole_numbers(const proofs::points::RationalPoint& p) {
  return {p.u.numerator() * p.v.denominator(), p.v.numerator() * p.u.denominator(),
          p.u.denominator() * p.v.denominator()};
}

/// A binary32 number of [0, 2] times 2^149.
inline Integer in_smallest_units(float x) {
  int exponent = 0;
  const double fraction = std::frexp(static_cast<double>(x), &exponent);
  const auto digits = static_cast<std::int64_t>(std::ldexp(fraction, 24));
  const int shift = exponent - 24 + 149;
  return shift >= 0 ? Integer(digits) << static_cast<unsigned>(shift)
                    : Integer(digits) >> static_cast<unsigned>(-shift);
}

/// Algorithm 4: which corner's triangle holds the point, or the middle one, level by level.
template <class Int>
std::uint64_t recursion(const Bary<Int>& p, Level n, Reading reading, Fault fault) {
  const Int& one = p.one;
  Int u = p.u, v = p.v, w = one - p.u - p.v;
  bool mid = false, top = false;
  std::uint64_t index = 0;
  for (Level depth = 0; depth < n; ++depth) {
    const Int twice_u = u + u, twice_v = v + v, twice_w = w + w;
    const Int from_w = w - u - v, from_v = v - u - w, from_u = u - v - w;
    bool is_w = twice_w > one;
    if (fault == "w_tie_at_depth_8"_fault && depth == 8) is_w = twice_w >= one;
    if (fault == "line_moved_in_some_cells"_fault && depth + 1 == n && depth > 3 && index % 64 == 21)
      is_w = 64 * twice_w > 65 * one;

    bool v_excepted = mid && twice_v == one;
    const bool u_excepted = reading == Reading::ties ? mid && twice_u == one : v_excepted;
    if (fault == "turned_t_keeps_tie"_fault && top && depth >= 5) v_excepted = false;
    if (fault == "ties_of_odd_denominators"_fault && (one & (one - 1)) != 0) v_excepted = false;
    bool is_u = twice_u >= one && !u_excepted;
    if constexpr (std::is_same_v<Int, std::int64_t>)
      if (fault == "fixed_u_tie_at_depth_7"_fault && depth == 7 && twice_u == one) is_u = false;

    unsigned digit = 1;
    if (is_w)
      digit = top ? 2 : 0;
    else if (twice_v >= one && !v_excepted)
      digit = 3;
    else if (is_u)
      digit = top ? 0 : 2;
    index = 4 * index + digit;

    // To which corner the new coordinates belong: w, u, v.
    int corner = is_w ? 0 : digit == 3 ? 2 : digit == 1 ? 3 : 1;
    if (reading == Reading::names && corner != 3) corner = is_w ? 1 : digit == 3 ? 0 : 2;
    switch (corner) {
      case 0: u = twice_u, v = twice_v, w = from_w; break;
      case 1: u = from_u, v = twice_v, w = twice_w; break;
      case 2: u = twice_u, v = from_v, w = twice_w; break;
      default:
        u = -from_w, v = -from_v, w = -from_u;
        if (reading == Reading::middle) std::swap(v, w);
        mid = !mid;
    }
    if (digit == 3 && !(fault == "top_flip_lost_at_depth_7"_fault && depth == 7 && mid)) top = !top;
  }
  if (fault == "one_triangle_of_level_9"_fault && n == 9 && index == 262'142) return 262'141;
  return index;
}

/// The grid square of a point, the digits' third word, and the index: Vulkan's formula, one place at a time.
template <class Int>
std::uint64_t vulkan(const Bary<Int>& p, Level n, Fault fault) {
  const std::uint64_t N = std::uint64_t{1} << n;
  const auto inside = [&p](const Int& x) { return x < 0 ? Int(0) : x > p.one ? p.one : x; };
  Int scaled_u = inside(p.u) * Int(N), scaled_v = inside(p.v) * Int(N);
  if constexpr (std::is_same_v<Int, std::int64_t>)
    if (fault == "product_of_32_bits"_fault) {
      const auto product = [N](Int x) {
        return Int{static_cast<std::int32_t>(static_cast<std::uint32_t>(x >> 6) *
                                             static_cast<std::uint32_t>(N))} *
               64;
      };
      scaled_u = product(inside(p.u));
      scaled_v = product(inside(p.v));
    }
  auto iu = static_cast<std::uint64_t>(scaled_u / p.one), iv = static_cast<std::uint64_t>(scaled_v / p.one);
  const Int rest_u = scaled_u % p.one, rest_v = scaled_v % p.one;
  bool upper = rest_u + rest_v >= p.one;
  if (fault == "half_of_last_square"_fault && iu + iv == N - 2 && iu + 2 == iv)
    upper = rest_u + rest_v > p.one;
  if (fault == "sum_in_binary32"_fault) {
    const auto fraction = [&p](const Int& x) {
      return static_cast<float>(static_cast<double>(x) / static_cast<double>(p.one));
    };
    upper = fraction(rest_u) + fraction(rest_v) >= 1.0f;
  }

  iu = std::min(iu, N - 1);
  const std::uint64_t limit_v = fault == "v_corner_not_limited"_fault && n == 9 ? N
                                : fault == "limit_in_binary32"_fault
                                    ? static_cast<std::uint64_t>(static_cast<float>(N - 1))
                                    : N - 1;
  iv = std::min(iv, limit_v);
  const std::uint64_t s = iu + iv;
  if (s >= N) iu -= s - N + 1;
  std::uint64_t iw = ~(iu + iv);
  if (upper && s < N - 1) --iw;

  std::uint64_t index = 0;
  std::uint64_t above = 0;
  for (Level place = n; place-- > 0;) {
    const std::uint64_t a = iu >> place & 1, b = iv >> place & 1, c = iw >> place & 1;
    const std::uint64_t b0 = 1 ^ a ^ c, t = (a ^ b) & b0;
    above = above << 1 | t;
    const std::uint64_t reach = fault == "parity_of_8_places"_fault    ? 0xFF
                                : fault == "parity_of_16_places"_fault ? 0xFFFF
                                                                       : ~std::uint64_t{0};
    const std::uint64_t parity = static_cast<std::uint64_t>(__builtin_parityll(above & reach));
    index = 4 * index + b0 + 2 * (((parity ^ a) & (1 ^ b0)) | t);
  }
  if (fault == "v_corner_is_first"_fault && iv == N - 1) return 0;
  if (fault == "answer_of_16_bits"_fault) return index & 0xFFFF;
  if (fault == "answer_through_binary64"_fault) return static_cast<std::uint64_t>(static_cast<double>(index));
  if (fault == "low_digit_at_level_30"_fault && n == 30 && iv > iu && upper) return index ^ 1;
  return index;
}

}  // namespace mmverify::tests::foreign
