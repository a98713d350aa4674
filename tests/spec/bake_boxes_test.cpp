// [release] spec/bake/boxes.hpp, strips.hpp, range.hpp: the range and the states by boxes are those by single squares; long triangles cost little.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "spec/bake/state.hpp"

namespace {

using namespace mmverify;
namespace bake = spec::bake;
using bake::Filter;
using bake::Texture;
using bake::Wrap;
using Q = spec::Rational128;
using TexturePoint = bake::TexturePoint<Q>;
using Polygon = bake::Polygon<Q>;

Q q(std::int64_t m, std::int64_t n = 1) { return bake::fraction<Q>(m, n); }

constexpr Wrap wraps[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge, Wrap::clamp_to_border,
                          Wrap::mirror_once};

/// Random numbers, each drawn on its own.
class Draws {
 public:
  std::int64_t between(std::int64_t first, std::int64_t last) {
    return first + static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(last - first + 1));
  }

 private:
  std::mt19937_64 random_{5};
};

Texture any_texture(Draws& draws) {
  Texture t;
  t.width = static_cast<std::uint32_t>(draws.between(1, 6));
  t.height = static_cast<std::uint32_t>(draws.between(1, 6));
  const std::int64_t palette = draws.between(0, 2);
  for (std::uint32_t k = 0; k < t.width * t.height; ++k)
    t.alpha.push_back(static_cast<std::uint8_t>(palette == 0   ? draws.between(0, 255)
                                                : palette == 1 ? 255 * draws.between(0, 1)
                                                               : (draws.between(0, 7) == 0 ? 255 : 0)));
  t.wrap_x = wraps[draws.between(0, 4)];
  t.wrap_y = wraps[draws.between(0, 4)];
  t.border = static_cast<std::uint8_t>(draws.between(0, 255));
  t.filter = draws.between(0, 1) == 0 ? Filter::nearest : Filter::bilinear;
  return t;
}

/// A triangle, a dilated one, a segment or a point, up to 32 texels away.
Polygon any_polygon(Draws& draws) {
  const std::int64_t reach = std::int64_t{1} << draws.between(0, 5),
                     parts = std::int64_t{1} << draws.between(0, 3), kind = draws.between(0, 4);
  Polygon polygon;
  for (std::int64_t corner = kind == 0 ? draws.between(1, 2) : 3; corner > 0; --corner)
    polygon.push_back({q(draws.between(-reach * parts, reach * parts), parts),
                       q(draws.between(-reach * parts, reach * parts), parts)});
  return kind == 1 ? bake::dilated(polygon, q(1, 4)) : polygon;
}

TEST(SpecBakeBoxes, DistinctIndicesMeanAllThatTheOthersMean) {
  for (const Wrap wrap : wraps)
    for (std::uint32_t size = 1; size <= 4; ++size)
      for (std::int64_t first = -12; first <= 12; ++first)
        for (std::int64_t last = first; last <= 14; ++last) {
          const auto meant = [&](std::int64_t from, std::int64_t to) {
            std::set<std::optional<std::uint32_t>> all;
            for (std::int64_t k = from; k <= to; ++k) all.insert(bake::wrapped(wrap, k, size));
            return all;
          };
          const bake::Interval few = bake::distinct(wrap, {first, last}, size);
          ASSERT_EQ(meant(few.first, few.last), meant(first, last))
              << first << ".." << last << " of " << size;
          ASSERT_LE(few.size(), std::min<std::int64_t>(last - first + 1, 2 * size + 2));
        }
}

TEST(SpecBakeBoxes, RangesAreThoseOfSingleSquares) {
  Draws draws;
  for (int round = 0; round < 300; ++round) {
    const Texture t = any_texture(draws);
    const Polygon polygon = any_polygon(draws);
    const auto expected = bake::range_by_parts(t, polygon), got = bake::range(t, polygon);
    ASSERT_EQ(got.least, expected.least) << round;
    ASSERT_EQ(got.greatest, expected.greatest) << round;
  }
}

/// The state of an open polygon from each square that it meets in an area.
template <class Mode>
bake::State open_by_parts(const Texture& t, const Polygon& polygon, const Mode& mode) {
  std::optional<bake::State> all;
  bake::for_each_part(t, polygon, [&](const Polygon& part, const bake::Range<Q>& alpha) {
    if (!bake::has_area(part)) return;
    const bake::State here = bake::open_state_in(mode, alpha);
    all = all ? bake::merged(*all, here) : here;
  });
  return all.value();
}

template <class Mode>
void expect_states_by_parts(const Texture& t, const Polygon& polygon, const Mode& mode) {
  EXPECT_EQ(bake::closed_state(t, polygon, mode), bake::state_in(mode, bake::range_by_parts(t, polygon)));
  if (!bake::has_area(polygon)) return;
  EXPECT_EQ(bake::open_state(t, polygon, mode), open_by_parts(t, polygon, mode));
}

TEST(SpecBakeBoxes, StatesAreThoseOfSingleSquares) {
  Draws draws;
  for (int round = 0; round < 300; ++round) {
    const Texture t = any_texture(draws);
    const Polygon polygon = any_polygon(draws);
    SCOPED_TRACE(round);
    // A texel's own alpha is met exactly.
    const Q cutoff = q(round % 2 == 0 ? 128 : t.alpha[0], 255);
    expect_states_by_parts(t, polygon, bake::Mask<Q>{cutoff});
    expect_states_by_parts(t, polygon, bake::MaskAbove<Q>{cutoff});
    expect_states_by_parts(t, polygon, bake::Blend<Q>{});
  }
}

TEST(SpecBakeBoxes, AMillionRepeatsAreOne) {
  Texture t{64, 64, std::vector<std::uint8_t>(64 * 64, 200)};
  t.alpha[64 * 17 + 5] = 10;
  t.alpha[64 * 60 + 63] = 250;
  constexpr std::int64_t far = std::int64_t{64} << 20;
  const Polygon triangle{{q(1, 3), q(1, 7)}, {q(far), q(2, 3)}, {q(5, 3), q(far)}};
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat}) {
    t.wrap_x = t.wrap_y = wrap;
    for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
      t.filter = filter;
      const auto all = bake::range(t, triangle);
      EXPECT_EQ(all.least, q(10, 255));
      EXPECT_EQ(all.greatest, q(250, 255));
    }
  }
  t.wrap_x = t.wrap_y = Wrap::clamp_to_edge;
  const auto clamped = bake::range(t, Polygon{{q(-far), q(70)}, {q(-1), q(far)}, {q(-5), q(90)}});
  EXPECT_EQ(clamped.least, q(200, 255));
  EXPECT_EQ(clamped.greatest, q(200, 255));
}

}  // namespace
