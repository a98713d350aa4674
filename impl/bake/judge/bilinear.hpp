// The judge of micro-triangles sampled bilinearly.  Internal to impl/bake.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "impl/bake/exact/later.hpp"
#include "impl/bake/judge/centres.hpp"
#include "impl/bake/judge/codes.hpp"
#include "impl/bake/judge/filter.hpp"
#include "impl/bake/judge/inner_box.hpp"
#include "impl/bake/judge/samples.hpp"
#include "impl/bake/judge/shapes.hpp"
#include "impl/bake/sixteen/bounds.hpp"
#include "impl/bake/sixteen/sixteen.hpp"
#include "impl/bake/texture/properties.hpp"
#include "impl/common/bits.hpp"

namespace mmverify::impl::bake::detail {

template <class Texel>
class Bilinear {
 public:
  /// The offset of its coordinates from those of texels.
  static constexpr double offset = 0.5;

  Bilinear(const TexturePropertiesOf<Texel>& sides, const ExactLater& exact, const Triangle& base,
           index::Level level, double delta, const Dilation& dilation) noexcept
      : sides_(sides),
        filter_(sides, delta, dilation),
        exact_(exact),
        inner_(sides, base, level, dilation, delta),
        lean_(sides.limits.blend ? -0.5 * sides.gap : 0),
        lines_(level >= 2 && in_vectors() ? Lines(base, delta) : Lines()),
        shapes_(base, level, lines_, delta,
                {sides.threshold, sides.gap, lean_, sides.scale,
                 std::min(sides.clear_below, sides.clear_opaque)}) {}

  Marks texels(const Triangle& p) const noexcept { return filter_.texels(filter_.box(p)); }
  /// The marks of the sixteen nodes that a node is cut into, if vectors take them together.
  SixteenNodes sixteen_nodes(const Triangle& p, bool turned, std::uint32_t height,
                             std::uint32_t index) const noexcept {
    if (height > shapes_.largest()) return {};
    SixteenInput in;
    const SixteenWindow w(filter_.box(p));
    if (!placed(p, w, in)) return {};
    in.shape = &shape(height, turned, index);
    return detail::sixteen_nodes(in);
  }

  /// The code of one micro-triangle, which shares no edge with others.
  unsigned single(const Triangle& p, bool turned, std::uint32_t index, BakeCounts& counts) const {
    const std::array<double, 3> g{filter_.g(p[0]), filter_.g(p[1]), filter_.g(p[2])};
    const double at_centroid = filter_.g(centroid_of(p));
    const auto range = std::minmax({g[0], g[1], g[2], at_centroid});
    const Marks marks = filter_.usable() ? filter_.range(range.first, range.second) : Marks{0};
    Quad quad;
    return leaf(p, {g, at_centroid, marks}, turned, index, quad, {own, own, own}, counts);
  }

  /// The codes of a node's four children, in one byte; their six corners and four centroids are sampled together.
  unsigned four(const Triangle& p, PlanePoint p01, PlanePoint p02, PlanePoint p12, bool turned,
                std::uint32_t index, BakeCounts& counts) const {
    constexpr std::array<std::array<std::size_t, 3>, 4> edges{
        {{own, 0, own}, {2, 1, 0}, {own, own, 1}, {2, own, own}}};
    const std::array<Triangle, 4> of{{{p[0], p01, p02}, {p02, p12, p01}, {p01, p[1], p12}, {p12, p02, p[2]}}};
    FourPlaces places;
    const auto put = [&places](std::size_t k, PlanePoint at) { places.x[k] = at.x, places.y[k] = at.y; };
    for (std::size_t k = 0; const PlanePoint& corner : {p[0], p01, p02, p[1], p12, p[2]}) put(k++, corner);
    for (std::size_t c = 0; c < 4; ++c) put(FourPlaces::centroids + c, centroid_of(of[c]));
    const FourSamples samples = four_samples(p, places);
    Quad quad;
    unsigned codes = 0;
    for (std::uint32_t c = 0; c < 4; ++c) {
      const std::uint32_t at = four_places[c], centroid = 1u << (FourPlaces::centroids + c);
      const auto marks = static_cast<Marks>(((samples.below & at) != 0 ? below : 0) |
                                            ((samples.opaque & at) != 0 ? opaque : 0));
      unsigned code = (samples.leans_to_opaque & centroid) != 0 ? unknown | 1 : unknown;
      if (marks == both && (samples.leans & centroid) != 0) {
        ++counts.leaves;
      } else {
        const auto& k = four_corners[c];
        code = leaf(of[c],
                    {{samples.g[k[0]], samples.g[k[1]], samples.g[k[2]]},
                     samples.g[FourPlaces::centroids + c],
                     marks},
                    turned != (c == 1), index + c, quad, edges[c], counts);
      }
      codes |= code << (2 * c);
    }
    return codes;
  }

  /// The codes of a node's sixteen micro-triangles, in four bytes: in vectors if they are small, one by one if they are
  /// large or if vectors cannot decide.
  std::uint32_t sixteen(const Triangle& p, bool turned, std::uint32_t index, BakeCounts& counts) const {
    std::optional<SixteenMarks> marks;
    if constexpr (!std::is_same_v<Texel, float>)
      if (in_vectors()) marks = asked(p, turned, index);
    if (!marks) {
      const std::array<Triangle, 4> of = children(p);
      std::uint32_t codes = 0;
      for (std::uint32_t c = 0; c < 4; ++c) {
        const Triangle& q = of[c];
        codes |= four(q, middle(q[0], q[1]), middle(q[0], q[2]), middle(q[1], q[2]), turned != (c == 1),
                      index + 4 * c, counts)
                 << (8 * c);
      }
      return codes;
    }
    return coded(*marks, p, turned, index, counts);
  }

  /// The codes of those of a node's four quarters, nodes of sixteen, that are wanted; bit c of wanted: quarter c.
  /// False if they are not taken together: only one is wanted, they are too large, or placed() is false.
  bool sixty_four(const Triangle& p, bool turned, std::uint32_t index, std::uint32_t wanted,
                  BakeCounts& counts, std::array<std::uint32_t, 4>& codes) const {
    if constexpr (std::is_same_v<Texel, float>) return false;
    if (!shapes_.share() || (wanted & (wanted - 1)) == 0) return false;
    SixteenInput in;
    const SixteenWindow w(filter_.box(p));
    if (!placed(p, w, in)) return false;
    const std::array<Triangle, 4> of = children(p);
    std::array<SixteenNode, 4> nodes;
    std::array<SixteenMarks, 4> marks;
    std::size_t count = 0;
    for (std::uint32_t c = 0; c < 4; ++c)
      if ((wanted >> c & 1) != 0)
        nodes[count++] = {&shape(2, turned != (c == 1), index + 16 * c), w.local(of[c][0])};
    detail::sixteen<Texel>(in, {nodes.data(), count}, marks.data());
    count = 0;
    for (std::uint32_t c = 0; c < 4; ++c)
      if ((wanted >> c & 1) != 0)
        codes[c] = coded(marks[count++], of[c], turned != (c == 1), index + 16 * c, counts);
    return true;
  }

 private:
  /// The marks of the edges between a node's four children, each judged once at most: 0 p01 p02, 1 p01 p12, 2 p02 p12.
  struct Quad {
    std::array<Marks, 3> edge{};
  };
  static constexpr std::size_t own = 3;  ///< an edge that no other child has

  /// The codes of a node.  Micro-triangles that its marks do not decide are judged one by one.
  std::uint32_t coded(const SixteenMarks& marks, const Triangle& p, bool turned, std::uint32_t index,
                      BakeCounts& counts) const {
    const std::uint32_t unknowns = marks.below & marks.opaque, leaning = unknowns & marks.leans_to_opaque,
                        decided = marks.lacks_below | marks.lacks_opaque | (unknowns & marks.leans),
                        left = ~decided & 0xffff;
    counts.leaves += marks.leaves;
    std::uint32_t codes = impl::detail::spread<32>(decided & (leaning | marks.lacks_below)) |
                          impl::detail::spread<32>(decided & unknowns) << 1;
    if (left == 0) return codes;
    const std::array<Triangle, 4> of = children(p);
    for (std::uint32_t c = 0; c < 4; ++c) {
      if ((left >> (4 * c) & 15) == 0) continue;
      const bool is_turned = turned != (c == 1);
      const std::array<Triangle, 4> micro = children(of[c]);
      for (std::uint32_t k = 4 * c; k < 4 * c + 4; ++k)
        if ((left >> k & 1) != 0)
          codes |= single(micro[k % 4], is_turned != (k % 4 == 1), index + k, counts) << (2 * k);
    }
    return codes;
  }

  using Box = typename BilinearFilter<Texel>::Box;
  using InPicture = typename TexturePropertiesOf<Texel>::InPicture;

  /// Whether vectors may judge: see impl/bake/sixteen/sixteen.hpp.
  bool in_vectors() const noexcept {
    return !std::is_same_v<Texel, float> && filter_.usable() && filter_.delta() < 0x1p-30 &&
           filter_.dilation().none() && sides_.pitch() <= std::size_t{1} << 20;
  }

  /// The shape of the node of this height at `index`.
  const SixteenShape& shape(std::uint32_t height, bool turned, std::uint32_t index) const noexcept {
    return shapes_(height, reversed(index), turned);
  }
  /// Writes to `in` the places of a node's texels and bits.  False if it is too large, or in no picture, or not
  /// bounded.
  bool placed(const Triangle& p, const SixteenWindow& w, SixteenInput& in) const noexcept {
    if (w.size > sixteen_window || !lines_.usable) return false;
    const auto picture = sides_.in_one_picture(w.left, w.right, w.top, w.bottom);
    if (!picture) return false;
    place(p, w, in);
    in.texels = picture->first;
    in.pitch = static_cast<std::int32_t>(sides_.pitch());
    const PlaneWords words = words_at({picture->left, picture->top});
    in.opaque = words.opaque;
    in.visible = words.visible;
    in.strip = words.strip;
    in.bit = words.bit;
    return true;
  }
  /// A texel's words: of its row in its strip, and its bit there.
  struct PlaneWords {
    const std::uint32_t *opaque, *visible;
    std::size_t strip;
    std::uint32_t bit;
  };
  PlaneWords words_at(const InPicture& at) const noexcept {
    const Plane &are_opaque = sides_.opaque_plane(), &visible = sides_.visible_plane();
    const std::size_t word =
        are_opaque.strip() * static_cast<std::size_t>(at.left / 32) + static_cast<std::size_t>(at.top);
    return {are_opaque.strips() + word, visible.strips() + word, are_opaque.strip(),
            static_cast<std::uint32_t>(at.left % 32)};
  }
  static void place(const Triangle& p, const SixteenWindow& w, SixteenInput& in) noexcept {
    in.columns = static_cast<std::int32_t>(w.width);
    in.rows = static_cast<std::int32_t>(w.height);
    in.p0 = w.local(p[0]);
  }
  /// Whether the edge p0 p1 of the node at `index` goes against the base triangle's: each fourth child reverses it.
  static bool reversed(std::uint32_t index) noexcept {
    // The parity of the even bits, folded, since not all target processors can count bits.
    std::uint32_t fourth = index & index >> 1 & 0x55555550;
    fourth ^= fourth >> 16;
    fourth ^= fourth >> 8;
    fourth ^= fourth >> 4;
    return ((fourth ^ fourth >> 2) & 1) != 0;
  }

  /// The most texels a side that are copied if they are not in one picture: a word has their bits.
  static constexpr std::int64_t most_copied = 32;

  /// The marks of a node of sixteen; none if it is too large, or lines bound nothing.
  std::optional<SixteenMarks> asked(const Triangle& p, bool turned, std::uint32_t index) const {
    SixteenInput in;
    const SixteenWindow w(filter_.box(p));
    in.shape = &shape(2, turned, index);
    const auto marks = [&in] {
      const SixteenNode node{in.shape, in.p0};
      SixteenMarks found;
      detail::sixteen<Texel>(in, {&node, 1}, &found);
      return found;
    };
    if (placed(p, w, in)) return marks();
    if (w.size > most_copied || !lines_.usable) return std::nullopt;
    place(p, w, in);
    constexpr std::size_t pitch = most_copied;
    std::array<Texel, pitch * pitch + 4> texels;  // 4 bytes from the last texel on can be read
    std::array<std::uint32_t, 2 * pitch> opaque_rows{}, visible_rows{};
    sides_.copy(w.left, w.top, static_cast<std::size_t>(w.width), static_cast<std::size_t>(w.height), pitch,
                texels.data(), opaque_rows.data(), visible_rows.data());
    in.texels = texels.data();
    in.pitch = pitch;
    in.opaque = opaque_rows.data();
    in.visible = sides_.limits.blend ? visible_rows.data() : opaque_rows.data();
    in.strip = pitch;
    in.bit = 0;
    return marks();
  }

  static PlanePoint centroid_of(const Triangle& p) noexcept {
    return {(p[0].x + p[1].x + p[2].x) * (1.0 / 3), (p[0].y + p[1].y + p[2].y) * (1.0 / 3)};
  }
  /// The code of a micro-triangle that bears both marks, with g at its centroid.
  unsigned leaning(double at_centroid, std::uint32_t index, BakeCounts& counts) const {
    const double at = at_centroid - lean_;
    if (std::fabs(at) > filter_.bound()) return at > 0 ? unknown | 1 : unknown;
    ++counts.exact;
    return code_of((*exact_)(index, both));
  }

  /// Samples of one micro-triangle, and the marks that these prove.
  struct Sampled {
    std::array<double, 3> g;  ///< at the corners
    double at_centroid;
    Marks marks;
  };

  /// The samples of a node's children.
  FourSamples four_samples(const Triangle& p, const FourPlaces& places) const noexcept {
    constexpr std::int64_t most_bytes = std::int64_t{1} << 31;
    if constexpr (!std::is_same_v<Texel, float>) {
      const auto box = filter_.box(p);
      const auto picture =
          in_vectors() ? sides_.in_one_picture(box.left, box.right, box.top, box.bottom) : std::nullopt;
      if (picture &&
          (box.bottom - box.top + 1) * static_cast<std::int64_t>(sides_.pitch() * sizeof(Texel)) < most_bytes)
        return sampled<Texel>(
            {picture->first, static_cast<std::int32_t>(sides_.pitch()), static_cast<double>(box.left),
             static_cast<double>(box.top), sides_.threshold, sides_.gap, lean_, filter_.bound()},
            places);
    }
    FourSamples found;
    for (std::size_t k = 0; k < FourPlaces::count; ++k) {
      found.g[k] = filter_.g({places.x[k], places.y[k]});
      const Marks marks = filter_.usable() ? filter_.side(found.g[k]) : Marks{0};
      found.below |= std::uint32_t{(marks & below) != 0} << k;
      found.opaque |= std::uint32_t{(marks & opaque) != 0} << k;
      found.leans |= std::uint32_t{filter_.usable() && std::fabs(found.g[k] - lean_) > filter_.bound()} << k;
      found.leans_to_opaque |= std::uint32_t{found.g[k] > lean_} << k;
    }
    return found;
  }

  /// The code of a micro-triangle.  `edges`: the numbers in the quad of the edges p0 p1, p1 p2, p2 p0.
  unsigned leaf(const Triangle& p, const Sampled& of, bool turned, std::uint32_t index, Quad& quad,
                const std::array<std::size_t, 3>& edges, BakeCounts& counts) const {
    Marks marks = of.marks;
    if (marks != both) {
      constexpr std::int64_t few_rows = 24;   // whose cells take no longer than the box's texels
      constexpr std::int64_t many_rows = 40;  // whose cells take longer than a rectangle's texels
      const auto box = filter_.box(p);
      const std::optional<WindowBits> bits = filter_.usable() ? bits_of(box) : std::nullopt;
      const bool cells_tell = bits && bits->has_cells && box.bottom - box.top < few_rows && !is_flat(p);
      const Marks all = cells_tell ? both : filter_.texels(box);
      if (all != both) return known_code(all);
      if (bits && box.bottom - box.top > many_rows)
        marks = static_cast<Marks>(marks | (rectangle(p) & filter_.clear()));
      const TriangleBits found =
          bits && marks != both ? bits_within(p, *bits, filter_.delta(), static_cast<Marks>(both & ~marks))
                                : TriangleBits{};
      marks = static_cast<Marks>(marks | (found.centres & filter_.clear()));
      if (marks != both && !found.meets_mixed) return found.begins_opaque ? opaque_code : 0;
      if (!filter_.usable())
        marks = inner_.marks().centres(centroid_of(p), turned);
      else if (marks != both)
        marks = judged(p, of.g, box, bits ? &found : nullptr, marks, turned, quad, edges);
    }
    ++counts.leaves;
    if (filter_.usable() && (marks == opaque || marks == below)) return known_code(marks);
    if (marks == both) return leaning(of.at_centroid, index, counts);
    ++counts.exact;
    return code_of((*exact_)(index));
  }

  /// The bits of the cells that a triangle of this box meets, or of the texels whose centres may be within; none if they
  /// are in no picture.
  std::optional<WindowBits> bits_of(const Box& box) const noexcept {
    if (!filter_.dilation().none()) return std::nullopt;
    Box b = box;
    auto place = sides_.place_in_one_picture(b.left, b.right, b.top, b.bottom);
    const bool has_cells = place.has_value();
    if (!has_cells) {
      b = {box.left + 1, box.right - 1, box.top + 1, box.bottom - 1};
      if (b.left > b.right || b.top > b.bottom) return std::nullopt;
      place = sides_.place_in_one_picture(b.left, b.right, b.top, b.bottom);
      if (!place) return std::nullopt;
    }
    const PlaneWords words = words_at(*place);
    return WindowBits{words.opaque,
                      words.visible,
                      words.strip,
                      words.bit,
                      b.left,
                      b.top,
                      static_cast<std::int32_t>(b.right - b.left + 1),
                      has_cells};
  }

  static bool is_flat(const Triangle& p) noexcept { return p[0].y == p[1].y && p[1].y == p[2].y; }

  /// The marks of the centres in a rectangle: between a row of a triangle's upper half and one of its lower half, in the
  /// columns that it has on both.  It is convex, so they are within but for roundings, as BilinearFilter's are.
  Marks rectangle(const Triangle& p) const noexcept {
    const auto [low, high] = std::minmax({p[0].y, p[1].y, p[2].y});
    const double between = std::max(std::min(p[0].y, p[1].y), std::min(std::max(p[0].y, p[1].y), p[2].y));
    // No edge crosses the lowest row of all.
    const double upper = (low + between) * 0.5,
                 lower = std::min((between + high) * 0.5, high - (high - low) * 0x1p-5);
    const Reach a = at_level(p, upper), b = at_level(p, lower);
    const double from = std::max(a.from, b.from), to = std::min(a.to, b.to);
    if (!(from <= to)) return 0;
    const std::int64_t left = -floored(-from), right = floored(to), top = -floored(-upper),
                       bottom = floored(lower);
    return left <= right && top <= bottom ? sides_.of(left, right, top, bottom) : Marks{0};
  }

  /// The marks of a triangle whose texels bear both marks; some samples bear `seen`.
  /// Found: its bits, whose marks are in `seen`; null: none.
  Marks judged(const Triangle& p, const std::array<double, 3>& g, const Box& box, const TriangleBits* found,
               Marks seen, bool turned, Quad& quad, const std::array<std::size_t, 3>& edges) const {
    if (found == nullptr) seen = static_cast<Marks>(seen | inner_.marks().centres(centroid_of(p), turned));
    if (seen == both) return both;
    if (!filter_.dilation().none()) {
      seen = static_cast<Marks>(seen | outline(p, seen));
      if ((seen & both) == both) return both;
    }
    for (std::size_t k = 0; k < 3 && filter_.dilation().none(); ++k) {
      const std::size_t next = k == 2 ? 0 : k + 1;
      Marks marks = edges[k] == own ? Marks{0} : quad.edge[edges[k]];
      if (marks == 0) marks = edge(p[k], p[next], g[k], g[next]);
      if (edges[k] != own) quad.edge[edges[k]] = marks;
      seen = static_cast<Marks>(seen | marks);
      if ((seen & both) == both) return both;
    }
    const Marks within = found != nullptr ? found->centres : filter_.centres(p, box, seen);
    if ((seen & uncertain) == 0 && (seen | within) == seen) return seen;
    return ((seen | (within & filter_.clear())) & both) == both ? both : uncertain;
  }

  /// The marks of a closed edge with g at its ends; if it closes, of the part up to there.  An edge that deviates from
  /// a closing by 2 delta or less a texel is within 3 delta of a line that closes, which the bound has room for.
  Marks edge(PlanePoint p, PlanePoint q, double at_p, double at_q) const noexcept {
    constexpr double long_one = 1024;  // texels; shorter edges take less time than the search
    const double dx = q.x - p.x, dy = q.y - p.y;
    if (std::fabs(dx) + std::fabs(dy) > long_one)
      for (const Closing& c : (*exact_).closings()) {
        const auto x = static_cast<double>(c.columns), y = static_cast<double>(c.rows);
        if (!(std::fabs(dx * y - dy * x) <= 2 * filter_.delta() * (std::fabs(x) + std::fabs(y)))) continue;
        const bool by_x = std::fabs(x) >= std::fabs(y);
        const double length = by_x ? dx : dy, step = by_x ? x : y, sign = (length < 0) == (step < 0) ? 1 : -1;
        if (!(std::fabs(step) < std::fabs(length))) continue;
        const PlanePoint end{p.x + sign * x, p.y + sign * y};
        return filter_.edge(p, end, at_p, filter_.g(end));
      }
    return filter_.edge(p, q, at_p, at_q);
  }

  /// The marks of the segments of the dilated triangle, until both are seen.
  Marks outline(const Triangle& p, Marks seen) const {
    const Dilation& m = filter_.dilation();
    std::array<PlanePoint, 12> moved;
    std::array<double, 12> g;
    for (std::size_t k = 0; k < 12; ++k) {
      const PlanePoint at = p[k / 4];
      moved[k] = {k % 4 < 2 ? at.x - m.x : at.x + m.x, k % 4 == 0 || k % 4 == 3 ? at.y - m.y : at.y + m.y};
      g[k] = filter_.g(moved[k]);
      seen = static_cast<Marks>(seen | filter_.side(g[k]));
    }
    const auto take = [&](std::size_t from, std::size_t to) {
      if ((seen & both) != both)
        seen = static_cast<Marks>(seen | edge(moved[from], moved[to], g[from], g[to]));
    };
    for (std::size_t k = 0; k < 12; ++k) {
      take(k, k / 4 * 4 + (k + 1) % 4);
      take(k, (k + 4) % 12);
    }
    return seen;
  }

  const TexturePropertiesOf<Texel>& sides_;
  BilinearFilter<Texel> filter_;
  const ExactLater& exact_;
  InnerLater inner_;
  double lean_;  ///< g where alpha begins to lean to opaque: with BLEND half of the way from 1 to 0
  Lines lines_;
  NodeShapes shapes_;
};

}  // namespace mmverify::impl::bake::detail
