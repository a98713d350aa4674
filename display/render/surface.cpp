#include "display/render/surface.hpp"

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <variant>

namespace mmverify::render {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using boost::multiprecision::cpp_int;

cpp_int floor_of(const Rational& x) {
  const cpp_int n = numerator(x), d = denominator(x);
  const cpp_int q = n / d;
  return n < 0 && q * d != n ? cpp_int(q - 1) : q;
}

/// The cutoff of MASK, or the exact quotient of Cutoff.
Rational cutoff_of(const impl::bake::AlphaMode& mode) {
  if (const auto* mask = std::get_if<impl::bake::Mask>(&mode)) return Rational(mask->cutoff);
  const auto& cutoff = std::get<impl::bake::Cutoff>(mode);
  return Rational(cutoff.numerator) / Rational(cutoff.denominator);
}

/// The least whole k with k product >= scaled; `most` + 1 if there is none up to `most`.
std::uint64_t least_reaching(const Rational& scaled, const Rational& product, std::uint64_t most) {
  if (scaled <= 0) return 0;
  if (product == 0) return most + 1;
  const Rational least = scaled / product;
  const cpp_int whole = -floor_of(-least);
  return whole > most ? most + 1 : static_cast<std::uint64_t>(whole);
}

/// A coordinate of a hit in texels, from texel `shift`: texel k, and the fraction f behind it.
struct Along {
  std::int64_t k;
  double f, error;
  bool certain;  ///< rounding did not choose k
};
/// The bound `error` covers eight operations, each off by 2^-53 of a result of at most 4 size.
Along along(double c0, double c1, double c2, const Barycentrics& at, std::uint32_t side, double shift) {
  const double p = c0 + at.u * (c1 - c0) + at.v * (c2 - c0);
  const double x = p * side - shift;
  const double size = (std::fabs(c0) + std::fabs(c1) + std::fabs(c2)) * side + 1;
  const double error = size * 0x1p-47;
  const double k = std::floor(x);
  const double f = x - k;
  return {static_cast<std::int64_t>(k), f, error, f >= error && f <= 1 - error};
}

/// The coordinate in texels, exactly.
Rational exactly_along(float c0, float c1, float c2, const Barycentrics& at, std::uint32_t side) {
  const Rational u(at.u), v(at.v);
  const Rational p = Rational(c0) + u * (Rational(c1) - Rational(c0)) + v * (Rational(c2) - Rational(c0));
  return p * side;
}

}  // namespace

Surface::Surface(const impl::bake::Texels& texels, const impl::bake::Sampling& sampling,
                 const impl::bake::AlphaMode& mode)
    : texels_(texels), sampling_(sampling), mode_(mode) {
  // The baker's constructor checks the arguments.
  const impl::bake::TriangleBaker checked(std::span(&texels_, 1), mode, sampling);
  std::uint32_t greatest = 255;
  std::visit(
      [&]<class Texel>(const impl::bake::TexelView<Texel>& view) {
        if constexpr (std::is_same_v<Texel, float>)
          throw std::invalid_argument("Surface: texels of 32 bits");
        else
          greatest = std::numeric_limits<Texel>::max();
        width_ = view.width;
        height_ = view.height;
      },
      texels_);
  nearest_ = sampling.filter == impl::bake::Filter::nearest;
  blend_ = std::holds_alternative<impl::bake::Blend>(mode);
  const double factors = double{sampling.factors[0]} * double{sampling.factors[1]};
  factor_ = factors / greatest;
  if (blend_) return;
  const Rational scaled = cutoff_of(mode) * greatest,
                 product = Rational(sampling.factors[0]) * Rational(sampling.factors[1]);
  least_opaque_ = static_cast<std::uint32_t>(least_reaching(scaled, product, greatest));
  if (product != 0) cutoff_ = static_cast<double>(Rational(scaled / product));
}

std::array<std::int64_t, 2> Surface::texel(const impl::bake::BaseTriangle& uv, const Barycentrics& at) const {
  const Along x = along(uv[0].u, uv[1].u, uv[2].u, at, width_, 0),
              y = along(uv[0].v, uv[1].v, uv[2].v, at, height_, 0);
  if (x.certain && y.certain) return {x.k, y.k};
  return {static_cast<std::int64_t>(floor_of(exactly_along(uv[0].u, uv[1].u, uv[2].u, at, width_))),
          static_cast<std::int64_t>(floor_of(exactly_along(uv[0].v, uv[1].v, uv[2].v, at, height_)))};
}

Surface::SumBounds Surface::bounds_of_sums(std::uint32_t parts) const {
  const std::uint64_t greatest = std::holds_alternative<impl::bake::TexelView<std::uint8_t>>(texels_)
                                     ? std::numeric_limits<std::uint8_t>::max()
                                     : std::numeric_limits<std::uint16_t>::max();
  const std::uint64_t most = parts * greatest;
  const Rational product = Rational(sampling_.factors[0]) * Rational(sampling_.factors[1]);
  const auto from = [&](const Rational& alpha) { return least_reaching(alpha * most, product, most); };
  if (!blend_) {
    const std::uint64_t least = from(cutoff_of(mode_));
    return {least, least, least};
  }
  return {from(1), product == 0 ? most + 1 : 1, from(Rational(1, 2))};
}

std::uint32_t Surface::code(std::int64_t x, std::int64_t y) const noexcept {
  const std::int64_t i = impl::bake::wrapped(sampling_.u, x, width_),
                     j = impl::bake::wrapped(sampling_.v, y, height_);
  if (i < 0 || j < 0) return static_cast<std::uint32_t>(sampling_.border);
  return std::visit(
      [&](const auto& view) {
        return static_cast<std::uint32_t>(
            view.texels[static_cast<std::size_t>(j) * view.pitch + static_cast<std::size_t>(i)]);
      },
      texels_);
}

bool Surface::opaque(const impl::bake::BaseTriangle& uv, const Barycentrics& at, float chance) const {
  // Coordinates are in texels from texel 0's centre, or from its corner if nearest_.
  const double shift = nearest_ ? 0 : 0.5;
  const Along x = along(uv[0].u, uv[1].u, uv[2].u, at, width_, shift),
              y = along(uv[0].v, uv[1].v, uv[2].v, at, height_, shift);
  const auto value = [&](const std::array<std::uint32_t, 4>& c) {
    const double top = c[0] + x.f * (double(c[1]) - c[0]), bottom = c[2] + x.f * (double(c[3]) - c[2]);
    return top + y.f * (bottom - top);
  };
  if (blend_) {
    if (nearest_) return code(x.k, y.k) * factor_ > double{chance};
    return value({code(x.k, y.k), code(x.k + 1, y.k), code(x.k, y.k + 1), code(x.k + 1, y.k + 1)}) * factor_ >
           double{chance};
  }
  if (!x.certain || !y.certain) return opaque_exactly(uv, at);
  if (nearest_) return code(x.k, y.k) >= least_opaque_;
  const std::array<std::uint32_t, 4> c{code(x.k, y.k), code(x.k + 1, y.k), code(x.k, y.k + 1),
                                       code(x.k + 1, y.k + 1)};
  int above = 0;
  for (const std::uint32_t one : c) above += one >= least_opaque_;
  if (above == 0 || above == 4) return above == 4;
  const double v = value(c);
  const double error = 65536 * (x.error + y.error + 0x1p-50) + cutoff_ * 0x1p-52;
  if (std::fabs(v - cutoff_) > error) return v > cutoff_;
  return opaque_exactly(uv, at);
}

bool Surface::opaque_exactly(const impl::bake::BaseTriangle& uv, const Barycentrics& at) const {
  const Rational shift = nearest_ ? Rational(0) : Rational(1, 2);
  const Rational x = exactly_along(uv[0].u, uv[1].u, uv[2].u, at, width_) - shift,
                 y = exactly_along(uv[0].v, uv[1].v, uv[2].v, at, height_) - shift;
  const cpp_int kx = floor_of(x), ky = floor_of(y);
  const auto i = static_cast<std::int64_t>(kx), j = static_cast<std::int64_t>(ky);
  if (nearest_) return code(i, j) >= least_opaque_;
  const Rational fx = x - kx, fy = y - ky;
  const Rational top = code(i, j) * (1 - fx) + code(i + 1, j) * fx,
                 bottom = code(i, j + 1) * (1 - fx) + code(i + 1, j + 1) * fx;
  const Rational value = top * (1 - fy) + bottom * fy;
  const Rational scale = std::holds_alternative<impl::bake::TexelView<std::uint8_t>>(texels_) ? 255 : 65535;
  return value * Rational(sampling_.factors[0]) * Rational(sampling_.factors[1]) >= cutoff_of(mode_) * scale;
}

}  // namespace mmverify::render
