// A case in the specification's words, over any of its exact numbers.
#pragma once

#include <bit>
#include <span>

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

template <class Q>
spec::bake::BaseTriangle<Q> base_triangle(const Case& one) {
  const auto vertex = [&](std::size_t k) {
    return spec::bake::place<Q>({std::bit_cast<std::uint32_t>(one.uv[2 * k])},
                                {std::bit_cast<std::uint32_t>(one.uv[2 * k + 1])});
  };
  return {vertex(0), vertex(1), vertex(2)};
}

/// The movement of a case's vertices, in texture coordinates.
template <class Q>
spec::bake::TexturePoint<Q> travel_of(const Case& one) {
  return spec::bake::place<Q>({std::bit_cast<std::uint32_t>(one.travel[0])},
                              {std::bit_cast<std::uint32_t>(one.travel[1])});
}

template <class Stored>
Stored stored_as(std::uint32_t bits) {
  if constexpr (std::is_same_v<Stored, spec::bake::Binary32>)
    return {bits};
  else
    return static_cast<Stored>(bits);
}

template <class Stored>
std::vector<spec::bake::TextureOf<Stored>> textures(const Case& one) {
  std::vector<spec::bake::TextureOf<Stored>> mips;
  auto from = one.alpha.begin();
  for (std::uint32_t k = 0; k < one.mips; ++k) {
    spec::bake::TextureOf<Stored> t{std::max(1u, one.width >> k), std::max(1u, one.height >> k)};
    const auto count = static_cast<std::ptrdiff_t>(std::size_t{t.width} * t.height);
    std::transform(from, from + count, std::back_inserter(t.alpha), stored_as<Stored>);
    from += count;
    t.wrap_x = one.wrap_u;
    t.wrap_y = one.wrap_v;
    t.border = stored_as<Stored>(one.border);
    t.factor = {std::bit_cast<std::uint32_t>(one.factor)};
    t.vertex_factor = {std::bit_cast<std::uint32_t>(one.vertex_factor)};
    t.filter = one.filter;
    mips.push_back(std::move(t));
  }
  return mips;
}

/// f(mips), of the texels' own type.
template <class F>
auto with_textures(const Case& one, F f) {
  switch (one.texel) {
    case Texel::unorm16: return f(textures<std::uint16_t>(one));
    case Texel::float32: return f(textures<spec::bake::Binary32>(one));
    case Texel::unorm8: break;
  }
  return f(textures<std::uint8_t>(one));
}

/// f(mode), MASK or BLEND.
template <class Q, class F>
auto with_mode(bool blend, const Cutoff& cutoff, const Rules& rules, Threshold threshold, F f) {
  if (blend) return f(spec::bake::Blend<Q>{});
  Q at = spec::bake::fraction<Q>(cutoff.numerator, cutoff.denominator);
  if (rules.slack != 0 && threshold != Threshold::exact) {
    const Q slack = spec::bake::number<Q>(spec::bake::Binary32{std::bit_cast<std::uint32_t>(rules.slack)});
    at = threshold == Threshold::lower ? Q(at - slack) : Q(at + slack);
  }
  return rules.above ? f(spec::bake::MaskAbove<Q>{at}) : f(spec::bake::Mask<Q>{at});
}

template <class Q, class F>
auto with_mode(const Case& one, F f, Threshold threshold = Threshold::exact) {
  return with_mode<Q>(one.blend, one.cutoff, one.rules, threshold, f);
}

}  // namespace mmverify::proofs::bake
