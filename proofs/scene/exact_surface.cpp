#include "proofs/scene/exact_surface.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <mutex>
#include <sstream>
#include <variant>

#include "proofs/points/narrow.hpp"
#include "proofs/scene/near_change.hpp"
#include "spec/bake/state.hpp"
#include "spec/bake/whole/state.hpp"

namespace mmverify::proofs::scene {
namespace {

namespace scene = mmverify::scene;
using namespace spec::bake;

Binary32 bits(float x) { return {std::bit_cast<std::uint32_t>(x)}; }

spec::bake::Wrap wrap(scene::Wrap w) {
  switch (w) {
    case scene::Wrap::repeat: return spec::bake::Wrap::repeat;
    case scene::Wrap::mirrored_repeat: return spec::bake::Wrap::mirrored_repeat;
    case scene::Wrap::clamp_to_edge: break;
  }
  return spec::bake::Wrap::clamp_to_edge;
}

template <class Q>
BaseTriangle<Q> base(const scene::UvTriangle& uv) {
  BaseTriangle<Q> corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = place<Q>(bits(uv[k][0]), bits(uv[k][1]));
  return corners;
}

/// The specification's texel of a stored number.
template <class Stored>
using TexelOf = std::conditional_t<std::is_same_v<Stored, float>, Binary32, Stored>;

template <class Stored>
TextureOf<TexelOf<Stored>> texture_of(const scene::Image& image, const std::vector<Stored>& alpha,
                                      const scene::Surface& surface) {
  TextureOf<TexelOf<Stored>> t;
  t.width = image.width;
  t.height = image.height;
  if constexpr (std::is_same_v<Stored, float>)
    for (const float texel : alpha) t.alpha.push_back(bits(texel));
  else
    t.alpha = alpha;
  t.wrap_x = wrap(surface.sampler.wrap_u);
  t.wrap_y = wrap(surface.sampler.wrap_v);
  t.factor = bits(surface.base_color_alpha);
  t.vertex_factor = bits(surface.vertex_alpha);
  t.filter = scene::filter_of(surface.sampler) == scene::Filter::nearest ? spec::bake::Filter::nearest
                                                                         : spec::bake::Filter::bilinear;
  return t;
}

/// Judges a micro-triangle where alpha is the texture's times a vertex alpha, linear between its corners.
template <class Q, class Texel, class Mode>
class VaryingState {
 public:
  /// Corners in texels, and the vertex alphas there: from 0 to 1.
  struct Part {
    Polygon<Q> corners;
    std::array<Q, 3> alphas;
  };

  VaryingState(const TextureOf<Texel>& texture, const Mode& mode, const Q& margin)
      : texture_(texture), mode_(mode), margin_(margin) {}

  Seen seen(const Part& whole) {
    judge(whole, halvings);
    if (is_mixed()) return {State::C, true, true};
    if (undecided_) return {std::nullopt, not_opaque_, not_transparent_};
    return {not_opaque_ ? State::T : State::O, not_opaque_, not_transparent_};
  }

 private:
  static constexpr int halvings = 3;

  bool is_mixed() const { return not_opaque_ && not_transparent_; }
  void see(const TexturePoint<Q>& at, const Q& vertex_alpha) {
    const Q here = alpha(texture_, at) * vertex_alpha;
    not_opaque_ = not_opaque_ || !mode_.opaque(here);
    not_transparent_ = not_transparent_ || !mode_.transparent(here);
  }
  State by_bounds(const Part& part) const {
    const auto [low, high] = std::minmax({part.alphas[0], part.alphas[1], part.alphas[2]});
    const Range<Q> sampled = range(texture_, dilated(part.corners, margin_));
    Range<Q> product(sampled.least * (sampled.least < 0 ? high : low));
    product.take(sampled.greatest * (sampled.greatest < 0 ? low : high));
    return state_in(mode_, product);
  }
  void judge(const Part& part, int depth) {
    const State bound = by_bounds(part);
    not_transparent_ = not_transparent_ || bound == State::O;
    not_opaque_ = not_opaque_ || bound == State::T;
    if (bound != State::C) return;
    for (std::size_t k = 0; k < 3; ++k) see(part.corners[k], part.alphas[k]);
    see(centroid(part.corners), (part.alphas[0] + part.alphas[1] + part.alphas[2]) * fraction<Q>(1, 3));
    if (depth == 0) undecided_ = true;
    for (std::size_t quarter = 0; quarter < 4 && depth != 0 && !is_mixed(); ++quarter)
      judge(quarter_of(part, quarter), depth - 1);
  }
  /// The quarter at a corner; number 3 is the one in the middle.
  static Part quarter_of(const Part& part, std::size_t quarter) {
    Part one = part;
    const Q half = fraction<Q>(1, 2);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = quarter == 3 ? (k + 1) % 3 : k, to = quarter == 3 ? (k + 2) % 3 : quarter;
      const TexturePoint<Q>&p = part.corners[from], &q = part.corners[to];
      one.corners[k] = {(p.x + q.x) * half, (p.y + q.y) * half};
      one.alphas[k] = (part.alphas[from] + part.alphas[to]) * half;
    }
    return one;
  }

  const TextureOf<Texel>& texture_;
  const Mode mode_;
  const Q margin_;
  bool not_opaque_ = false, not_transparent_ = false, undecided_ = false;
};

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
    std::visit([&](const auto& alpha) { texture_ = texture_of(image, alpha, surface); }, image.alpha);
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
  Seen seen(const scene::PlannedTriangle& planned, Level n, std::uint32_t index) const {
    return std::visit(
        [&]<class Texel>(const TextureOf<Texel>& t) {
          return in_mode<Q>([&]<class Mode>(const Mode& mode) {
            using Varying = VaryingState<Q, Texel, Mode>;
            return Varying(t, mode, number<Q>(bits(margin_)))
                .seen(
                    typename Varying::Part{micro_triangle(base<Q>(planned.uvs), n, index, t.width, t.height),
                                           vertex_alphas<Q>(planned, n, index)});
          });
        },
        texture_);
  }

  /// The vertex alphas at a micro-triangle's corners.
  template <class Q>
  static std::array<Q, 3> vertex_alphas(const scene::PlannedTriangle& planned, Level n, std::uint32_t index) {
    std::array<Q, 3> base, at;
    for (std::size_t k = 0; k < 3; ++k) base[k] = number<Q>(bits(planned.vertex_alpha[k]));
    const auto corners = spec::index::corners(index, n);
    for (std::size_t k = 0; k < 3; ++k)
      at[k] = base[0] + fraction<Q>(corners[k].i, spec::side(n)) * (base[1] - base[0]) +
              fraction<Q>(corners[k].j, spec::side(n)) * (base[2] - base[0]);
    return at;
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

  /// The search for micro-triangles near a change, made at the first call.
  const NearChange& changes() const {
    std::call_once(changes_made_, [this] {
      std::visit([this](const auto& t) { changes_ = std::make_unique<const NearChange>(t, surface_); },
                 texture_);
    });
    return *changes_;
  }

  /// The texture in whole numbers, made at the first call.
  const whole::WholeTexture& in_whole_numbers() const {
    std::call_once(made_, [this] {
      std::visit(
          [this](const auto& t) {
            in_mode<spec::Rational>(
                [&](const auto& mode) { whole_ = std::make_unique<const whole::WholeTexture>(t, mode); });
          },
          texture_);
    });
    return *whole_;
  }
  /// A micro-triangle for whole numbers.
  whole::Place place_of(const scene::UvTriangle& uv, Level n, std::uint32_t index) const {
    whole::Place place{{}, n, index, bits(margin_), {bits(surface_.travel[0]), bits(surface_.travel[1])}};
    for (std::size_t k = 0; k < 3; ++k) place.uv[k] = {bits(uv[k][0]), bits(uv[k][1])};
    return place;
  }

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
  /// The micro-triangle in texels, dilated by the margin and by its movement.
  template <class Q, class Texel>
  Polygon<Q> polygon(const TextureOf<Texel>& t, const scene::UvTriangle& uv, Level n,
                     std::uint32_t index) const {
    const Q margin = number<Q>(bits(margin_));
    const auto travel = place<Q>(bits(surface_.travel[0]), bits(surface_.travel[1]));
    return dilated(micro_triangle(base<Q>(uv), n, index, t.width, t.height),
                   Q(margin + travel.x * Q(t.width)), Q(margin + travel.y * Q(t.height)));
  }

  scene::Surface surface_;
  float margin_;
  std::variant<TextureOf<std::uint8_t>, TextureOf<std::uint16_t>, TextureOf<Binary32>> texture_;
  mutable std::once_flag made_, changes_made_;
  mutable std::unique_ptr<const whole::WholeTexture> whole_;
  mutable std::unique_ptr<const NearChange> changes_;
};

ExactSurfaces::ExactSurfaces(const scene::Scene& scene, const scene::Plan& plan, float margin) : plan_(plan) {
  for (const scene::Surface& surface : plan.surfaces)
    surfaces_.push_back(std::make_unique<const OfSurface>(scene.images[surface.image], surface, margin));
}
ExactSurfaces::~ExactSurfaces() = default;

const ExactSurfaces::OfSurface& ExactSurfaces::of(std::size_t triangle) const {
  return *surfaces_[plan_.triangles[triangle].surface];
}

std::optional<State> ExactSurfaces::state(std::size_t triangle, Level n, std::uint32_t index) const {
  const OfSurface& surface = of(triangle);
  if (plan_.triangles[triangle].varies()) return seen(triangle, n, index).state;
  const auto& uvs = plan_.triangles[triangle].uvs;
  if (const auto state = whole::state(surface.in_whole_numbers(), surface.place_of(uvs, n, index)))
    return state;
  ++in_rationals_;
  return in_few_bits([&]<class Q>() { return surface.state<Q>(uvs, n, index); });
}

Seen ExactSurfaces::seen(std::size_t triangle, Level n, std::uint32_t index) const {
  return in_few_bits([&]<class Q>() { return of(triangle).seen<Q>(plan_.triangles[triangle], n, index); });
}

bool ExactSurfaces::denies(std::size_t triangle, Level n, std::uint32_t index, bool opaque) const {
  const Seen places = seen(triangle, n, index);
  return opaque ? places.not_opaque : places.not_transparent;
}

bool ExactSurfaces::rather_opaque(std::size_t triangle, Level n, std::uint32_t index) const {
  const OfSurface& surface = of(triangle);
  const auto& uvs = plan_.triangles[triangle].uvs;
  if (const auto leans = whole::leans(surface.in_whole_numbers(), surface.place_of(uvs, n, index)))
    return *leans;
  return in_few_bits([&]<class Q>() {
    const Q alpha = surface.at_centroid<Q>(uvs, n, index);
    return surface.in_mode<Q>([&](const auto& mode) { return mode.rather_opaque(alpha); });
  });
}

namespace {

double decimal(const spec::Rational& q) { return boost::rational_cast<double>(q); }

/// A fraction that can be read at a glance as it is, another as a decimal.
std::string shortly(const spec::Rational& q) {
  std::ostringstream text;
  text << q;
  return text.str().size() <= std::string_view("65535/65536").size() ? text.str()
                                                                     : fmt::format("{:.9f}", decimal(q));
}

}  // namespace

std::string ExactSurfaces::text(std::size_t triangle, Level n, std::uint32_t index) const {
  const auto& planned = plan_.triangles[triangle];
  const OfSurface& surface = of(triangle);
  const auto alpha = surface.range<spec::Rational>(planned.uvs, n, index);
  std::string text = fmt::format("alpha {}..{}", shortly(alpha.least), shortly(alpha.greatest));
  const scene::Uv uv = surface.middle(planned.uvs, n, index);
  const auto [x, y] = surface.texel_at(uv);
  if (planned.varies()) {
    const auto alphas = OfSurface::vertex_alphas<spec::Rational>(planned, n, index);
    const auto [least, greatest] = std::minmax({alphas[0], alphas[1], alphas[2]});
    text += fmt::format(" times a vertex alpha of {}..{}", shortly(least), shortly(greatest));
  }
  return text + fmt::format(", {:.3f}..{:.3f}, at UV ({:.4f}, {:.4f}), texel ({}, {})", decimal(alpha.least),
                            decimal(alpha.greatest), uv[0], uv[1], x, y);
}

bool ExactSurfaces::near_change(std::size_t triangle, Level n, std::uint32_t index) const {
  return of(triangle).changes().at(plan_.triangles[triangle].uvs, n, index);
}

}  // namespace mmverify::proofs::scene
