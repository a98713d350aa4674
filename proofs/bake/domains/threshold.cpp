#include "proofs/bake/domains/threshold.hpp"

#include <cmath>
#include <limits>

#include "proofs/bake/truth/exact_texture.hpp"
#include "proofs/points/point.hpp"

namespace mmverify::proofs::bake {
namespace {

using spec::Integer;
using spec::Rational;
using spec::bake::Binary32;

/// A number in [2^e, 2^(e+1)) with any significand.
float any_of(Random& random, int e) {
  return std::ldexp(static_cast<float>((1u << 23) + random.below(1u << 23)), e - 23);
}

Rational exact_texel(Texel texel, std::uint32_t stored) {
  switch (texel) {
    case Texel::unorm8: return spec::bake::number<Rational>(static_cast<std::uint8_t>(stored));
    case Texel::unorm16: return spec::bake::number<Rational>(static_cast<std::uint16_t>(stored));
    case Texel::float32: break;
  }
  return spec::bake::number<Rational>(Binary32{stored});
}

std::optional<Cutoff> as_cutoff(const Rational& q) {
  const Integer limit = std::numeric_limits<std::uint32_t>::max();
  if (q < 0 || q.numerator() > limit || q.denominator() > limit) return std::nullopt;
  return Cutoff{static_cast<std::uint32_t>(q.numerator()), static_cast<std::uint32_t>(q.denominator())};
}

/// The quotient with the smallest numerator and denominator strictly between two.  Domain: 0 <= a < b.
Rational simplest_between(const Rational& a, const Rational& b) {
  const Integer down = a.numerator() / a.denominator();
  if (Rational(down + 1) < b) return Rational(down + 1);
  // Both numbers lie within [down, down + 1].
  const Rational low = a - down, high = b - down;
  if (low == 0)
    return Rational(down) + Rational(Integer(1), Integer(high.denominator() / high.numerator() + 1));
  return Rational(down) + 1 / simplest_between(1 / high, 1 / low);
}

/// The alpha of a baker that multiplies in rounded numbers, in one of three orders.
template <class Float>
Float rounded(const Case& one, std::uint32_t stored, Random& random) {
  const auto full = static_cast<Float>(one.texel == Texel::unorm8 ? 255 : 65535);
  const Float x = one.texel == Texel::float32 ? static_cast<Float>(std::bit_cast<float>(stored))
                                              : static_cast<Float>(stored) / full,
              f = one.factor, g = one.vertex_factor;
  switch (random.below(3)) {
    case 0: return x * f * g;
    case 1: return x * (f * g);
    default: return x * g * f;
  }
}

/// The texel whose alpha is nearest to a number.
std::uint32_t texel_near(const Case& one, double alpha) {
  const double product = double{one.factor} * one.vertex_factor, x = product > 0 ? alpha / product : 1;
  switch (one.texel) {
    case Texel::unorm8: return static_cast<std::uint32_t>(std::clamp(std::nearbyint(x * 255), 0.0, 255.0));
    case Texel::unorm16:
      return static_cast<std::uint32_t>(std::clamp(std::nearbyint(x * 65535), 0.0, 65535.0));
    case Texel::float32: break;
  }
  return std::bit_cast<std::uint32_t>(static_cast<float>(std::clamp(x, 0.0, 2.5)));
}

/// The greatest quotient with that denominator at or below alpha.
std::optional<Cutoff> over(std::uint32_t denominator, const Rational& alpha) {
  const Integer numerator = alpha.numerator() * denominator / alpha.denominator();
  if (numerator > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return Cutoff{static_cast<std::uint32_t>(numerator), denominator};
}

/// The cutoff that lies, by its kind, on the alpha of texel t or a hair beside it.
Cutoff cutoff_at(const Case& one, std::uint8_t kind, std::uint32_t t, Random& random) {
  const Rational value = exact_texel(one.texel, t),
                 alpha = value * points::rational(one.factor) * points::rational(one.vertex_factor);
  // The cutoff falls back to a texel's value; of binary32 to one at most 2^-31 below.
  std::optional<Cutoff> cutoff;
  switch (kind) {
    case 2: cutoff = as_cutoff(alpha); break;
    case 3:
    case 4: {
      const Rational other = kind == 3 ? points::rational(rounded<float>(one, t, random))
                                       : points::rational(rounded<double>(one, t, random));
      if (other != alpha && alpha > 0)
        cutoff = as_cutoff(simplest_between(std::min(alpha, other), std::max(alpha, other)));
      if (!cutoff) cutoff = as_cutoff(alpha);
      break;
    }
    case 8: {
      cutoff = over(0xfffffffb, alpha);
      if (cutoff && cutoff->numerator < 0xffffffff && random.below(2) != 0) ++cutoff->numerator;
      break;
    }
    case 9: {
      const Rational beside =
          value + (random.below(2) != 0 ? 1 : -1) * Rational(Integer(1), Integer(255) << 16);
      cutoff = as_cutoff(beside);
      break;
    }
    default: break;
  }
  if (!cutoff) cutoff = as_cutoff(value);
  if (!cutoff) cutoff = over(0x80000000, value);
  return cutoff.value_or(Cutoff{1, 2});
}

}  // namespace

std::uint32_t lowest(Texel texel) {
  return texel == Texel::float32 ? std::bit_cast<std::uint32_t>(-2.0f) : 0;
}

std::uint32_t highest(Texel texel) {
  return texel == Texel::unorm8 ? 255 : texel == Texel::unorm16 ? 65535 : std::bit_cast<std::uint32_t>(3.0f);
}

std::uint32_t stepped(Texel texel, std::uint32_t stored, int steps) {
  if (texel != Texel::float32)
    return static_cast<std::uint32_t>(
        std::clamp<std::int64_t>(std::int64_t{stored} + steps, 0, std::int64_t{highest(texel)}));
  auto x = std::bit_cast<float>(stored);
  for (; steps > 0; --steps) x = std::nextafter(x, 3.0f);
  for (; steps < 0; ++steps) x = std::nextafter(x, -2.0f);
  return std::bit_cast<std::uint32_t>(x);
}

std::uint32_t any_texel(Texel texel, Random& random) {
  if (texel == Texel::float32)
    return random.below(2) != 0
               ? std::bit_cast<std::uint32_t>(any_of(random, -1 - static_cast<int>(random.below(6))))
               : std::bit_cast<std::uint32_t>(static_cast<float>(1 + random.below(255)) / 255);
  return static_cast<std::uint32_t>(random.below(std::uint64_t{highest(texel)} + 1));
}

double value_of(Texel texel, std::uint32_t stored) {
  return texel == Texel::float32 ? double{std::bit_cast<float>(stored)}
                                 : static_cast<double>(stored) / static_cast<double>(highest(texel));
}

void set_factors(Case& one, std::uint8_t factor, std::uint8_t vertex, Random& random) {
  const std::array<float, 7> factors{1,
                                     0.5f,
                                     0.3f,
                                     1.25f,
                                     any_of(random, static_cast<int>(random.below(3)) - 2),
                                     0,
                                     std::ldexp(static_cast<float>(1 + random.below(7)), -100)};
  one.factor = factors[factor];
  const std::array<float, 7> vertices{
      1,
      0.5f,
      0.7f,
      any_of(random, static_cast<int>(random.below(3)) - 2),
      one.factor > 0 ? 1 / one.factor : 1,
      0,
      std::ldexp(static_cast<float>(1 + random.below(7)), factor == 6 ? 98 : 20)};
  one.vertex_factor = vertices[vertex];
}

std::uint32_t set_cutoff(Case& one, std::uint8_t kind, Random& random) {
  one.blend = false;
  const auto fixed = [&](const Cutoff& cutoff) {
    one.cutoff = cutoff;
    return texel_near(one, static_cast<double>(cutoff.numerator) / static_cast<double>(cutoff.denominator));
  };
  const auto texel = [&] {
    const std::uint32_t t = any_texel(one.texel, random);
    return t == 0 ? 1 : t;
  };
  switch (kind) {
    case 0: return fixed({1, 2});
    case 5: return fixed(random.below(2) != 0 ? Cutoff{0, 1} : Cutoff{0, 0xfffffffb});
    case 6: return fixed({1, 1});
    case 7: return fixed(random.below(2) != 0 ? Cutoff{3, 2} : Cutoff{256, 255});
    case 9:
      if (random.below(2) != 0) return fixed(random.below(2) != 0 ? Cutoff{1, 3} : Cutoff{2, 3});
      break;  // else a cutoff a hair beside a texel's value
    case 10: {
      one.blend = true;
      return texel_near(one, random.below(3) == 0 ? 0 : 1);
    }
    default: break;
  }
  const std::uint32_t t = texel();
  one.cutoff = cutoff_at(one, kind, t, random);
  return t;
}

}  // namespace mmverify::proofs::bake
