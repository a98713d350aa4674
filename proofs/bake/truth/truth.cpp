#include "proofs/bake/truth/truth.hpp"

#include <numeric>

#include "proofs/bake/truth/exact_texture.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/points/narrow.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::bake {
namespace {

namespace bake = spec::bake;

template <class Q, class Stored>
State state_in(const Case& one, const std::vector<bake::TextureOf<Stored>>& mips, Level n,
               std::uint32_t index, Threshold threshold) {
  const auto uv = base_triangle<Q>(one);
  return with_mode<Q>(
      one,
      [&](const auto& mode) {
        const Q margin = bake::number<Q>(bake::Binary32{std::bit_cast<std::uint32_t>(one.margin)});
        return bake::micro_state(std::span<const bake::TextureOf<Stored>>(mips), uv, n, index, mode, margin,
                                 one.rules.contact, travel_of<Q>(one));
      },
      threshold);
}

/// A number that another case hardly has.
class Mixed {
 public:
  void take(std::uint64_t x) {
    low_ = (low_ ^ x) * 0x9E3779B97F4A7C15u;
    low_ ^= low_ >> 32;
    high_ = (high_ + x) * 0xD6E8FEB86659FD93u;
    high_ ^= high_ >> 29;
  }
  void take(float x) { take(std::uint64_t{std::bit_cast<std::uint32_t>(x)}); }
  std::uint64_t low() const { return low_; }
  std::pair<std::uint64_t, std::uint64_t> both() const { return {low_, high_}; }

 private:
  std::uint64_t low_ = 1, high_ = 2;
};

/// All that a case's text says of it but its texels.
Mixed mixed(const Case& one, Level n) {
  Mixed m;
  const bool border = one.wrap_u == Wrap::clamp_to_border || one.wrap_v == Wrap::clamp_to_border;
  const Cutoff cutoff = one.blend ? Cutoff{0, 0} : one.cutoff;
  for (const std::uint64_t x :
       {std::uint64_t{n}, std::uint64_t{one.width}, std::uint64_t{one.height}, std::uint64_t{one.mips},
        static_cast<std::uint64_t>(one.texel), static_cast<std::uint64_t>(one.filter),
        static_cast<std::uint64_t>(one.wrap_u), static_cast<std::uint64_t>(one.wrap_v),
        std::uint64_t{border ? one.border : 0}, std::uint64_t{cutoff.numerator},
        std::uint64_t{cutoff.denominator}})
    m.take(x);
  if (one.rules != Rules{}) {
    m.take(std::uint64_t{one.rules.above} + 2 * static_cast<std::uint64_t>(one.rules.contact));
    m.take(one.rules.slack);
  }
  for (const float x : {one.factor, one.vertex_factor, one.margin}) m.take(x);
  if (one.travel != std::array<float, 2>{})
    for (const float x : one.travel) m.take(x);
  for (const float x : one.uv) m.take(x);
  return m;
}

/// Points of the base triangle whose texels are the texture's own, or next to it.
class OnTexture {
 public:
  explicit OnTexture(const Case& one) : uv_(one.uv) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto [low, high] = std::minmax({uv_[axis], uv_[2 + axis], uv_[4 + axis]});
      low_[axis] = low;
      high_[axis] = high;
      const Wrap wrap = axis == 0 ? one.wrap_u : one.wrap_v;
      if (wrap == Wrap::repeat || wrap == Wrap::mirrored_repeat) continue;
      const double beside = 1.5 / (axis == 0 ? one.width : one.height);
      low_[axis] = std::max(low_[axis], (wrap == Wrap::mirror_once ? -1 : 0) - beside);
      high_[axis] = std::min(high_[axis], 1 + beside);
    }
  }

  /// The micro-triangle that holds such a point, if some draws meet one.
  std::optional<std::uint32_t> drawn(Level n, Random& random) const {
    const double ux = double{uv_[2]} - uv_[0], uy = double{uv_[3]} - uv_[1], vx = double{uv_[4]} - uv_[0],
                 vy = double{uv_[5]} - uv_[1], area = ux * vy - uy * vx, side = spec::side(n);
    if (area == 0 || low_[0] > high_[0] || low_[1] > high_[1]) return std::nullopt;
    for (int k = 0; k < 8; ++k) {
      const auto within = [&](std::size_t axis) {
        return low_[axis] +
               (high_[axis] - low_[axis]) * (static_cast<double>(random.below(1u << 31)) / (1u << 31)) -
               uv_[axis];
      };
      const double x = within(0), y = within(1), u = (x * vy - y * vx) / area * side,
                   v = (ux * y - uy * x) / area * side;
      if (!(u >= 0 && v >= 0 && u + v < side)) continue;
      const auto i = static_cast<std::uint32_t>(u), j = static_cast<std::uint32_t>(v);
      const bool upper = u - i + v - j >= 1 && i + j + 2 <= spec::side(n);
      if (i + j < spec::side(n))
        return spec::index::curve(spec::index::grid_square<std::uint32_t>(i, j, upper, spec::side(n)),
                                  spec::side(n) - 1);
    }
    return std::nullopt;
  }

 private:
  std::array<float, 6> uv_;
  std::array<double, 2> low_{}, high_{};
};

/// Takes each place that may be an extreme of the part of a polygon within one cell, as bake::range does.
template <class Stored, class Take>
void candidates(const bake::TextureOf<Stored>& t, std::int64_t i, std::int64_t j,
                const bake::Polygon<Rational>& part, Take take) {
  const bake::Cell<Rational> cell(t, i, j);
  for (std::size_t corner = 0; corner < part.size(); ++corner) {
    const TexturePoint &from = part[corner], &to = part[(corner + 1) % part.size()];
    take(from);
    const TexturePoint p = cell.local(from);
    const Rational x = to.x - from.x, y = to.y - from.y, k = cell.d * x * y,
                   l = cell.b * x + cell.c * y + cell.d * (p.x * y + p.y * x);
    if (k == 0) continue;
    const Rational along = -l / (k + k);
    if (along > 0 && along < 1) take(TexturePoint{from.x + along * x, from.y + along * y});
  }
}

}  // namespace

State true_state(const Case& one, Level n, std::uint32_t index) {
  return with_textures(one, [&](const auto& mips) {
    return in_smallest([&]<class Q>() { return state_in<Q>(one, mips, n, index, Threshold::exact); });
  });
}

std::vector<State> true_map(const Case& one, Level n) {
  std::vector<State> states(std::size_t{1} << 2 * n);
  with_textures(one, [&](const auto& mips) {
    for (std::uint32_t k = 0; k < states.size(); ++k)
      states[k] = in_smallest([&]<class Q>() { return state_in<Q>(one, mips, n, k, Threshold::exact); });
  });
  return states;
}

std::vector<std::uint32_t> judged_at(const Case& one, Level n) {
  // The specification's time is that of cells: of all mips, under margins.
  const double across = 2 + 2 * (double{one.margin} + double{one.travel[0]} * one.width),
               down = 2 + 2 * (double{one.margin} + double{one.travel[1]} * one.height),
               cells = across * down * one.mips;
  const bool stratum = one.width > 7 || one.height > 7;  // the other samples have no such texture
  const std::uint32_t count = std::uint32_t{1} << 2 * n, drawn = 32,
                      most = stratum ? static_cast<std::uint32_t>(std::clamp(640 / cells, 8.0, 24.0)) : 64;
  std::vector<std::uint32_t> at;
  if (count <= most) {
    at.resize(count);
    std::iota(at.begin(), at.end(), 0u);
    return at;
  }
  // The triangle's own corners, which nearly all rounding moves.
  at = {
      0, count - 1,
      spec::index::curve(spec::index::grid_square<std::uint32_t>(spec::side(n) - 1, 0, false, spec::side(n)),
                         spec::side(n) - 1)};
  Random random(mixed(one, n).low(), 1, n);
  const OnTexture texture(one);
  const auto on_texture = [&] {
    return texture.drawn(n, random).value_or(static_cast<std::uint32_t>(random.below(count)));
  };
  if (stratum) {
    const std::uint32_t spread = most / 2;
    for (std::uint32_t k = 1; k + 2 < spread; ++k)
      at.push_back(
          static_cast<std::uint32_t>(std::uint64_t{count} * k / spread + random.below(count / spread)));
    while (at.size() < most) at.push_back(on_texture());
    return at;
  }
  // Spread evenly, and not always the same child of a parent.
  for (std::uint32_t k = 0; k < most; ++k) at.push_back(count / most * k + k % 4 * (count / most / 4));
  while (at.size() < most + drawn) at.push_back(on_texture());
  return at;
}

Truth true_states(const Case& one, Level n, const std::vector<std::uint32_t>& at) {
  const auto states = [&](Threshold threshold) {
    std::vector<State> found;
    with_textures(one, [&](const auto& mips) {
      for (const std::uint32_t index : at)
        found.push_back(in_smallest([&]<class Q>() { return state_in<Q>(one, mips, n, index, threshold); }));
    });
    return found;
  };
  Truth truth;
  truth.lower = states(Threshold::lower);
  truth.upper = one.rules.slack != 0 ? states(Threshold::upper) : truth.lower;
  return truth;
}

Truth true_states(const Case& one, Level n) {
  // The laws of states ask about the same samples, and so do their mutants.
  constexpr std::size_t most = 1 << 14;
  static std::mutex lock;
  static std::map<std::pair<std::uint64_t, std::uint64_t>, Truth> known;
  Mixed name = mixed(one, n);
  for (const std::uint32_t bits : one.alpha) name.take(std::uint64_t{bits});
  {
    const std::lock_guard hold(lock);
    if (const auto found = known.find(name.both()); found != known.end()) return found->second;
  }
  Truth truth = true_states(one, n, judged_at(one, n));
  const std::lock_guard hold(lock);
  if (known.size() < most) known.emplace(name.both(), truth);
  return truth;
}

bake::Polygon<Rational> corners_of(const Case& one, Level n, std::uint32_t index) {
  return bake::micro_triangle(base_triangle<Rational>(one), n, index, one.width, one.height);
}

namespace {

/// The place of a texel that is an extreme of a box in a polygon: its centre.
template <class Stored>
TexturePoint centre_of(const bake::Box& box, const bake::TexelAt<Stored>& at, std::int64_t next) {
  // The texel's index is the box's own, or that of the end that the box is clamped to.
  const auto i = std::clamp(at.i, box.columns.first, box.columns.last + next),
             j = std::clamp(at.j, box.rows.first, box.rows.last + next);
  return {bake::fraction<Rational>(2 * i + 1, 2), bake::fraction<Rational>(2 * j + 1, 2)};
}

/// Takes a place of the least alpha on a polygon and one of the greatest, and others.  Along many repeats, where
/// `most_boxes` do not hold them, the best that these hold.
template <class Stored, class Take>
void extreme_places(const bake::TextureOf<Stored>& t, const bake::Polygon<Rational>& polygon, Take take) {
  constexpr int most_boxes = 4096;
  const std::int64_t next = t.filter == Filter::bilinear ? 1 : 0;
  const auto all = bake::range(t, polygon);
  std::optional<bake::Range<Rational>> found;
  int boxes = 0;
  const auto taken = [&](const TexturePoint& p) {
    const Rational alpha = bake::alpha(t, p);
    if (!found) found = bake::Range<Rational>(alpha);
    found->take(alpha);
    take(p, alpha);
  };
  bake::for_each_box<Rational>(
      t, polygon,
      [&](const bake::BoxTexels<Stored>& texels, const bake::BoxPart<Rational>& one, bool whole) {
        const auto knows = [&](const bake::Range<Rational>& some) {
          return found && found->least <= some.least && some.greatest <= found->greatest;
        };
        if (knows(all) || knows(bake::range<Rational>(t, texels)) || ++boxes > most_boxes) return true;
        const TexturePoint middle = bake::centroid(one.part);
        for (const auto& at : {texels.least, texels.greatest})
          if (whole)
            taken(centre_of(one.box, at, next));
          else if (bake::has_centre(t, one.part, middle, at))
            taken({bake::Cell<Rational>::along(bake::nearest_index(t.wrap_x, at.i, t.width, middle.x)),
                   bake::Cell<Rational>::along(bake::nearest_index(t.wrap_y, at.j, t.height, middle.y))});
        return whole;
      },
      [&](std::int64_t i, std::int64_t j, const bake::Polygon<Rational>& part) {
        if (t.filter == Filter::nearest)
          taken(bake::centroid(part));  // below its high sides, as some corner is: the texel's own
        else
          candidates(t, i, j, part, taken);
      });
  if (!found) taken(bake::centroid(polygon));
}

}  // namespace

Extremes extremes(const Case& one, Level n, std::uint32_t index) {
  const auto margin = bake::number<Rational>(bake::Binary32{std::bit_cast<std::uint32_t>(one.margin)});
  const auto travel = travel_of<Rational>(one);
  return with_textures(one, [&](const auto& mips) {
    std::optional<Extremes> found;
    for (std::uint32_t mip = 0; mip < mips.size(); ++mip) {
      const auto& t = mips[mip];
      const bake::Polygon<Rational> polygon = bake::dilated(
          bake::micro_triangle(base_triangle<Rational>(one), n, index, t.width, t.height),
          Rational(margin + travel.x * Rational(t.width)), Rational(margin + travel.y * Rational(t.height)));
      extreme_places(t, polygon, [&](const TexturePoint& p, const Rational& alpha) {
        const Extreme here{p, alpha, mip};
        if (!found) found = Extremes{here, here};
        if (here.alpha < found->least.alpha) found->least = here;
        if (here.alpha > found->greatest.alpha) found->greatest = here;
      });
    }
    return found.value();
  });
}

}  // namespace mmverify::proofs::bake
