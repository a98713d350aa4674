#include "proofs/scene/exact_surface.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <sstream>
#include <variant>

#include "proofs/points/narrow.hpp"
#include "spec/bake/state.hpp"

namespace mmverify::proofs::scene {
namespace {

namespace scene = mmverify::scene;
using namespace spec::bake;

Binary32 bits(float x) { return {std::bit_cast<std::uint32_t>(x)}; }

spec::bake::Wrap wrap(scene::Wrap w) {
  switch (w) {
    case scene::Wrap::repeat:
      return spec::bake::Wrap::repeat;
    case scene::Wrap::mirrored_repeat:
      return spec::bake::Wrap::mirrored_repeat;
    case scene::Wrap::clamp_to_edge:
      break;
  }
  return spec::bake::Wrap::clamp_to_edge;
}

template <class Q>
BaseTriangle<Q> base(const scene::UvTriangle& uv) {
  BaseTriangle<Q> corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = place<Q>(bits(uv[k][0]), bits(uv[k][1]));
  return corners;
}

template <class Texel>
TextureOf<Texel> texture_of(const scene::Image& image, const scene::Surface& surface) {
  TextureOf<Texel> t;
  t.width = image.width;
  t.height = image.height;
  t.alpha = std::get<std::vector<Texel>>(image.alpha);
  t.wrap_x = wrap(surface.sampler.wrap_u);
  t.wrap_y = wrap(surface.sampler.wrap_v);
  t.factor = bits(surface.base_color_alpha);
  t.vertex_factor = bits(surface.vertex_alpha);
  t.filter = scene::filter_of(surface.sampler) == scene::Filter::nearest ? spec::bake::Filter::nearest
                                                                         : spec::bake::Filter::bilinear;
  return t;
}

/// f.operator()<Q>() over the first of these rationals that holds all numbers on the way.
template <class F>
auto in_few_bits(F f) {
  return in_first_of<Rational64, spec::Rational128, spec::Rational>(f);
}

}  // namespace

class ExactSurfaces::OfSurface {
 public:
  OfSurface(const scene::Image& image, const scene::Surface& surface, float margin)
      : surface_(surface), margin_(margin) {
    if (image.bits() == 8)
      texture_ = texture_of<std::uint8_t>(image, surface);
    else
      texture_ = texture_of<std::uint16_t>(image, surface);
  }

  template <class Q>
  Range<Q> range(const scene::UvTriangle& uv, Level n, std::uint32_t index) const {
    return std::visit([&](const auto& t) { return spec::bake::range(t, polygon<Q>(t, uv, n, index)); },
                      texture_);
  }

  template <class Q>
  State state(const scene::UvTriangle& uv, Level n, std::uint32_t index) const {
    return std::visit(
        [&](const auto& t) {
          return in_mode<Q>(
              [&](const auto& mode) { return closed_state(t, polygon<Q>(t, uv, n, index), mode); });
        },
        texture_);
  }

  template <class Q>
  Q at_centroid(const scene::UvTriangle& uv, Level n, std::uint32_t index) const {
    return std::visit(
        [&](const auto& t) {
          return alpha(t, centroid(micro_triangle(base<Q>(uv), n, index, t.width, t.height)));
        },
        texture_);
  }

  /// Calls what(mode) with the specification's alpha mode.
  template <class Q, class What>
  auto in_mode(What what) const {
    return surface_.mode == scene::AlphaMode::mask ? what(Mask<Q>{number<Q>(bits(surface_.cutoff))})
                                                   : what(Blend<Q>{});
  }

  bool near_change(const scene::UvTriangle& uv, Level n, std::uint32_t index) const;

  /// The UV of a micro-triangle's centroid, rounded.
  static scene::Uv middle(const scene::UvTriangle& uv, Level n, std::uint32_t index) {
    double i = 0, j = 0;
    for (const spec::index::Vertex& v : spec::index::corners(index, n)) i += v.i, j += v.j;
    i /= 3 * spec::side(n), j /= 3 * spec::side(n);
    const auto along = [&](std::size_t axis) {
      return static_cast<float>(uv[0][axis] + i * (double{uv[1][axis]} - uv[0][axis]) +
                                j * (double{uv[2][axis]} - uv[0][axis]));
    };
    return {along(0), along(1)};
  }
  /// The column and the row of the texel at a UV, as the sampler addresses them.
  std::pair<std::uint32_t, std::uint32_t> texel_at(const scene::Uv& uv) const {
    return std::visit(
        [&](const auto& t) {
          const auto at = [](float x, std::uint32_t size) {
            return static_cast<std::int64_t>(std::floor(double{x} * size));
          };
          return std::pair(wrapped(t.wrap_x, at(uv[0], t.width), t.width).value_or(0),
                           wrapped(t.wrap_y, at(uv[1], t.height), t.height).value_or(0));
        },
        texture_);
  }

 private:
  /// The micro-triangle in texels, dilated by the margin.
  template <class Q, class Texel>
  Polygon<Q> polygon(const TextureOf<Texel>& t, const scene::UvTriangle& uv, Level n,
                     std::uint32_t index) const {
    return dilated(micro_triangle(base<Q>(uv), n, index, t.width, t.height), number<Q>(bits(margin_)));
  }

  scene::Surface surface_;
  float margin_;
  std::variant<TextureOf<std::uint8_t>, TextureOf<std::uint16_t>> texture_;
};

bool ExactSurfaces::OfSurface::near_change(const scene::UvTriangle& uv, Level n, std::uint32_t index) const {
  return std::visit(
      [&](const auto& t) {
        const double step = 1.0 / spec::side(n);
        double low_x = 1e300, high_x = -1e300, low_y = 1e300, high_y = -1e300;
        for (const spec::index::Vertex& v : spec::index::corners(index, n)) {
          const double i = v.i * step, j = v.j * step;
          const auto along = [&](std::size_t axis) {
            return uv[0][axis] + i * (double{uv[1][axis]} - uv[0][axis]) +
                   j * (double{uv[2][axis]} - uv[0][axis]);
          };
          const double x = along(0) * t.width, y = along(1) * t.height;
          low_x = std::min(low_x, x), high_x = std::max(high_x, x);
          low_y = std::min(low_y, y), high_y = std::max(high_y, y);
        }
        const auto whole = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
        if (high_x - low_x > 64 || high_y - low_y > 64)
          return true;  // of so many texels hardly one side alone
        const double most = std::is_same_v<decltype(t.alpha[0]), const std::uint8_t&> ? 255 : 65535;
        const double limit =
            surface_.mode == scene::AlphaMode::mask
                ? surface_.cutoff * most / (double{surface_.base_color_alpha} * surface_.vertex_alpha)
                : most / 2;
        const bool blend = surface_.mode == scene::AlphaMode::blend;
        bool some = false, others = false;
        for (std::int64_t j = whole(low_y - 1); j <= whole(high_y + 1); ++j)
          for (std::int64_t i = whole(low_x - 1); i <= whole(high_x + 1); ++i) {
            const auto x = wrapped(t.wrap_x, i, t.width), y = wrapped(t.wrap_y, j, t.height);
            const auto alpha = t.alpha[*x + std::size_t{*y} * t.width];
            if (blend && alpha > 0 && alpha < most) return true;
            (alpha >= limit ? some : others) = true;
            if (some && others) return true;
          }
        return false;
      },
      texture_);
}

ExactSurfaces::ExactSurfaces(const scene::Scene& scene, const scene::Plan& plan, float margin) : plan_(plan) {
  for (const scene::Surface& surface : plan.surfaces)
    surfaces_.push_back(std::make_unique<const OfSurface>(scene.images[surface.image], surface, margin));
}
ExactSurfaces::~ExactSurfaces() = default;

const ExactSurfaces::OfSurface& ExactSurfaces::of(std::size_t triangle) const {
  return *surfaces_[plan_.triangles[triangle].surface];
}

State ExactSurfaces::state(std::size_t triangle, Level n, std::uint32_t index) const {
  const OfSurface& surface = of(triangle);
  return in_few_bits([&]<class Q>() { return surface.state<Q>(plan_.triangles[triangle].uvs, n, index); });
}

bool ExactSurfaces::rather_opaque(std::size_t triangle, Level n, std::uint32_t index) const {
  const OfSurface& surface = of(triangle);
  return in_few_bits([&]<class Q>() {
    const Q alpha = surface.at_centroid<Q>(plan_.triangles[triangle].uvs, n, index);
    return surface.in_mode<Q>([&](const auto& mode) { return mode.rather_opaque(alpha); });
  });
}

std::string ExactSurfaces::text(std::size_t triangle, Level n, std::uint32_t index) const {
  const auto& planned = plan_.triangles[triangle];
  const OfSurface& surface = of(triangle);
  const auto alpha = surface.range<spec::Rational>(planned.uvs, n, index);
  std::ostringstream text;
  text << "alpha " << alpha.least << ".." << alpha.greatest;
  const auto decimal = [](const spec::Rational& q) { return boost::rational_cast<double>(q); };
  const scene::Uv uv = surface.middle(planned.uvs, n, index);
  const auto [x, y] = surface.texel_at(uv);
  return text.str() + fmt::format(", {:.3f}..{:.3f}, at UV ({:.4f}, {:.4f}), texel ({}, {})",
                                  decimal(alpha.least), decimal(alpha.greatest), uv[0], uv[1], x, y);
}

bool ExactSurfaces::near_change(std::size_t triangle, Level n, std::uint32_t index) const {
  return of(triangle).near_change(plan_.triangles[triangle].uvs, n, index);
}

}  // namespace mmverify::proofs::scene
