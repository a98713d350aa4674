// [release, night] Micro-triangles of many texels, and nodes of sixteen (impl/bake/sixteen/sixteen.hpp), where mixed cells are few or
// at corners: every state as the whole numbers of impl/bake/exact/base.hpp have it, and
// some as spec/bake/state.hpp does.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <sstream>
#include <vector>

#include "impl/bake/exact/base.hpp"
#include "impl/bake/triangles.hpp"
#include "spec/bake/state.hpp"
#include "tests/sanitized.hpp"

namespace impl_bake_cells_test {

namespace spec = mmverify::spec::bake;
using namespace mmverify::impl::bake;
using mmverify::spec::Rational;

struct Picture {
  std::uint32_t width, height;
  std::vector<std::uint8_t> alpha;

  AlphaView view() const { return {alpha.data(), width, height, width}; }
};

/// A picture of one alpha except for one texel.
Picture speck(std::uint32_t width, std::uint32_t height, std::uint32_t x, std::uint32_t y,
              std::uint8_t around, std::uint8_t alpha) {
  Picture p{width, height, std::vector<std::uint8_t>(std::size_t{width} * height, around)};
  p.alpha[x + std::size_t{width} * y] = alpha;
  return p;
}

std::string named(const Picture& p, const BaseTriangle& uv, std::uint32_t level) {
  std::ostringstream out;
  out << std::hexfloat << p.width << 'x' << p.height << " level " << level << " uv";
  for (const TexturePoint& v : uv) out << " (" << v.u << ", " << v.v << ')';
  return out.str();
}

/// Corners in texels from the outer corner of the first.
BaseTriangle in_texels(const Picture& p, const std::array<std::array<float, 2>, 3>& at) {
  BaseTriangle uv;
  for (std::size_t k = 0; k < 3; ++k)
    uv[k] = {at[k][0] / static_cast<float>(p.width), at[k][1] / static_cast<float>(p.height)};
  return uv;
}

/// `step`: of the micro-triangles that the specification is asked about; 0: none.
void expect_exact(const Picture& picture, const AlphaMode& mode, const Addressing& addressing,
                  const BaseTriangle& uv, std::uint32_t level, std::uint32_t step = 0) {
  const std::uint32_t count = 1u << (2 * level);
  std::vector<std::uint8_t> map((count + 3) / 4, 0xee);
  const Texels texels = picture.view();
  const Sampling sampling{addressing.u, addressing.v, Filter::bilinear,
                          static_cast<float>(addressing.border)};
  TriangleBaker(std::span(&texels, 1), mode, sampling).bake(uv, level, map);
  const detail::TexturePropertiesOf<std::uint8_t> sides(picture.view(), detail::limits_of(mode, {1, 1}, 255),
                                                        addressing.u, addressing.v, addressing.border);
  const detail::ExactBase exact(sides, uv, picture.width, picture.height, level);
  const spec::Texture texture{picture.width,
                              picture.height,
                              picture.alpha,
                              static_cast<spec::Wrap>(addressing.u),
                              static_cast<spec::Wrap>(addressing.v),
                              addressing.border};
  for (std::uint32_t index = 0; index < count; ++index) {
    const int state = map[index / 4] >> (2 * (index % 4)) & 3;
    const auto [marks, leans_to_opaque] = exact(index);
    const int expected = marks == detail::both ? (leans_to_opaque ? 3 : 2) : marks == detail::opaque ? 1 : 0;
    ASSERT_EQ(state, expected) << named(picture, uv, level) << " index " << index;
    if (step == 0 || index % step != 0) continue;
    if (const auto* const cutoff = std::get_if<Cutoff>(&mode)) {
      const auto vertex = [&](std::size_t k) {
        return spec::place<Rational>({std::bit_cast<std::uint32_t>(uv[k].u)},
                                     {std::bit_cast<std::uint32_t>(uv[k].v)});
      };
      const spec::BaseTriangle<Rational> base{vertex(0), vertex(1), vertex(2)};
      const spec::Mask<Rational> mask{spec::fraction<Rational>(cutoff->numerator, cutoff->denominator)};
      ASSERT_EQ(state, static_cast<int>(spec::micro_state(texture, base, level, index, mask)))
          << named(picture, uv, level) << " index " << index;
    }
  }
}

using Corners = std::array<std::array<float, 2>, 3>;
/// Oblique; two edges along the axes, on centres and between; an edge that falls by less than a texel in all,
/// at the top and at the bottom; turned over; thin.
const std::vector<Corners> shapes{
    {{{3.2f, 4.1f}, {36.7f, 9.3f}, {11.9f, 37.6f}}},
    {{{4.5f, 4.5f}, {36.5f, 4.5f}, {4.5f, 36.5f}}},
    {{{36, 36}, {4, 36}, {36, 4}}},
    {{{3, 5}, {37, 5.7f}, {20.3f, 36.4f}}},
    {{{37.5f, 36.4f}, {3.5f, 36.5f}, {21.5f, 4.5f}}},
    {{{5.25f, 3}, {9.75f, 37.5f}, {7.25f, 36}}},
    {{{3.5f, 20.5f}, {38.5f, 24.25f}, {37.5f, 25.75f}}},
    {{{20, 3}, {37, 20}, {3, 20}}},
};

// Slivers whose long edge is on a column of centres, and a texel that differs just above the apex: there the two
// long edges' lines are closer than rounding tells, and the row of that centre is not the triangle's.
TEST(ImplBakeCells, ARowBeyondAnApexIsNotTheSlivers) {
  constexpr std::uint32_t width = 8, height = 16, level = 7;
  const Picture upright = speck(width, height, 2, 5, 0, 128), lying = speck(height, width, 5, 2, 0, 128);
  for (const bool lies : {false, true})
    for (const bool is_right : {false, true})
      for (int k = 0; k < (sanitized ? 1 : 8); ++k) {
        const float thin = 0x1.95fp-13f + 0x1p-19f * static_cast<float>(k), beside = is_right ? thin : -thin;
        BaseTriangle uv{
            {{0x1.4p-2f, 0x1.61p-2f}, {0x1.4p-2f, 0x1.82c2p+5f}, {0x1.4p-2f + beside, 0x1.80c2p+5f}}};
        if (lies)
          for (TexturePoint& v : uv) std::swap(v.u, v.v);
        ASSERT_NO_FATAL_FAILURE(
            expect_exact(lies ? lying : upright, Cutoff{1, 2}, {Wrap::repeat, Wrap::repeat, 0}, uv, level));
      }
}

// One texel that differs, everywhere: within, on an edge, a cell or two beside one, at a corner.  The contour
// about it is next to a point, half a texel wide, and all but as wide as its cells.
TEST(ImplBakeCells, ASpeckIsSeenWhereverItIs) {
  constexpr std::uint32_t size = 41;
  const std::vector<Cutoff> cutoffs{{254, 255}, {1, 2}, {1, 255}};
  std::uint32_t round = 0;
  for (const Corners& shape : shapes)
    for (std::uint32_t y = 0; y < size; ++y)
      for (std::uint32_t x = 0; x < size; ++x) {
        if (++round % (sanitized ? 61 : 3) != 0) continue;
        const bool dark = round / 3 % 2 != 0;
        const Picture p = speck(size, size, x, y, dark ? 255 : 0, dark ? 0 : 255);
        const Cutoff cutoff = cutoffs[round / 6 % 3];
        ASSERT_NO_FATAL_FAILURE(expect_exact(p, cutoff, {}, in_texels(p, shape), round / 18 % 2 == 0 ? 2 : 4))
            << "speck " << x << ' ' << y << " cutoff " << cutoff.numerator;
      }
}

// The same beyond what a node of sixteen may span: one by one, in more strips of words than one.
TEST(ImplBakeCells, ASpeckIsSeenByLargeMicroTriangles) {
  constexpr std::uint32_t width = 330, height = 300;
  std::mt19937 random(11);
  for (int round = 0; round < (sanitized ? 40 : 1200); ++round) {
    const Corners& shape = shapes[static_cast<std::size_t>(round) % shapes.size()];
    Corners large = shape;
    for (auto& at : large) at = {at[0] * 7.5f, at[1] * 7.5f};
    // Beside an edge, at any of its places.
    const std::size_t k = random() % 3, next = (k + 1) % 3;
    const float part = static_cast<float>(random() % 1024) / 1024;
    const auto near = [&](std::size_t axis, std::uint32_t most) {
      const float at = large[k][axis] + part * (large[next][axis] - large[k][axis]);
      return std::min(most - 1,
                      static_cast<std::uint32_t>(at) + static_cast<std::uint32_t>(random() % 4) - 2);
    };
    const bool dark = round % 2 != 0;
    const Picture p = speck(width, height, near(0, width), near(1, height), dark ? 255 : 0, dark ? 0 : 255);
    const Cutoff cutoff = round % 3 == 0 ? Cutoff{254, 255} : round % 3 == 1 ? Cutoff{1, 2} : Cutoff{1, 255};
    ASSERT_NO_FATAL_FAILURE(expect_exact(p, cutoff, {}, in_texels(p, large), 2)) << round;
  }
}

Picture blobs(std::mt19937& random, std::uint32_t width, std::uint32_t height) {
  Picture p{width, height, {}};
  const double a = 0.05 + static_cast<double>(random() % 100) / 200,
               b = 0.05 + static_cast<double>(random() % 100) / 200, steep = random() % 2 != 0 ? 100 : 4000;
  const auto kind = random() % 4;
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      const double alpha = kind == 0 ? static_cast<double>(random() % 25 == 0 ? 255 : 0)
                                     : 128 + steep * std::sin(a * x) * std::cos(b * y) +
                                           (kind == 1 ? 0.0 : static_cast<double>(random() % 9) - 4);
      p.alpha.push_back(static_cast<std::uint8_t>(std::clamp(alpha, 0.0, 255.0)));
    }
  return p;
}

// Micro-triangles from a texel to eighty, of all orientations, in every mode, over seams and at the edges of
// the picture, whose sides are no multiples of words or tiles.
TEST(ImplBakeCells, ContoursOfManyTexelsAreExact) {
  std::mt19937 random(12);
  constexpr Wrap wraps[] = {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat, Wrap::clamp_to_border};
  for (int round = 0; round < (sanitized ? 12 : 300); ++round) {
    const Picture p = blobs(random, 30 + static_cast<std::uint32_t>(random() % 180),
                            30 + static_cast<std::uint32_t>(random() % 180));
    const float size = std::ldexp(1.0f, -static_cast<int>(random() % 4));
    const auto unit = [&random] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    const bool is_on_lines = random() % 3 == 0;
    const float x = unit() * (1.1f - size), y = unit() * (1.1f - size);
    BaseTriangle uv;
    for (TexturePoint& v : uv) {
      v = {x + size * unit(), y + size * unit()};
      if (is_on_lines)
        v = {std::round(2 * v.u * static_cast<float>(p.width)) / (2 * static_cast<float>(p.width)),
             std::round(2 * v.v * static_cast<float>(p.height)) / (2 * static_cast<float>(p.height))};
    }
    if (random() % 4 == 0) uv[1].v = uv[0].v;
    const AlphaMode mode =
        random() % 5 == 0 ? AlphaMode(Blend{}) : Cutoff{random() % 4 == 0 ? 51u : 128u, 255};
    const Addressing addressing{wraps[random() % 4], wraps[random() % 4],
                                static_cast<std::uint8_t>(random())};
    const auto level = static_cast<std::uint32_t>(1 + random() % 4);
    ASSERT_NO_FATAL_FAILURE(
        expect_exact(p, mode, addressing, uv, level, sanitized || round % 10 != 0 ? 0 : 61))
        << round;
  }
}

// Letters on rows and columns of centres, micro-vertices on them, too: contours through corners of
// micro-triangles and along their edges, alpha at the cutoff there and nowhere else.
TEST(ImplBakeCells, ContoursThroughCornersAndAlongEdgesAreExact) {
  std::mt19937 random(13);
  for (int round = 0; round < (sanitized ? 20 : 400); ++round) {
    constexpr std::uint32_t size = 64;
    Picture p{size, size, std::vector<std::uint8_t>(size * size)};
    const auto kind = random() % 3;
    const std::uint32_t line = 8 + static_cast<std::uint32_t>(random() % 48);
    for (std::uint32_t y = 0; y < size; ++y)
      for (std::uint32_t x = 0; x < size; ++x) {
        const std::uint32_t at = kind == 0 ? x : kind == 1 ? y : (x + y) / 2;
        const bool above = at > line, on = at == line;
        p.alpha[x + size * y] = static_cast<std::uint8_t>(on                   ? 128
                                                          : above              ? 255
                                                          : random() % 16 == 0 ? 128
                                                                               : 127);
      }
    Corners corners;
    // Whole steps of a micro-edge, from a centre.
    for (auto& at : corners)
      at = {0.5f + 4 * static_cast<float>(random() % 16), 0.5f + 4 * static_cast<float>(random() % 16)};
    ASSERT_NO_FATAL_FAILURE(expect_exact(p, Cutoff{128, 255}, {Wrap::clamp_to_edge, Wrap::clamp_to_edge},
                                         in_texels(p, corners), 2, sanitized ? 0 : 13))
        << round;
  }
}

}  // namespace impl_bake_cells_test
