#include "impl/bake_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "impl/bake_base.hpp"
#include "impl/bake_filter.hpp"
#include "impl/bake_inner_box.hpp"
#include "impl/bake_sides.hpp"

namespace mmverify::impl::bake {
namespace {

using namespace detail;

// Packed codes: T 0, O 1, UT 2, UO 3.
constexpr std::uint8_t transparent = 0, opaque_code = 1, unknown = 2;

/// One base triangle, from the whole down the curve: children in the order and with the corners of
/// impl/index.hpp.
class Descent {
 public:
  /// `inner`: of a micro-triangle that is not turned.
  Descent(const Sides& sides, const Filter& filter, const InnerBox& inner, const ExactBase& exact,
          std::uint8_t* map) noexcept
      : sides_(sides), filter_(filter), exact_(exact), map_(map) {
    // Shrunk, so that it is within the true triangle: its corners may be 2 delta off.
    const double d = 4 * filter.delta();
    asks_inner_ = (inner.right - inner.left) * (inner.bottom - inner.top) >= 16;
    inner_[0] = {inner.left + d, inner.right - d, inner.top + d, inner.bottom - d};
    inner_[1] = {-inner.right + d, -inner.left - d, -inner.bottom + d, -inner.top - d};
  }

  /// Level 0: one state, in the low bits of a byte.
  void single(const Triangle& p) {
    Quad quad;
    *map_ = static_cast<std::uint8_t>(
        leaf(p, {filter_.g(p[0]), filter_.g(p[1]), filter_.g(p[2])}, false, 0, quad, {own, own, own}));
  }

  /// A node of 4^height micro-triangles, the first of them at `index`.  Domain: height > 0.
  void node(const Triangle& p, bool turned, std::uint32_t height, std::uint32_t index) {
    const Marks all = filter_.texels(filter_.box(p));
    if (all != both) {
      std::memset(map_ + index / 4, all == opaque ? 0x55 : 0, std::size_t{1} << (2 * height - 2));
      return;
    }
    const Spot p01 = middle(p[0], p[1]), p02 = middle(p[0], p[2]), p12 = middle(p[1], p[2]);
    if (height == 1) {
      four(p, p01, p02, p12, turned, index);
      return;
    }
    const std::uint32_t child = std::uint32_t{1} << (2 * height - 2);
    node({p[0], p01, p02}, turned, height - 1, index);
    node({p02, p12, p01}, !turned, height - 1, index + child);
    node({p01, p[1], p12}, turned, height - 1, index + 2 * child);
    node({p12, p02, p[2]}, turned, height - 1, index + 3 * child);
  }

  BakeCounts counts;

 private:
  static unsigned settled(Marks all) noexcept { return all == opaque ? opaque_code : transparent; }

  /// The edges between the four children of a node, each asked at most once: 0 p01 p02, 1 p01 p12, 2 p02 p12.
  struct Quad {
    std::array<Marks, 3> edge{};
  };
  static constexpr std::size_t own = 3;  ///< an edge of no other child

  /// The four children of a node, in one byte; their six corners sampled once.
  void four(const Triangle& p, Spot p01, Spot p02, Spot p12, bool turned, std::uint32_t index) {
    const double g0 = filter_.g(p[0]), g1 = filter_.g(p[1]), g2 = filter_.g(p[2]), g01 = filter_.g(p01),
                 g02 = filter_.g(p02), g12 = filter_.g(p12);
    Quad quad;
    const unsigned code = leaf({p[0], p01, p02}, {g0, g01, g02}, turned, index, quad, {own, 0, own}) |
                          leaf({p02, p12, p01}, {g02, g12, g01}, !turned, index + 1, quad, {2, 1, 0}) << 2 |
                          leaf({p01, p[1], p12}, {g01, g1, g12}, turned, index + 2, quad, {own, own, 1})
                              << 4 |
                          leaf({p12, p02, p[2]}, {g12, g02, g2}, turned, index + 3, quad, {2, own, own}) << 6;
    map_[index / 4] = static_cast<std::uint8_t>(code);
  }

  /// `edges`: which of the quad's the edges p0 p1, p1 p2, p2 p0 are.
  unsigned leaf(const Triangle& p, const std::array<double, 3>& g, bool turned, std::uint32_t index,
                Quad& quad, const std::array<std::size_t, 3>& edges) {
    const Spot centroid{(p[0].x + p[1].x + p[2].x) * (1.0 / 3), (p[0].y + p[1].y + p[2].y) * (1.0 / 3)};
    Marks marks = filter_.usable()
                      ? static_cast<Marks>(filter_.side(g[0]) | filter_.side(g[1]) | filter_.side(g[2]))
                      : uncertain;
    if (marks != both) {
      const Filter::Box box = filter_.box(p);
      const Marks all = filter_.texels(box);
      if (all != both) return settled(all);
      if (marks != uncertain) marks = judged(p, g, box, centroid, marks, turned, quad, edges);
    }
    ++counts.leaves;
    if (marks == opaque || marks == below) return settled(marks);
    if (marks == both) {
      const Marks lean = filter_.side(filter_.g(centroid));
      if (lean != 0) return lean == opaque ? unknown | 1 : unknown;
    }
    ++counts.exact;
    const ExactBase::Answer answer = exact_(index);
    if (answer.marks != both) return settled(answer.marks);
    return answer.centroid == opaque ? unknown | 1 : unknown;
  }

  /// Of a triangle some of whose texels are on either side; `seen` at its corners.
  Marks judged(const Triangle& p, const std::array<double, 3>& g, const Filter::Box& box, Spot centroid,
               Marks seen, bool turned, Quad& quad, const std::array<std::size_t, 3>& edges) {
    if (asks_inner_) {
      const InnerBox& inner = inner_[turned];
      const std::int64_t left = -floored(-(centroid.x + inner.left)),
                         right = floored(centroid.x + inner.right), top = -floored(-(centroid.y + inner.top)),
                         bottom = floored(centroid.y + inner.bottom);
      if (left <= right && top <= bottom)
        seen = static_cast<Marks>(seen | sides_.of(left, right, top, bottom));
      if (seen == both) return both;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = k == 2 ? 0 : k + 1;
      Marks marks = edges[k] == own ? Marks{0} : quad.edge[edges[k]];
      if (marks == 0) marks = filter_.edge(p[k], p[next], g[k], g[next]);
      if (edges[k] != own) quad.edge[edges[k]] = marks;
      seen = static_cast<Marks>(seen | marks);
      if ((seen & both) == both) return both;
    }
    const Marks within = filter_.centres(p, box, seen);
    if ((seen & uncertain) == 0 && (seen | within) == seen) return seen;
    return filter_.centres_are_clear() && ((seen | within) & both) == both ? both : uncertain;
  }

  const Sides& sides_;
  const Filter& filter_;
  const ExactBase& exact_;
  std::array<InnerBox, 2> inner_;  ///< not turned, turned
  bool asks_inner_;                ///< large enough to hold several texels
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
  Triangle p;
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
  InnerBox inner = inner_box(p);
  for (double* const side : {&inner.left, &inner.right, &inner.top, &inner.bottom})
    *side = std::ldexp(*side, -static_cast<int>(level));
  Descent descent(*sides_, filter, inner, exact, map.data());
  if (level == 0)
    descent.single(p);
  else
    descent.node(p, false, level, 0);
  descent.counts.micro_triangles = count;
  return descent.counts;
}

}  // namespace mmverify::impl::bake
