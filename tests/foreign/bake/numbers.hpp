// Whole numbers, as wide as it takes, and the numbers with a power of two that binary floats are.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace mmverify::tests::foreign::bake {

__extension__ typedef __int128 Wide;
namespace mp = boost::multiprecision;
using Big = mp::number<mp::cpp_int_backend<>, mp::et_off>;
using Index = std::int64_t;

/// Thrown where a case is beyond what is supported here: not finite, 2^60 texels away, millions of texels.
struct Declined {};

inline int sign(const Big& x) { return x.sign(); }
inline int sign(Wide x) { return (x > 0) - (x < 0); }
inline double real(const Big& x) { return x.convert_to<double>(); }
inline double real(Wide x) { return static_cast<double>(x); }

inline int bits(const Big& x) { return x == 0 ? 0 : static_cast<int>(mp::msb(mp::abs(x))) + 1; }

template <class T>
T to(const Big& x) {
  if constexpr (std::is_same_v<T, Big>) {
    return x;
  } else {
    const Big magnitude = mp::abs(x);
    const auto low = static_cast<std::uint64_t>(magnitude & 0xffffffffffffffffu);
    const auto high = static_cast<std::uint64_t>(magnitude >> 64);
    const Wide whole = (static_cast<Wide>(high) << 64) + static_cast<Wide>(low);
    return x.sign() < 0 ? -whole : whole;
  }
}
template <class T>
T to(Wide x) {
  if constexpr (std::is_same_v<T, Big>) {
    const bool below = x < 0;
    const Wide m = below ? -x : x;
    Big whole = static_cast<std::uint64_t>(m >> 64);
    whole <<= 64;
    whole += static_cast<std::uint64_t>(m);
    return below ? Big(-whole) : whole;
  } else {
    return x;
  }
}

template <class T>
T floor_div(const T& a, const T& b) {  // b > 0
  T q = a / b;
  if (sign(a) < 0 && q * b != a) q -= 1;
  return q;
}
template <class T>
T ceil_div(const T& a, const T& b) {
  return -floor_div(T(-a), b);
}
template <class T>
Index index_of(const T& x) {
  if (x > T(Index{1} << 61)) return Index{1} << 61;
  if (x < T(-(Index{1} << 61))) return -(Index{1} << 61);
  return static_cast<Index>(x);
}

/// mantissa 2^exponent, the mantissa odd or 0.
struct Dyadic {
  Big mantissa = 0;
  int exponent = 0;
};
template <class F>
Dyadic dyadic(F x) {
  if (!std::isfinite(x)) throw Declined{};
  if (x == 0) return {};
  int e = 0;
  const double m = std::frexp(static_cast<double>(x), &e);
  auto whole = static_cast<std::int64_t>(std::ldexp(m, 53));
  e -= 53;
  while (whole % 2 == 0) {
    whole /= 2;
    ++e;
  }
  return {Big(whole), e};
}
inline Big shifted(const Dyadic& d, int up) {  // d 2^up, which is whole
  return d.mantissa == 0 ? Big(0) : Big(d.mantissa << static_cast<unsigned>(d.exponent + up));
}

inline Big power(int e) { return Big(1) << static_cast<unsigned>(e); }

}  // namespace mmverify::tests::foreign::bake
