// The true maps of a case, by the specification of baking.
#pragma once

#include "proofs/attribute/bake/functions.hpp"
#include "proofs/points/narrow.hpp"
#include "spec/attribute/normal.hpp"
#include "spec/attribute/order.hpp"

namespace mmverify::proofs::attribute {

constexpr bool is_normal(Meaning m) { return m == Meaning::normal || m == Meaning::normal_and_length; }

/// A channel as the specification's texel, and one channel of a picture as its texture.
template <class Texel, class Channel>
Texel stored(Channel c) {
  if constexpr (std::is_same_v<Channel, float>)
    return Texel{bits_of(c)};
  else
    return Texel{c};
}
template <class Texel, class Channel>
spec::attribute::TextureOf<Texel> channel_of(const PictureOf<Channel>& p, std::size_t channel,
                                             Filter filter) {
  spec::attribute::TextureOf<Texel> t{p.width, p.height};
  for (const auto& texel : p.texels) t.alpha.push_back(stored<Texel>(texel[channel]));
  t.wrap_x = p.wrap_u;
  t.wrap_y = p.wrap_v;
  t.border = stored<Texel>(p.border[channel]);
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

/// The true value of integer channels: codes by the picture's meaning.
template <class Channel, class Value>
RgbaOf<Channel> true_integer_codes(const PictureOf<Channel>& p, Filter filter, Value value) {
  using spec::attribute::Rounded, spec::attribute::Srgb8;
  using Normal = spec::attribute::Normal<Channel>;
  const auto linear = [&](std::size_t k) {
    return Rounded<Channel>::of(value(channel_of<Channel>(p, k, filter)));
  };
  RgbaOf<Channel> codes{};
  if (p.meaning == Meaning::linear) {
    for (std::size_t k = 0; k < 4; ++k) codes[k] = linear(k);
    return codes;
  }
  if (p.meaning == Meaning::srgb) {
    if constexpr (sizeof(Channel) == 1) {
      for (std::size_t k = 0; k < 3; ++k)
        codes[k] = Rounded<Srgb8>::of(value(channel_of<Srgb8>(p, k, filter))).code;
      codes[3] = linear(3);
      return codes;
    }
    throw std::invalid_argument("attribute: only 8 bits are on the sRGB curve");
  }
  using Q = std::decay_t<decltype(value(channel_of<Normal>(p, 0, filter)))>;
  spec::attribute::Vector3<Q> m;
  for (std::size_t k = 0; k < 3; ++k) m[k] = value(channel_of<Normal>(p, k, filter));
  const auto d = spec::attribute::direction<Channel>(m);
  for (std::size_t k = 0; k < 3; ++k) codes[k] = d[k].code;
  codes[3] = p.meaning == Meaning::normal ? linear(3) : spec::attribute::length_code<Channel>(m);
  return codes;
}

/// The true codes, or floats: the numbers that `value(texture of a channel)` gives, rounded by the specification.
template <class Channel, class Value>
RgbaOf<Channel> true_codes(const PictureOf<Channel>& p, Filter filter, Value value) {
  using spec::attribute::Binary32, spec::attribute::Rounded;
  if constexpr (std::is_same_v<Channel, float>) {
    RgbaOf<float> numbers{};
    for (std::size_t k = 0; k < 4; ++k)
      numbers[k] =
          std::bit_cast<float>(Rounded<Binary32>::of(value(channel_of<Binary32>(p, k, filter))).bits);
    return numbers;
  } else {
    return true_integer_codes(p, filter, value);
  }
}
/// The true codes of one element of a map: a micro-vertex in W-minor order, or a face on the curve.
template <class Q, class Channel>
RgbaOf<Channel> true_at(MapForm form, const BakeCaseOf<Channel>& one, Level n, std::uint32_t k) {
  namespace slow = spec::attribute;
  const auto uv = base_triangle<Q>(one.uv);
  const std::uint32_t width = one.picture.width, height = one.picture.height;
  const Filter filter = form == MapForm::faces ? Filter::nearest : one.picture.filter;
  const auto shares =
      form == MapForm::faces
          ? slow::shares_on(spec::bake::micro_triangle(uv, n, k, width, height), filter)
          : slow::shares_at(
                slow::micro_vertex(uv, n, slow::vertex_at(slow::VertexOrder::w_minor, k, n), width, height),
                filter);
  return true_codes(one.picture, filter, [&](const auto& texture) { return slow::mean(texture, shares); });
}

/// The texels' shares in each micro-vertex (W-minor order) or face (on the curve) of a case.
template <class Q>
std::vector<spec::attribute::Shares<Q>> vertex_shares(const BakeCase& one, Level n);
template <class Q>
std::vector<spec::attribute::Shares<Q>> face_shares(const BakeCase& one, Level n);

/// f.operator()<Q>() with Rational128 if it holds all numbers on the way, else with Rational.
template <class F>
auto in_few_bits(F f) {
  return in_first_of<spec::Rational128, Rational>(f);
}
/// true_at() with as many bits as it needs.
template <class Channel>
RgbaOf<Channel> exact_at(MapForm form, const BakeCaseOf<Channel>& one, Level n, std::uint32_t k) {
  if constexpr (std::is_same_v<Channel, float>) return true_at<Rational>(form, one, n, k);
  return in_few_bits([&]<class Q>() { return true_at<Q>(form, one, n, k); });
}
/// The number of elements of a map.
inline std::uint64_t map_size(MapForm form, Level n) {
  return form == MapForm::faces ? spec::attribute::face_count(n) : spec::attribute::vertex_count(n);
}
inline Rational wide(const Rational& q) { return q; }
inline Rational wide(const spec::Rational128& q) {
  return Rational(spec::Integer(q.numerator()), spec::Integer(q.denominator()));
}

/// The true map of a case.
std::vector<Rgba> true_vertices(const BakeCase& one, Level n);
std::vector<Rgba> true_faces(const BakeCase& one, Level n);
/// The true map of other channel types, element by element.
template <class Channel>
std::vector<RgbaOf<Channel>> true_map(MapForm form, const BakeCaseOf<Channel>& one, Level n);

/// The number that a channel's code means: linear light, or code / 255 as it is stored.
template <class Q>
Q number_of(const Picture& p, std::size_t channel, std::uint8_t code) {
  if (p.meaning == Meaning::srgb && channel < 3)
    return spec::attribute::number<Q>(spec::attribute::Srgb8{code});
  return spec::attribute::number<Q>(code);
}

}  // namespace mmverify::proofs::attribute
