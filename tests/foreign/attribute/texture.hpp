// Textures as numbers, and numbers as codes.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "tests/foreign/attribute/faults.hpp"

namespace mmverify::tests::foreign::attribute {

using proofs::attribute::BakeCase;
using proofs::attribute::Filter;
using proofs::attribute::Meaning;
using proofs::attribute::Picture;
using proofs::attribute::Rational;
using proofs::attribute::Rgba;
using spec::Integer;
using spec::Rational128;

/// over / under: Rational128 throws std::overflow_error where 128 bits may not hold it.
inline Rational number_as(const Rational&, const Integer& over, const Integer& under) {
  return {over, under};
}
inline Rational128 number_as(const Rational128&, const Integer& over, const Integer& under) {
  using Word = boost::multiprecision::checked_int128_t;
  if ((boost::multiprecision::abs(over) >> 100) != 0 || (under >> 100) != 0)
    throw std::overflow_error("too long");
  return {Word(over), Word(under)};
}
template <class Q>
Q ratio(std::int64_t over, std::int64_t under) {
  return number_as(Q(), Integer(over), Integer(under));
}
/// A float, exactly.
template <class Q>
Q exactly(float x) {
  int e = 0;
  const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(static_cast<double>(x), &e), 24));
  e -= 24;
  const Rational q = spec::scaled(Integer(digits), e);
  return number_as(Q(), q.numerator(), q.denominator());
}
template <class Q>
std::int64_t floor_of(const Q& q) {
  typename Q::int_type down = q.numerator() / q.denominator();
  if (down * q.denominator() > q.numerator()) --down;
  return static_cast<std::int64_t>(down);
}
inline Rational wide(const Rational& q) { return q; }
inline Rational wide(const Rational128& q) { return {Integer(q.numerator()), Integer(q.denominator())}; }

/// f(Q()) in the short numbers, or in the long ones.
template <class F>
auto exact(F f) {
  try {
    return f(Rational128());
  } catch (const std::overflow_error&) {
    return f(Rational());
  }
}

/// The texel that column (or row) i stands for; nothing for the border.
std::optional<std::uint32_t> wrapped(std::int64_t i, std::uint32_t size, proofs::attribute::Wrap, Fault);
const Rgba& texel(const Picture&, std::int64_t i, std::int64_t j, Fault);

/// Linear light at m / 510, in units of 2^-24.
std::uint32_t light_at(std::uint32_t m, Fault);

/// Some texels, each with its share; the shares add up to 1.
template <class Q>
struct Share {
  std::int64_t i, j;
  Q weight;
};
template <class Q>
using Shares = std::vector<Share<Q>>;

/// The number that a code stands for: light, code / 255, or a direction's component.
template <class Q>
Q number_of(Meaning meaning, std::size_t channel, std::uint8_t code, Fault wrong) {
  if (meaning == Meaning::srgb && (channel < 3 || wrong == alpha_on_the_curve))
    return ratio<Q>(light_at(2u * code, wrong), 1 << 24);
  if (channel < 3 && (meaning == Meaning::normal || meaning == Meaning::normal_and_length))
    return wrong == normals_around_128 ? ratio<Q>(code - 128, 128) : ratio<Q>(2 * code - 255, 255);
  return ratio<Q>(code, 255);
}

template <class Q>
Q mean_of(const Picture& p, std::size_t channel, const Shares<Q>& shares, Fault wrong) {
  Q sum(0);
  for (const Share<Q>& s : shares)
    sum += s.weight * number_of<Q>(p.meaning, channel, texel(p, s.i, s.j, wrong)[channel], wrong);
  return sum;
}

/// The codes that a texture's mean has.
template <class Q>
Rgba codes_of(const Picture&, const Shares<Q>&, Fault);
extern template Rgba codes_of(const Picture&, const Shares<Rational>&, Fault);
extern template Rgba codes_of(const Picture&, const Shares<Rational128>&, Fault);

}  // namespace mmverify::tests::foreign::attribute
