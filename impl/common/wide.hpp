// Integers of a fixed width beyond 128 bits.  Internal to impl.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace mmverify::impl {

// __int128 is not ISO C++, but both compilers of this project have it.
__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 Unsigned128;

/// The number of bits of a.  Domain: a >= 0.
constexpr int bit_width(Int128 a) noexcept {
  const auto high = static_cast<std::uint64_t>(a >> 64);
  return high != 0 ? 64 + static_cast<int>(std::bit_width(high))
                   : static_cast<int>(std::bit_width(static_cast<std::uint64_t>(a)));
}

/// The first 64 bits of a, the highest of them set unless a is 0.  Domain: a >= 0.
constexpr std::uint64_t leading(Int128 a) noexcept {
  const int shift = 128 - bit_width(a);
  return shift == 128 ? 0 : static_cast<std::uint64_t>(static_cast<Unsigned128>(a) << shift >> 64);
}

/// An integer in two's complement of 64 `limbs` bits; the caller prevents overflow.
template <std::size_t limbs>
class Wide {
 public:
  constexpr Wide() noexcept = default;
  constexpr Wide(std::int64_t x) noexcept {
    limb_.fill(x < 0 ? ~std::uint64_t{0} : 0);
    limb_[0] = static_cast<std::uint64_t>(x);
  }

  friend constexpr Wide operator+(const Wide& a, const Wide& b) noexcept {
    Wide sum;
    Unsigned128 carry = 0;
    for (std::size_t k = 0; k < limbs; ++k) {
      carry += Unsigned128{a.limb_[k]} + b.limb_[k];
      sum.limb_[k] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return sum;
  }
  constexpr Wide operator-() const noexcept {
    Wide inverse;
    for (std::size_t k = 0; k < limbs; ++k) inverse.limb_[k] = ~limb_[k];
    return inverse + Wide(1);
  }
  friend constexpr Wide operator-(const Wide& a, const Wide& b) noexcept { return a + -b; }
  friend constexpr Wide operator*(const Wide& a, const Wide& b) noexcept {
    Wide product;
    for (std::size_t i = 0; i < limbs; ++i) {
      if (a.limb_[i] == 0) continue;
      Unsigned128 carry = 0;
      for (std::size_t j = 0; i + j < limbs; ++j) {
        carry += Unsigned128{a.limb_[i]} * b.limb_[j] + product.limb_[i + j];
        product.limb_[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
    }
    return product;
  }
  /// Domain: shift below 64 limbs.
  friend constexpr Wide operator<<(const Wide& a, int shift) noexcept {
    const auto whole = static_cast<std::size_t>(shift / 64);
    const int rest = shift % 64;
    Wide moved;
    for (std::size_t k = whole; k < limbs; ++k) {
      moved.limb_[k] = a.limb_[k - whole] << rest;
      if (rest != 0 && k > whole) moved.limb_[k] |= a.limb_[k - whole - 1] >> (64 - rest);
    }
    return moved;
  }

  /// The number of bits of a.  Domain: a >= 0.
  friend constexpr int bit_width(const Wide& a) noexcept {
    std::size_t k = limbs;
    while (k > 0 && a.limb_[k - 1] == 0) --k;
    return k == 0 ? 0 : static_cast<int>(64 * (k - 1)) + static_cast<int>(std::bit_width(a.limb_[k - 1]));
  }

  /// The first 64 bits of a, the highest of them set unless a is 0.  Domain: a >= 0.
  friend constexpr std::uint64_t leading(const Wide& a) noexcept {
    std::size_t k = limbs;
    while (k > 0 && a.limb_[k - 1] == 0) --k;
    if (k == 0) return 0;
    const int shift = std::countl_zero(a.limb_[k - 1]);
    return a.limb_[k - 1] << shift | (shift == 0 || k == 1 ? 0 : a.limb_[k - 2] >> (64 - shift));
  }

  constexpr bool negative() const noexcept { return limb_[limbs - 1] >> 63 != 0; }
  friend constexpr bool operator==(const Wide&, const Wide&) noexcept = default;
  friend constexpr bool operator<(const Wide& a, const Wide& b) noexcept { return (a - b).negative(); }
  friend constexpr bool operator>(const Wide& a, const Wide& b) noexcept { return b < a; }
  friend constexpr bool operator<=(const Wide& a, const Wide& b) noexcept { return !(b < a); }
  friend constexpr bool operator>=(const Wide& a, const Wide& b) noexcept { return !(a < b); }

 private:
  std::array<std::uint64_t, limbs> limb_{};
};

}  // namespace mmverify::impl
