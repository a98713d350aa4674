#include "impl/bake/texture/limits.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace mmverify::impl::bake::detail {
namespace {

/// The fraction n / d of whole numbers, in lowest terms.
struct Fraction {
  Binary n, d;
};

Fraction over(std::int64_t n, std::int64_t d) {
  const std::int64_t common = std::gcd(n, d);
  return {normal(n / common, 0), normal(d / common, 0)};
}

}  // namespace

Limits limits_of(const AlphaMode& mode, const std::array<float, 2>& factors, std::int64_t full) {
  Limits limits;
  for (const float factor : factors) {
    if (!std::isfinite(factor)) throw std::invalid_argument("bake: a factor that is not finite");
    if (factor < 0) throw std::invalid_argument("bake: a factor below 0");
    if (factor == 0) limits.zero = true;
  }
  const auto limit = [&](const Fraction& cutoff) {
    return Limit{{binary(factors[0]), binary(factors[1]), cutoff.d}, cutoff.n};
  };
  if (const auto* const ratio = std::get_if<Cutoff>(&mode)) {
    if (ratio->denominator == 0) throw std::invalid_argument("bake: a cutoff over 0");
    limits.opaque = limits.lean = limit(over(full * std::int64_t{ratio->numerator}, ratio->denominator));
  } else if (const auto* const mask = std::get_if<Mask>(&mode)) {
    if (!std::isfinite(mask->cutoff)) throw std::invalid_argument("bake: a cutoff that is not finite");
    const Binary cutoff = binary(mask->cutoff);
    limits.opaque = limits.lean = limit({normal(cutoff.m * full, cutoff.e), normal(1, 0)});
  } else {
    limits.blend = true;
    limits.opaque = limit({normal(full, 0), normal(1, 0)});
    limits.lean = limit({normal(full, -1), normal(1, 0)});
  }
  return limits;
}

}  // namespace mmverify::impl::bake::detail
