// Vectors of square opacity maps: states, the eight transforms, the codes of 2x2 and 4x4 vectors, and the region of a
// hit on either triangle of a pair.  spec/vq/block.hpp has the blocks.
//
// Axes.  x counts regions from the left, y from the BOTTOM, as the papers' "X = Y" needs: only with y upwards do the
// rows of table 1, in the order of its caption, give the results that it names (docs/ERRATA.md has the order of the
// text).  The left lower triangle of the pair is the half x + y < side.
// Source: Compressed Opacity Maps, sections 3 to 5.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>

#include "spec/rational.hpp"

namespace mmverify::spec::vq {

/// The state of one region.  Its values are the indices of uniform vectors (4, "{0, 1, 2} to {T, C, O}").
enum class State : std::uint8_t {
  T = 0,  ///< transparent
  C = 1,  ///< check the texture
  O = 2,  ///< opaque
};

/// A vector of side x side regions, (x, y) at x + side y.
template <std::size_t side>
using Vector = std::array<State, side * side>;

template <std::size_t side>
constexpr Vector<side> uniform(State s) {
  Vector<side> v{};
  v.fill(s);
  return v;
}

// ---- Transforms (4.1, table 1)

/// A row of table 1: the base transforms that are applied, "right to left", the rotation first, Reflect LR last.  Its
/// number is 4 LR + 2 TB + R90: the row's digits.
struct Transform {
  bool reflect_lr = false, reflect_tb = false, rotate_90 = false;

  constexpr bool operator==(const Transform&) const = default;
  constexpr std::uint32_t number() const {
    return (reflect_lr ? 4u : 0u) + (reflect_tb ? 2u : 0u) + (rotate_90 ? 1u : 0u);
  }
  /// Domain: number < 8.
  static constexpr Transform of(std::uint32_t number) {
    return {(number & 4) != 0, (number & 2) != 0, (number & 1) != 0};
  }
};

/// A region of a square map: column and row.
struct Region {
  std::uint32_t x, y;
  constexpr bool operator==(const Region&) const = default;
};

/// The region to which a transform moves a region's state: R90 (anticlockwise) (x, y) -> (last - y, x), TB (x, last -
/// y), LR (last - x, y).  Domain: x and y below side.
template <std::size_t side>
constexpr Region moved(Transform t, Region r) {
  constexpr std::uint32_t last = side - 1;
  if (t.rotate_90) r = {last - r.y, r.x};
  if (t.reflect_tb) r.y = last - r.y;
  if (t.reflect_lr) r.x = last - r.x;
  return r;
}

/// The region that a transform fills this one from: moved's inverse, the base transforms undone in the other
/// order.
template <std::size_t side>
constexpr Region filled_from(Transform t, Region r) {
  constexpr std::uint32_t last = side - 1;
  if (t.reflect_lr) r.x = last - r.x;
  if (t.reflect_tb) r.y = last - r.y;
  if (t.rotate_90) r = {r.y, last - r.x};
  return r;
}

/// The vector, transformed.
template <std::size_t side>
constexpr Vector<side> applied(Transform t, const Vector<side>& v) {
  Vector<side> out{};
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const Region to = moved<side>(t, {x, y});
      out[to.x + side * to.y] = v[x + side * y];
    }
  return out;
}

/// The row of table 1 for first `first` and then `then`: the one that moves the corner (0, 0) and its neighbour (1, 0)
/// alike.
constexpr Transform composed(Transform then, Transform first) {
  for (std::uint32_t k = 0; k < 8; ++k) {
    const Transform t = Transform::of(k);
    if (moved<2>(t, {0, 0}) == moved<2>(then, moved<2>(first, {0, 0})) &&
        moved<2>(t, {1, 0}) == moved<2>(then, moved<2>(first, {1, 0})))
      return t;
  }
  throw std::logic_error("vq: the transforms are no group");
}

// ---- Valid vectors (2, 4, 5.1)

/// Whether no 2x2 window, overlapping ones included, has both O and T: continuous alpha gives no others.
template <std::size_t side>
constexpr bool valid(const Vector<side>& v) {
  for (std::size_t y = 0; y + 1 < side; ++y)
    for (std::size_t x = 0; x + 1 < side; ++x) {
      bool o = false, t = false;
      for (const std::size_t at :
           {x + side * y, x + 1 + side * y, x + side * (y + 1), x + 1 + side * (y + 1)}) {
        o = o || v[at] == State::O;
        t = t || v[at] == State::T;
      }
      if (o && t) return false;
    }
  return true;
}

// ---- Codes of vectors (figure 4, 5.1)
// The order of the bits is ours, as the figures do not show it.  Every code word decodes; several may mean the same
// vector, and encode gives the least.

/// The state of a region by its palette and its bit: C if set, else the palette's other state.
constexpr State picked(bool opaque_palette, bool checked) {
  return checked ? State::C : opaque_palette ? State::O : State::T;
}

/// The palette flag that a set of states needs: 0 {T, C} (also if all are C), 1 {O, C}; none if it has both O and T.
template <class States>
constexpr std::optional<bool> palette_of(const States& states) {
  bool o = false, t = false;
  for (const State s : states) {
    o = o || s == State::O;
    t = t || s == State::T;
  }
  if (o && t) return std::nullopt;
  return o;
}

/// A 2x2 vector from 5 bits: bits 0..3 are the regions, bit 4 the palette.  Domain: code < 32.
constexpr Vector<2> decode_mini(std::uint32_t code) {
  Vector<2> v{};
  for (std::uint32_t k = 0; k < 4; ++k) v[k] = picked((code >> 4 & 1) != 0, (code >> k & 1) != 0);
  return v;
}

/// The 5 bits of a 2x2 vector; none if it holds O beside T.  All C has palette 0.
constexpr std::optional<std::uint32_t> encode_mini(const Vector<2>& v) {
  const auto palette = palette_of(v);
  if (!palette) return std::nullopt;
  std::uint32_t code = *palette ? 16 : 0;
  for (std::uint32_t k = 0; k < 4; ++k) code |= (v[k] == State::C ? 1u : 0u) << k;
  return code;
}

/// The forms of a 4x4 vector's code (table 2).
enum class Code4 : std::uint8_t {
  simple,    ///< 17 bits: one palette for all, bit 16
  vertical,  ///< 18 bits: the columns x < 2 and x >= 2 have their own, bits 16 and 17: a vertical line parts
             ///< them
  horizontal,  ///< 18 bits: the rows y < 2 and y >= 2 have their own, bits 16 and 17
  generic,     ///< 20 bits: four 5-bit codes of 2x2 vectors, that of (x/2, y/2) from bit 5 (x/2 + 2 (y/2)) on
};

constexpr std::uint32_t bits_of(Code4 how) {
  switch (how) {
    case Code4::simple: return 17;
    case Code4::vertical:
    case Code4::horizontal: return 18;
    case Code4::generic: break;
  }
  return 20;
}

/// The palette flag of a region, counted from bit 16 on.
constexpr std::uint32_t palette_at(Code4 how, std::uint32_t x, std::uint32_t y) {
  return how == Code4::vertical ? x / 2 : how == Code4::horizontal ? y / 2 : 0;
}

/// The vector of a code.  Domain: code < 2^bits_of(how).
constexpr Vector<4> decode_vector(Code4 how, std::uint32_t code) {
  Vector<4> v{};
  for (std::uint32_t y = 0; y < 4; ++y)
    for (std::uint32_t x = 0; x < 4; ++x)
      if (how == Code4::generic) {
        const Vector<2> mini = decode_mini(code >> (5 * (x / 2 + 2 * (y / 2))) & 31);
        v[x + 4 * y] = mini[x % 2 + 2 * (y % 2)];
      } else {
        v[x + 4 * y] =
            picked((code >> (16 + palette_at(how, x, y)) & 1) != 0, (code >> (x + 4 * y) & 1) != 0);
      }
  return v;
}

/// The code of a vector, the least if several mean it; none if this form cannot write it.
constexpr std::optional<std::uint32_t> encode_vector(Code4 how, const Vector<4>& v) {
  std::uint32_t code = 0;
  if (how == Code4::generic) {
    for (std::uint32_t m = 0; m < 4; ++m) {
      const std::uint32_t corner = 2 * (m % 2) + 8 * (m / 2);
      const auto mini = encode_mini({v[corner], v[corner + 1], v[corner + 4], v[corner + 5]});
      if (!mini) return std::nullopt;
      code |= *mini << (5 * m);
    }
    return code;
  }
  for (std::uint32_t part = 0; part < bits_of(how) - 16; ++part) {
    Vector<4> of_part = uniform<4>(State::C);
    for (std::uint32_t k = 0; k < 16; ++k)
      if (palette_at(how, k % 4, k / 4) == part) of_part[k] = v[k];
    const auto palette = palette_of(of_part);
    if (!palette) return std::nullopt;
    code |= (*palette ? 1u : 0u) << (16 + part);
  }
  for (std::uint32_t k = 0; k < 16; ++k) code |= (v[k] == State::C ? 1u : 0u) << k;
  return code;
}

// ---- From a hit to a region (3)

/// The triangle of the pair: the lower has the corners (0,0), (1,0), (0,1) of the map's unit square, the upper (1,1),
/// (0,1), (1,0), each in the order of the barycentrics w, u, v.
enum class Half : std::uint8_t { lower, upper };

/// The region of a hit: (u, v) itself in the lower triangle, (1-u, 1-v) in the upper, times side, rounded down; the far
/// edges belong to the last region.  A point of the shared edge is in the same region from either triangle.
/// Domain: u, v >= 0 and u + v <= 1.
template <std::size_t side>
Region region_of(Half half, const Rational& u, const Rational& v) {
  const Rational s = half == Half::lower ? u : Rational(1) - u, t = half == Half::lower ? v : Rational(1) - v;
  const auto along = [](const Rational& a) {
    const std::uint32_t k = whole(a * Rational(side));
    return k < side ? k : static_cast<std::uint32_t>(side - 1);
  };
  return {along(s), along(t)};
}

}  // namespace mmverify::spec::vq
