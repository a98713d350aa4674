#include "scene/bake/varying_alpha.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "impl/index/index.hpp"
#include "impl/micromap/micromap.hpp"
#include "scene/bake/texel_ranges.hpp"
#include "scene/bake/wrap.hpp"

namespace mmverify::scene {
namespace {

using impl::micromap::State;

/// A rounding of a coordinate, or of a vertex alpha, that is the result of a few operations on numbers up to `size`.
constexpr double rounding(double size) { return 0x1p-49 * size; }

/// Cells along a side of a box whose corners are looked at in each cell.
constexpr std::int64_t most_cells_a_side = 4;

/// Whether x y >= limit, exactly.  Domain: finite, and x y not so small that its error underflows.
bool reaches(double x, double y, double limit) {
  const double product = x * y;
  return product > limit || (product == limit && std::fma(x, y, -product) >= 0);
}

/// Bounds of x y: equal to it where binary64 holds it.  Domain: finite, no underflow.
double product_below(double x, double y) {
  const double product = x * y;
  return std::fma(x, y, -product) < 0 ? std::nextafter(product, -HUGE_VAL) : product;
}
double product_above(double x, double y) { return -product_below(-x, y); }

double least_of(const std::array<double, 3>& x) { return std::min({x[0], x[1], x[2]}); }
double greatest_of(const std::array<double, 3>& x) { return std::max({x[0], x[1], x[2]}); }

/// A function of the place that is linear between a triangle's corners.
struct Linear {
  std::array<double, 3> at;
  double operator()(double u, double v) const { return at[0] + u * (at[1] - at[0]) + v * (at[2] - at[0]); }
  double size() const { return std::max({std::fabs(at[0]), std::fabs(at[1]), std::fabs(at[2])}); }
};

/// A micro-triangle, or a node of some: its corners in u and v.
struct Node {
  std::array<double, 3> u, v;
  Node(unsigned level, std::uint32_t index) {
    const auto corners = impl::index::corners(index, level);
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = std::ldexp(corners[k].i, -static_cast<int>(level));
      v[k] = std::ldexp(corners[k].j, -static_cast<int>(level));
    }
  }
  std::array<double, 3> of(const Linear& f) const { return {f(u[0], v[0]), f(u[1], v[1]), f(u[2], v[2])}; }
};

}  // namespace

class VaryingAlphaBakers::OfSurface {
 public:
  OfSurface(const Image& image, const Surface& surface, float margin)
      : image_(image),
        surface_(surface),
        margin_(margin),
        is_linear_(filter_of(surface.sampler) == Filter::linear),
        ranges_(image),
        one_(image.bits() == 8    ? 255
             : image.bits() == 16 ? 65535
                                  : 1) {}

  void bake(const PlannedTriangle& triangle, unsigned level, std::span<std::uint8_t> map) const {
    Functions functions;
    for (std::size_t k = 0; k < 3; ++k) {
      functions.x.at[k] = double{triangle.uvs[k][0]} * image_.width;
      functions.y.at[k] = double{triangle.uvs[k][1]} * image_.height;
      functions.alpha.at[k] = triangle.vertex_alpha[k];
    }
    bake(functions, 0, 0, level, map);
  }

 private:
  /// Coordinates in texels, and vertex alpha.
  struct Functions {
    Linear x, y, alpha;
  };

  void bake(const Functions& of, unsigned depth, std::uint32_t index, unsigned level,
            std::span<std::uint8_t> map) const {
    const Node node(depth, index);
    if (const auto known = state(of, node)) return fill(map, level - depth, index, *known);
    if (depth == level) return fill(map, 0, index, side(of, node));
    for (std::uint32_t child = 0; child < 4; ++child) bake(of, depth + 1, 4 * index + child, level, map);
  }

  /// Writes the states of a node of 4^height micro-triangles.
  static void fill(std::span<std::uint8_t> map, unsigned height, std::uint32_t index, State state) {
    const auto code = static_cast<unsigned>(state);
    if (height == 0) {
      const unsigned at = 2 * (index % 4);
      map[index / 4] = static_cast<std::uint8_t>((map[index / 4] & ~(3u << at)) | code << at);
      return;
    }
    const std::size_t bytes = std::size_t{1} << (2 * (height - 1));
    std::fill_n(map.begin() + static_cast<std::ptrdiff_t>(index * bytes), bytes,
                static_cast<std::uint8_t>(code * 0x55));
  }

  /// Bounds of a number.
  struct Bounds {
    double least, greatest;
  };

  /// The coordinates of a node along an axis, less the offset of the texels' centres, and with the margin.
  Bounds along(const Linear& f, const Node& node) const {
    const std::array<double, 3> at = node.of(f);
    const double grown = margin_ + rounding(f.size() + 1);
    const double offset = is_linear_ ? 0.5 : 0;
    return {least_of(at) - grown - offset, greatest_of(at) + grown - offset};
  }

  /// Bounds of the sampled number in a box.
  Bounds sampled_in(const Bounds& x, const Bounds& y) const {
    const auto floored = [](double k) { return static_cast<std::int64_t>(std::floor(k)); };
    const IndexRange columns{floored(x.least), floored(x.greatest)},
        rows{floored(y.least), floored(y.greatest)};
    const auto few = [](const IndexRange& cells) { return cells.last - cells.first < most_cells_a_side; };
    if (is_linear_ && few(columns) && few(rows)) return in_cells(x, y, columns, rows);
    const std::int64_t next = is_linear_ ? 1 : 0;
    const TexelRange all =
        ranges_.of({columns.first, columns.last + next}, {rows.first, rows.last + next}, surface_.sampler);
    return {all.least, all.greatest};
  }

  /// Bounds of bilinear filtering in a box that meets few cells: on a part of a cell its extremes lie at the corners.
  Bounds in_cells(const Bounds& x, const Bounds& y, const IndexRange& columns, const IndexRange& rows) const {
    Bounds all{HUGE_VAL, -HUGE_VAL};
    for (std::int64_t j = rows.first; j <= rows.last; ++j)
      for (std::int64_t i = columns.first; i <= columns.last; ++i) {
        const double a = texel(i, j), b = texel(i + 1, j), c = texel(i, j + 1), d = texel(i + 1, j + 1);
        const double least = std::min({a, b, c, d}), greatest = std::max({a, b, c, d});
        const double slack = rounding(std::max(std::fabs(least), std::fabs(greatest)));
        const auto clamped = [&](double k) { return std::clamp(k, least, greatest); };
        for (const double u : {x.least - static_cast<double>(i), x.greatest - static_cast<double>(i)})
          for (const double v : {y.least - static_cast<double>(j), y.greatest - static_cast<double>(j)}) {
            const double s = std::clamp(u, 0.0, 1.0), t = std::clamp(v, 0.0, 1.0);
            const double here = (a * (1 - s) + b * s) * (1 - t) + (c * (1 - s) + d * s) * t;
            all.least = std::min(all.least, clamped(here - slack));
            all.greatest = std::max(all.greatest, clamped(here + slack));
          }
      }
    return all;
  }

  /// T or O if the bounds of alpha tell it.
  std::optional<State> state(const Functions& of, const Node& node) const {
    const Bounds numbers = sampled_in(along(of.x, node), along(of.y, node));
    const std::array<double, 3> alphas = node.of(of.alpha);
    const double least_alpha = std::max(least_of(alphas) - rounding(1), least_of(of.alpha.at)),
                 most_alpha = std::min(greatest_of(alphas) + rounding(1), greatest_of(of.alpha.at));
    // Texels have 16 bits, or 24, and the factor 24: bounds that are texels have exact products.
    const double least = product_below(numbers.least, surface_.base_color_alpha),
                 most = product_above(numbers.greatest, surface_.base_color_alpha);
    const bool is_blend = surface_.mode == AlphaMode::blend;
    const double limit = is_blend ? one_ : double{surface_.cutoff} * one_;
    if (reaches(least, least < 0 ? most_alpha : least_alpha, limit)) return State::O;
    const double greatest_alpha = most < 0 ? least_alpha : most_alpha;
    const bool is_transparent = is_blend ? most * greatest_alpha <= 0 : !reaches(most, greatest_alpha, limit);
    return is_transparent ? std::optional(State::T) : std::nullopt;
  }

  /// The unknown state by alpha at the centroid.
  State side(const Functions& of, const Node& node) const {
    const auto middle = [&](const Linear& f) {
      const std::array<double, 3> at = node.of(f);
      return (at[0] + at[1] + at[2]) / 3;
    };
    const double alpha = sampled(middle(of.x), middle(of.y)) * surface_.base_color_alpha * middle(of.alpha);
    const double limit = surface_.mode == AlphaMode::blend ? 0.5 : surface_.cutoff;
    return alpha >= limit * one_ ? State::UO : State::UT;
  }

  double texel(std::int64_t i, std::int64_t j) const {
    return ranges_.texel(impl::bake::wrapped(wrap_of(surface_.sampler.wrap_u), i, image_.width),
                         impl::bake::wrapped(wrap_of(surface_.sampler.wrap_v), j, image_.height));
  }

  /// The sampled number at a place.
  double sampled(double x, double y) const {
    const double offset = is_linear_ ? 0.5 : 0;
    const Bounds all = sampled_in({x - offset, x - offset}, {y - offset, y - offset});
    return (all.least + all.greatest) / 2;
  }

  const Image& image_;
  const Surface surface_;
  const double margin_;
  const bool is_linear_;
  const TexelRanges ranges_;
  const double one_;  ///< the stored number of alpha 1
};

VaryingAlphaBakers::VaryingAlphaBakers(const Scene& scene, const Plan& plan, float margin)
    : surfaces_(plan.surfaces.size()) {
  for (const PlannedTriangle& triangle : plan.triangles)
    if (triangle.varies() && !surfaces_[triangle.surface])
      surfaces_[triangle.surface] = std::make_unique<const OfSurface>(
          scene.images.at(plan.surfaces[triangle.surface].image), plan.surfaces[triangle.surface], margin);
}
VaryingAlphaBakers::~VaryingAlphaBakers() = default;

void VaryingAlphaBakers::bake(const PlannedTriangle& triangle, unsigned level,
                              std::span<std::uint8_t> map) const {
  surfaces_.at(triangle.surface)->bake(triangle, level, map);
}

}  // namespace mmverify::scene
