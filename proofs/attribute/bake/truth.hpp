// What the specification makes of a case of baking.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <stdexcept>
#include <type_traits>

#include "proofs/attribute/bake/functions.hpp"
#include "spec/attribute/normal.hpp"

namespace mmverify::proofs::attribute {

constexpr bool is_normal(Meaning m) { return m == Meaning::normal || m == Meaning::normal_and_length; }

/// One channel as a texture of the specification.
template <class Texel>
spec::attribute::TextureOf<Texel> channel_of(const Picture& p, std::size_t channel, Filter filter) {
  spec::attribute::TextureOf<Texel> t{p.width, p.height};
  for (const Rgba& texel : p.texels) t.alpha.push_back(Texel{texel[channel]});
  t.wrap_x = p.wrap_u;
  t.wrap_y = p.wrap_v;
  t.border = Texel{p.border[channel]};
  t.filter = filter;
  return t;
}

template <class Q>
spec::attribute::BaseTriangle<Q> base_triangle(const UvTriangle& uv) {
  const auto vertex = [&](std::size_t k) {
    return spec::bake::place<Q>({std::bit_cast<std::uint32_t>(uv[2 * k])},
                                {std::bit_cast<std::uint32_t>(uv[2 * k + 1])});
  };
  return {vertex(0), vertex(1), vertex(2)};
}

/// The codes of numbers that `value(texture of a channel)` gives, rounded as the specification says.
template <class Value>
Rgba true_codes(const Picture& p, Filter filter, Value value) {
  using spec::attribute::Normal8, spec::attribute::Rounded, spec::attribute::Srgb8;
  const auto linear = [&](std::size_t k) {
    return Rounded<std::uint8_t>::of(value(channel_of<std::uint8_t>(p, k, filter)));
  };
  Rgba codes{};
  if (p.meaning == Meaning::linear) {
    for (std::size_t k = 0; k < 4; ++k) codes[k] = linear(k);
    return codes;
  }
  if (p.meaning == Meaning::srgb) {
    for (std::size_t k = 0; k < 3; ++k)
      codes[k] = Rounded<Srgb8>::of(value(channel_of<Srgb8>(p, k, filter))).code;
    codes[3] = linear(3);
    return codes;
  }
  using Q = std::decay_t<decltype(value(channel_of<Normal8>(p, 0, filter)))>;
  spec::attribute::Vector3<Q> m;
  for (std::size_t k = 0; k < 3; ++k) m[k] = value(channel_of<Normal8>(p, k, filter));
  const auto d = spec::attribute::direction(m);
  for (std::size_t k = 0; k < 3; ++k) codes[k] = d[k].code;
  codes[3] = p.meaning == Meaning::normal ? linear(3) : spec::attribute::length_code(m);
  return codes;
}

/// The shares that a case's texels have in each micro-vertex (W-minor order), or face (on the curve).
template <class Q>
std::vector<spec::attribute::Shares<Q>> vertex_shares(const BakeCase& one, Level n);
template <class Q>
std::vector<spec::attribute::Shares<Q>> face_shares(const BakeCase& one, Level n);

/// f(Q()), in 127 bits where they hold what it makes, else in as many as it takes.
template <class F>
auto in_few_bits(F f) {
  try {
    return f(spec::Rational128());
  } catch (const std::overflow_error&) {
    return f(Rational());
  }
}
inline Rational wide(const Rational& q) { return q; }
inline Rational wide(const spec::Rational128& q) {
  return Rational(spec::Integer(q.numerator()), spec::Integer(q.denominator()));
}

/// The map of a case.
std::vector<Rgba> true_vertices(const BakeCase& one, Level n);
std::vector<Rgba> true_faces(const BakeCase& one, Level n);

/// A channel's number in a picture's meaning: linear light, or code / 255 as it is stored.
template <class Q>
Q number_of(const Picture& p, std::size_t channel, std::uint8_t code) {
  if (p.meaning == Meaning::srgb && channel < 3)
    return spec::attribute::number<Q>(spec::attribute::Srgb8{code});
  return spec::attribute::number<Q>(code);
}

}  // namespace mmverify::proofs::attribute
