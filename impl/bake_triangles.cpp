#include "impl/bake_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "impl/bake_base.hpp"
#include "impl/bake_filter.hpp"
#include "impl/bake_sides.hpp"

namespace mmverify::impl::bake {
namespace {

using namespace detail;

// Packed codes: T 0, O 1, UT 2, UO 3.
constexpr std::uint8_t transparent = 0, opaque_code = 1, unknown = 2;

using Corners = std::array<Spot, 3>;

Spot middle(Spot a, Spot b) noexcept { return {(a.x + b.x) * 0.5, (a.y + b.y) * 0.5}; }

/// One base triangle, from the whole down the curve: children in the order and with the corners of
/// impl/index.hpp.
class Descent {
 public:
  Descent(const Sides& sides, const Filter& filter, const ExactBase& exact, std::uint8_t* map) noexcept
      : sides_(sides), filter_(filter), exact_(exact), map_(map) {}

  /// Level 0: one state, in the low bits of a byte.
  void single(const Corners& p) {
    const Marks all = box(p);
    *map_ = all != both ? settled(all) : leaf(p, {filter_.g(p[0]), filter_.g(p[1]), filter_.g(p[2])}, 0);
  }

  /// A node of 4^height micro-triangles, the first of them at `index`.  Domain: height > 0.
  void node(const Corners& p, std::uint32_t height, std::uint32_t index) {
    const Marks all = box(p);
    if (all != both) {
      std::memset(map_ + index / 4, all == opaque ? 0x55 : 0, std::size_t{1} << (2 * height - 2));
      return;
    }
    const Spot p01 = middle(p[0], p[1]), p02 = middle(p[0], p[2]), p12 = middle(p[1], p[2]);
    if (height == 1) {
      four(p, p01, p02, p12, index);
      return;
    }
    const std::uint32_t child = std::uint32_t{1} << (2 * height - 2);
    node({p[0], p01, p02}, height - 1, index);
    node({p02, p12, p01}, height - 1, index + child);
    node({p01, p[1], p12}, height - 1, index + 2 * child);
    node({p12, p02, p[2]}, height - 1, index + 3 * child);
  }

  BakeCounts counts;

 private:
  static std::uint8_t settled(Marks all) noexcept { return all == opaque ? opaque_code : transparent; }

  /// Of all texels of the cells that the box about a triangle meets.
  Marks box(const Corners& p) const noexcept {
    const double d = filter_.delta();
    const double left = std::min(std::min(p[0].x, p[1].x), p[2].x),
                 right = std::max(std::max(p[0].x, p[1].x), p[2].x),
                 top = std::min(std::min(p[0].y, p[1].y), p[2].y),
                 bottom = std::max(std::max(p[0].y, p[1].y), p[2].y);
    return sides_.of(floored(left - d), floored(right + d) + 1, floored(top - d), floored(bottom + d) + 1);
  }

  /// The four children of a node, in one byte; their six corners sampled once.
  void four(const Corners& p, Spot p01, Spot p02, Spot p12, std::uint32_t index) {
    const double g0 = filter_.g(p[0]), g1 = filter_.g(p[1]), g2 = filter_.g(p[2]), g01 = filter_.g(p01),
                 g02 = filter_.g(p02), g12 = filter_.g(p12);
    const unsigned code = child({p[0], p01, p02}, {g0, g01, g02}, index) |
                          child({p02, p12, p01}, {g02, g12, g01}, index + 1) << 2 |
                          child({p01, p[1], p12}, {g01, g1, g12}, index + 2) << 4 |
                          child({p12, p02, p[2]}, {g12, g02, g2}, index + 3) << 6;
    map_[index / 4] = static_cast<std::uint8_t>(code);
  }

  unsigned child(const Corners& p, const std::array<double, 3>& g, std::uint32_t index) {
    const Marks at_corners = static_cast<Marks>(filter_.side(g[0]) | filter_.side(g[1]) | filter_.side(g[2]));
    if (at_corners != both) {
      const Marks all = box(p);
      if (all != both) return settled(all);
    }
    return leaf(p, g, index);
  }

  std::uint8_t leaf(const Corners& p, const std::array<double, 3>& g, std::uint32_t index) {
    ++counts.leaves;
    Marks marks = 0;
    if (filter_.usable()) {
      marks = static_cast<Marks>(filter_.side(g[0]) | filter_.side(g[1]) | filter_.side(g[2]));
      if (marks != both) marks = filter_.sides(p, marks);
      if (marks == opaque || marks == below) return settled(marks);
      if (marks == both) {
        const Marks lean =
            filter_.side(filter_.g({(p[0].x + p[1].x + p[2].x) / 3, (p[0].y + p[1].y + p[2].y) / 3}));
        if (lean != 0) return lean == opaque ? unknown | 1 : unknown;
      }
    }
    ++counts.exact;
    const ExactBase::Answer answer = exact_(index);
    if (answer.marks != both) return settled(answer.marks);
    return answer.centroid == opaque ? unknown | 1 : unknown;
  }

  const Sides& sides_;
  const Filter& filter_;
  const ExactBase& exact_;
  std::uint8_t* map_;
};

}  // namespace

TriangleBaker::TriangleBaker(const AlphaView& texture, Cutoff cutoff, const Addressing& addressing)
    : texture_(texture) {
  if (texture.width == 0 || texture.width > 16384 || texture.height == 0 || texture.height > 16384)
    throw std::invalid_argument("bake: a texture has 1 to 16384 texels along each side");
  if (cutoff.denominator == 0) throw std::invalid_argument("bake: a cutoff over 0");
  sides_ = std::make_unique<const Sides>(texture, cutoff, addressing.u, addressing.v, addressing.border);
}
TriangleBaker::~TriangleBaker() = default;
TriangleBaker::TriangleBaker(TriangleBaker&&) noexcept = default;
TriangleBaker& TriangleBaker::operator=(TriangleBaker&&) noexcept = default;

BakeCounts TriangleBaker::bake(const BaseTriangle& uv, std::uint32_t level,
                               std::span<std::uint8_t> map) const {
  if (level > max_bake_level) throw std::invalid_argument("bake: a level above 12");
  const std::uint64_t count = std::uint64_t{1} << (2 * level);
  if (map.size() != (count + 3) / 4) throw std::invalid_argument("bake: room for another number of states");
  Corners p;
  double size = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!std::isfinite(uv[k].u) || !std::isfinite(uv[k].v))
      throw std::invalid_argument("bake: a texture coordinate that is not finite");
    if (std::fabs(uv[k].u) >= 0x1p20f || std::fabs(uv[k].v) >= 0x1p20f)
      throw std::invalid_argument("bake: a texture coordinate of 2^20 or more");
    // The products are exact, in 24 + 15 bits.
    p[k] = {double{uv[k].u} * texture_.width - 0.5, double{uv[k].v} * texture_.height - 0.5};
    size = std::max({size, std::fabs(p[k].x), std::fabs(p[k].y)});
  }
  // Half a unit in the last place for 1/2, and for each level's middle.
  const Filter filter(*sides_, (level + 2) * 0x1p-52 * size);
  const ExactBase exact(*sides_, uv, texture_.width, texture_.height, level);
  Descent descent(*sides_, filter, exact, map.data());
  if (level == 0)
    descent.single(p);
  else
    descent.node(p, level, 0);
  descent.counts.micro_triangles = count;
  return descent.counts;
}

}  // namespace mmverify::impl::bake
