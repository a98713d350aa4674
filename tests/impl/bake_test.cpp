// [memory] impl/bake/bake.hpp and impl/bake/square/map.hpp: every state as spec/bake/bake.hpp has it; the box; which way is up.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "impl/bake/square/map.hpp"
#include "spec/bake/range.hpp"
#include "tests/sanitized.hpp"

namespace impl_bake_test {

namespace spec = mmverify::spec::bake;
using namespace mmverify::impl::bake;
using mmverify::impl::vq::State;
using Number = mmverify::spec::Rational128;
using Place = spec::TexturePoint<Number>;
using States = std::vector<State>;

constexpr State T = State::T, C = State::C, O = State::O;

/// The texels, and what they are to both.
struct Picture {
  std::uint32_t width, height;
  std::vector<std::uint8_t> alpha;

  AlphaView view() const { return {alpha.data(), width, height, width}; }
  spec::Texture texture() const { return {width, height, alpha}; }
};

States squares(const AlphaView& view, const Box& box, Cutoff cutoff, std::uint32_t side) {
  States states(std::size_t{side} * side, static_cast<State>(0xee));
  square_map(view, box, cutoff, side, states);
  return states;
}

States triangles(const AlphaView& view, const Box& box, Cutoff cutoff, std::uint32_t side) {
  States states(2 * std::size_t{side} * side, static_cast<State>(0xee));
  triangle_map(view, box, cutoff, side, states);
  return states;
}

/// Corner (x, y) of the map's grid, y from the bottom, in the texture's coordinates.
Place grid(const Box& box, std::uint32_t side, std::uint32_t x, std::uint32_t y) {
  const auto along = [side](std::uint32_t begin, std::uint32_t size, std::uint32_t k) {
    return spec::fraction<Number>(std::int64_t{begin} * side + std::int64_t{size} * k, side);
  };
  return {along(box.x, box.width, x), along(box.y, box.height, side - y)};
}

Number exact(Cutoff cutoff) { return spec::fraction<Number>(cutoff.numerator, cutoff.denominator); }

void expect_specified(const spec::Texture& texture, const AlphaView& view, const Box& box, Cutoff cutoff,
                      std::uint32_t side, std::uint32_t x, std::uint32_t y, const States& square,
                      const States& halves) {
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return grid(box, side, i, j); };
  const auto state = [&](const spec::Polygon<Number>& p) {
    return static_cast<int>(spec::state(texture, p, exact(cutoff)));
  };
  const std::size_t k = x + std::size_t{side} * y;
  ASSERT_EQ(static_cast<int>(halves[2 * k]), state({at(x, y), at(x + 1, y), at(x, y + 1)}))
      << view.width << 'x' << view.height << " side " << side << " lower half of " << x << ' ' << y;
  ASSERT_EQ(static_cast<int>(halves[2 * k + 1]), state({at(x + 1, y + 1), at(x, y + 1), at(x + 1, y)}))
      << view.width << 'x' << view.height << " side " << side << " upper half of " << x << ' ' << y;
  ASSERT_EQ(static_cast<int>(square[k]), state({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)}))
      << view.width << 'x' << view.height << " side " << side << " region " << x << ' ' << y;
}

void expect_specified(const Picture& picture, const Box& box, Cutoff cutoff, std::uint32_t side) {
  const States square = squares(picture.view(), box, cutoff, side),
               halves = triangles(picture.view(), box, cutoff, side);
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x)
      ASSERT_NO_FATAL_FAILURE(
          expect_specified(picture.texture(), picture.view(), box, cutoff, side, x, y, square, halves));
}

/// Noise of several kinds: anything, nearly at 1/2, black and white, smooth.
Picture noise(std::mt19937& random, std::uint32_t width, std::uint32_t height) {
  Picture p{width, height, std::vector<std::uint8_t>(std::size_t{width} * height)};
  const auto kind = random() % 4;
  const auto slope_x = static_cast<int>(random() % 60) - 30, slope_y = static_cast<int>(random() % 60) - 30;
  for (std::uint32_t k = 0; k < p.alpha.size(); ++k) {
    const std::uint32_t r = static_cast<std::uint32_t>(random());
    const int plane = 128 + slope_x * static_cast<int>(k % width) + slope_y * static_cast<int>(k / width);
    p.alpha[k] =
        static_cast<std::uint8_t>(kind == 0   ? r % 256
                                  : kind == 1 ? 126 + r % 4
                                  : kind == 2 ? r % 2 * 255
                                              : static_cast<std::uint32_t>(std::clamp(plane, 0, 255)));
  }
  return p;
}

Box random_box(std::mt19937& random, std::uint32_t width, std::uint32_t height) {
  const auto x = static_cast<std::uint32_t>(random() % width),
             y = static_cast<std::uint32_t>(random() % height);
  return {x, y, 1 + static_cast<std::uint32_t>(random() % (width - x)),
          1 + static_cast<std::uint32_t>(random() % (height - y))};
}

TEST(ImplBake, StatesAreTheSpecifications) {
  std::mt19937 random(1);
  constexpr Cutoff cutoffs[] = {{1, 2}, {1, 2}, {162, 255}, {1, 255},
                                {1, 1}, {0, 1}, {1, 3},     {0xfffffffe, 0xffffffff}};
  for (int round = 0; round < (sanitized ? 500 : 5000); ++round) {
    const std::uint32_t most = round % 8 == 0 ? 12 : 4;
    const auto width = 1 + static_cast<std::uint32_t>(random() % most);
    const Picture picture = noise(random, width, 1 + static_cast<std::uint32_t>(random() % most));
    const Box box =
        round % 2 == 0 ? whole(picture.view()) : random_box(random, picture.width, picture.height);
    ASSERT_NO_FATAL_FAILURE(
        expect_specified(picture, box, cutoffs[random() % 8], 1 + static_cast<std::uint32_t>(random() % 4)));
  }
}

TEST(ImplBake, StatesOfHostilePicturesAreTheSpecifications) {
  std::vector<Picture> pictures;
  for (const std::uint8_t byte : std::vector<std::uint8_t>{0, 127, 128, 255})
    pictures.push_back({1, 1, {byte}});
  for (const std::uint32_t n : {2u, 7u, 40u})
    for (const auto& [low, high] : {std::pair{0, 255}, std::pair{127, 128}}) {
      std::vector<std::uint8_t> alternating;
      for (std::uint32_t k = 0; k < n; ++k)
        alternating.push_back(static_cast<std::uint8_t>(k % 2 == 0 ? low : high));
      pictures.push_back({n, 1, alternating});
      pictures.push_back({1, n, alternating});
    }
  Picture board{5, 5, {}};
  for (std::uint32_t k = 0; k < 25; ++k) board.alpha.push_back(k % 2 == 0 ? 0 : 255);
  pictures.push_back(board);
  for (const Picture& picture : pictures)
    for (const std::uint32_t side : {1u, 3u, 8u})
      if (!sanitized || side < 8) {
        ASSERT_NO_FATAL_FAILURE(expect_specified(picture, whole(picture.view()), {}, side));
      }
}

// The sides that are baked for, on pictures larger and smaller than they.
TEST(ImplBake, MapsOf16And32AreTheSpecifications) {
  std::mt19937 random(3);
  const Picture picture = noise(random, 13, 21), small = noise(random, 3, 2);
  ASSERT_NO_FATAL_FAILURE(expect_specified(picture, whole(picture.view()), {}, 16));
  if (sanitized) return;
  ASSERT_NO_FATAL_FAILURE(expect_specified(small, whole(small.view()), {}, 32));
}

// Opaque at the corners of the half and of all its pieces, but not at a point of its diagonal: on the cell of
// these four texels, 255 alpha = 200 - 200 t + 255 t^2 there, 160.8 at t = 20/51, and 163.75 where it ends.
TEST(ImplBake, OnlyTheDiagonalsTurningPointTells) {
  const Picture picture{2, 2, {200, 60, 140, 255}};
  const auto region = 1 + 4 * 2;  // texture coordinates [1/2, 1]^2
  const auto lower = [&](Cutoff cutoff) {
    return triangles(picture.view(), {0, 0, 2, 2}, cutoff, 4)[2 * region];
  };
  EXPECT_EQ(lower({160, 255}), O);
  EXPECT_EQ(lower({162, 255}), C);
  const Picture negative{2, 2, {55, 195, 115, 0}};  // 255 less each
  EXPECT_EQ(triangles(negative.view(), {0, 0, 2, 2}, {95, 255}, 4)[2 * region], T);
  EXPECT_EQ(triangles(negative.view(), {0, 0, 2, 2}, {93, 255}, 4)[2 * region], C);
}

// y counts from the bottom of the map and from the top of the texture.
TEST(ImplBake, TheTexturesFirstRowIsTheMapsLast) {
  Picture picture{8, 8, std::vector<std::uint8_t>(64, 0)};
  for (std::uint32_t y = 0; y < 4; ++y)
    for (std::uint32_t x = 0; x < 4; ++x) picture.alpha[x + 8 * y] = 255;  // the upper left quarter
  // Alpha is 1/2, which is opaque, on x = 4 and on y = 4, and 1/4 where they cross.
  EXPECT_EQ(squares(picture.view(), {0, 0, 8, 8}, {}, 4), (States{T, T, T, T,  //
                                                                  C, C, T, T,  //
                                                                  O, C, C, T,  //
                                                                  O, O, C, T}));
  const States halves = triangles(picture.view(), {0, 0, 8, 8}, {}, 1);
  EXPECT_EQ(halves, (States{C, C}));
  const Picture corner{2, 2, {0, 255, 0, 0}};
  // The lower left half meets no more of the opaque upper right than the diagonal's middle, at 1/4.
  EXPECT_EQ(triangles(corner.view(), {0, 0, 2, 2}, {}, 1), (States{T, C}));
}

TEST(ImplBake, RegionsThatMeetAreNeverOpaqueAndTransparent) {
  std::mt19937 random(4);
  for (int round = 0; round < 300; ++round) {
    const Picture picture = noise(random, 1 + static_cast<std::uint32_t>(random() % 30),
                                  1 + static_cast<std::uint32_t>(random() % 30));
    constexpr std::uint32_t side = 16;
    const States states = squares(picture.view(), whole(picture.view()), {}, side);
    for (std::uint32_t y = 0; y + 1 < side; ++y)
      for (std::uint32_t x = 0; x + 1 < side; ++x) {
        const std::array<State, 4> window{states[x + side * y], states[x + 1 + side * y],
                                          states[x + side * (y + 1)], states[x + 1 + side * (y + 1)]};
        ASSERT_FALSE(std::count(window.begin(), window.end(), O) > 0 &&
                     std::count(window.begin(), window.end(), T) > 0)
            << round;
      }
    // A region is O, or T, just where both halves are.
    const States halves = triangles(picture.view(), whole(picture.view()), {}, side);
    for (std::uint32_t k = 0; k < states.size(); ++k) {
      const bool same = halves[2 * k] == halves[2 * k + 1];
      ASSERT_EQ(states[k], same ? halves[2 * k] : C) << round;
    }
  }
}

TEST(ImplBake, TheOpaqueBoxIsTheSmallest) {
  std::mt19937 random(5);
  for (int round = 0; round < 2000; ++round) {
    const auto width = 1 + static_cast<std::uint32_t>(random() % 9),
               height = 1 + static_cast<std::uint32_t>(random() % 9);
    Picture picture{width, height, std::vector<std::uint8_t>(std::size_t{width} * height, 127)};
    for (auto n = random() % 4; n > 0; --n) picture.alpha[random() % picture.alpha.size()] = 128;
    std::uint32_t left = width, right = 0, top = height, bottom = 0;
    for (std::uint32_t k = 0; k < picture.alpha.size(); ++k)
      if (2 * picture.alpha[k] >= 255) {
        left = std::min(left, k % width);
        right = std::max(right, k % width + 1);
        top = std::min(top, k / width);
        bottom = std::max(bottom, k / width + 1);
      }
    const auto box = opaque_box(picture.view(), {});
    ASSERT_EQ(box.has_value(), right > 0);
    if (box) {
      ASSERT_EQ(*box, (Box{left, top, right - left, bottom - top}));
    }
  }
  const Picture none{2, 1, {127, 254}};
  EXPECT_FALSE(opaque_box(none.view(), {1, 1}).has_value());
  EXPECT_EQ(opaque_box(none.view(), {0, 1}), (Box{0, 0, 2, 1}));
}

// Cut out, a texel is all there is; within its texture it is not.
TEST(ImplBake, ACropIsATextureOfItsOwn) {
  Picture picture{3, 3, std::vector<std::uint8_t>(9, 0)};
  picture.alpha[4] = 255;
  const auto box = opaque_box(picture.view(), {});
  ASSERT_EQ(box, (Box{1, 1, 1, 1}));
  const AlphaView crop = cropped(picture.view(), *box);
  EXPECT_EQ(squares(crop, whole(crop), {}, 2), States(4, O));
  EXPECT_EQ(squares(picture.view(), *box, {}, 2), States(4, C));
}

// The largest of everything, on texels that overlap from row to row; under sanitizers an overflow would end
// the test.
TEST(ImplBake, NothingOverflows) {
  std::mt19937 random(6);
  std::vector<std::uint8_t> texels(2 * 16384);
  for (auto& byte : texels) byte = static_cast<std::uint8_t>(random() % 2 * 255);
  const AlphaView view{texels.data(), 16384, 16384, 1};
  const States square = squares(view, whole(view), {0xfffffffe, 0xffffffff}, max_side),
               halves = triangles(view, whole(view), {0xfffffffe, 0xffffffff}, max_side);
  EXPECT_EQ(square, States(square.size(), C));
  EXPECT_EQ(halves, States(halves.size(), C));
  const States one = triangles(view, whole(view), {1, 2}, 1);
  EXPECT_EQ(one, (States{C, C}));
}

// The longest rows and columns, against the specification where it is still quick.
TEST(ImplBake, LongPicturesAreTheSpecifications) {
  std::mt19937 random(7);
  for (const bool wide : {true, false}) {
    Picture picture{wide ? 16384u : 2u, wide ? 2u : 16384u, std::vector<std::uint8_t>(32768)};
    // Waves of about the size of a region, or nothing would be O or T.
    for (std::uint32_t k = 0; k < 32768; ++k) {
      const std::uint32_t along = wide ? k % 16384 : k / 2;
      picture.alpha[k] =
          static_cast<std::uint8_t>(along / 100 % 2 == 0 ? 100 + random() % 20 : 140 + random() % 20);
    }
    const Box box = whole(picture.view());
    const States square = squares(picture.view(), box, {}, max_side),
                 halves = triangles(picture.view(), box, {}, max_side);
    const spec::Texture texture = picture.texture();
    for (std::uint32_t k = 0; k < (sanitized ? 2u : 12u); ++k) {
      const auto along = static_cast<std::uint32_t>(random() % max_side),
                 across = static_cast<std::uint32_t>(random() % max_side);
      ASSERT_NO_FATAL_FAILURE(expect_specified(texture, picture.view(), box, {}, max_side,
                                               wide ? along : across, wide ? across : along, square, halves));
    }
  }
}

TEST(ImplBake, RefusesWhatIsOutside) {
  const Picture picture{2, 2, {0, 0, 0, 0}};
  const AlphaView view = picture.view();
  const Box all = whole(view);
  EXPECT_THROW(squares(view, {0, 0, 0, 1}, {}, 2), std::invalid_argument);
  EXPECT_THROW(squares(view, {1, 0, 2, 1}, {}, 2), std::invalid_argument);
  EXPECT_THROW(squares(view, {0, 0xffffffff, 1, 2}, {}, 2), std::invalid_argument);
  EXPECT_THROW(squares(view, all, {}, 0), std::invalid_argument);
  EXPECT_THROW(squares(view, all, {}, max_side + 1), std::invalid_argument);
  EXPECT_THROW(squares(view, all, {1, 0}, 2), std::invalid_argument);
  EXPECT_THROW(squares({picture.alpha.data(), 16385, 1, 0}, {0, 0, 1, 1}, {}, 2), std::invalid_argument);
  States states(7);
  EXPECT_THROW(square_map(view, all, {}, 2, states), std::invalid_argument);
  EXPECT_THROW(triangle_map(view, all, {}, 2, states), std::invalid_argument);
}

}  // namespace impl_bake_test
