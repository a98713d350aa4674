#include "display/render/surface.hpp"

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
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
  // The least code with code * product >= scaled; greatest + 1 if there is none.
  if (product == 0) {
    least_opaque_ = scaled <= 0 ? 0 : greatest + 1;
  } else {
    const Rational least = scaled / product;
    const cpp_int whole = -floor_of(-least);
    least_opaque_ = whole > greatest ? greatest + 1 : static_cast<std::uint32_t>(whole);
    cutoff_ = static_cast<double>(least);
  }
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
  struct Along {
    std::int64_t k;
    double f, error;
    bool certain;
  };
  const double shift = nearest_ ? 0 : 0.5;
  // Coordinates are in texels from texel 0's centre, or from its corner if nearest_.  The bound `error` covers
  // eight operations, each off by 2^-53 of a result of at most 4 size.
  const auto along = [&](double c0, double c1, double c2, std::uint32_t side) {
    const double p = c0 + at.u * (c1 - c0) + at.v * (c2 - c0);
    const double x = p * side - shift;
    const double size = (std::fabs(c0) + std::fabs(c1) + std::fabs(c2)) * side + 1;
    const double error = size * 0x1p-47;
    const double k = std::floor(x);
    const double f = x - k;
    return Along{static_cast<std::int64_t>(k), f, error, f >= error && f <= 1 - error};
  };
  const Along x = along(uv[0].u, uv[1].u, uv[2].u, width_), y = along(uv[0].v, uv[1].v, uv[2].v, height_);
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
  const Rational u(at.u), v(at.v);
  const auto along = [&](float c0, float c1, float c2, std::uint32_t side) {
    const Rational p = Rational(c0) + u * (Rational(c1) - Rational(c0)) + v * (Rational(c2) - Rational(c0));
    return nearest_ ? Rational(p * side) : Rational(p * side - Rational(1, 2));
  };
  const Rational x = along(uv[0].u, uv[1].u, uv[2].u, width_), y = along(uv[0].v, uv[1].v, uv[2].v, height_);
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
