// [release] FLIP against its formulas, worked slowly, and against values of the authors' own program.
#include "scene/flip/flip.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include "tests/complaint.hpp"

namespace {

using namespace mmverify::flip;

struct Pixels {
  std::uint32_t width, height;
  std::vector<std::uint8_t> rgb;
  operator Picture() const { return {width, height, rgb}; }
};

template <class Code>
Pixels drawn(std::uint32_t width, std::uint32_t height, Code code) {
  Pixels p{width, height, {}};
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      for (std::uint32_t c = 0; c < 3; ++c) p.rgb.push_back(static_cast<std::uint8_t>(code(x, y, c)));
  return p;
}

Pixels constant(std::uint32_t width, std::uint32_t height, std::array<std::uint8_t, 3> rgb) {
  return drawn(width, height, [&](auto, auto, auto c) { return rgb[c]; });
}

Pixels random_pixels(std::uint32_t width, std::uint32_t height, unsigned seed) {
  std::mt19937 engine(seed);
  return drawn(width, height, [&](auto, auto, auto) { return engine() & 255; });
}

// ---- The formulas once more: long double, filters over the whole square, sRGB's and XYZ's numbers written down again

using Real = long double;
using Triple = std::array<Real, 3>;
constexpr Real pi = std::numbers::pi_v<Real>;

Triple xyz_of(const Triple& c) {
  return {(10135552 * c[0] + 8788810 * c[1] + 4435075 * c[2]) / 24577794,
          (2613072 * c[0] + 8788810 * c[1] + 887015 * c[2]) / 12288897,
          (1425312 * c[0] + 8788810 * c[1] + 70074185 * c[2]) / 73733382};
}

/// Cramer's rule on the matrix above, column by column.
Triple rgb_of(const Triple& xyz) {
  const Triple r = xyz_of({1, 0, 0}), g = xyz_of({0, 1, 0}), b = xyz_of({0, 0, 1});
  const auto determinant = [](const Triple& p, const Triple& q, const Triple& s) {
    return p[0] * (q[1] * s[2] - q[2] * s[1]) - q[0] * (p[1] * s[2] - p[2] * s[1]) +
           s[0] * (p[1] * q[2] - p[2] * q[1]);
  };
  const Real all = determinant(r, g, b);
  return {determinant(xyz, g, b) / all, determinant(r, xyz, b) / all, determinant(r, g, xyz) / all};
}

const Triple white = xyz_of({1, 1, 1});

Triple light_of(const Pixels& p, int x, int y) {
  x = std::clamp(x, 0, static_cast<int>(p.width) - 1);
  y = std::clamp(y, 0, static_cast<int>(p.height) - 1);
  Triple light;
  for (std::size_t c = 0; c < 3; ++c) {
    const Real s = static_cast<Real>(
                       p.rgb[3 * (static_cast<std::size_t>(y) * p.width + static_cast<std::size_t>(x)) + c]) /
                   255;
    light[c] = s <= 0.04045L ? s / 12.92L : std::pow((s + 0.055L) / 1.055L, 2.4L);
  }
  return light;
}

Triple ycxcz_of(const Triple& light) {
  const Triple xyz = xyz_of(light);
  const Real x = xyz[0] / white[0], y = xyz[1] / white[1], z = xyz[2] / white[2];
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// L*, a*, b*, the last two times L*/100.
Triple lab_of(const Triple& light) {
  const Triple xyz = xyz_of(light);
  const auto f = [](Real t) {
    const Real delta = Real{6} / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + Real{4} / 29;
  };
  const Real x = f(xyz[0] / white[0]), y = f(xyz[1] / white[1]), z = f(xyz[2] / white[2]);
  const Real l = 116 * y - 16;
  return {l, l / 100 * 500 * (x - y), l / 100 * 200 * (y - z)};
}

Real distance(const Triple& a, const Triple& b) {
  return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

/// The remapped difference of colour: 0.7th powers, [0, 0.4 most] to [0, 0.95], the rest to [0.95, 1].
Real colour_error(const Triple& a, const Triple& b) {
  const Real most = std::pow(distance(lab_of({0, 1, 0}), lab_of({0, 0, 1})), 0.7L);
  const Real d = std::pow(distance(a, b), 0.7L), bend = 0.4L * most;
  return d < bend ? 0.95L / bend * d : 0.95L + (d - bend) / (most - bend) * 0.05L;
}

template <class Weight>
void over_square(int radius, Weight weight) {
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x) weight(x, y);
}

/// Texel (x, y) as blurred by the eye, back in linear RGB within [0, 1].
Triple resolved(const Pixels& p, int x, int y, Real ppd) {
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04L / (2 * pi * pi)) * ppd));
  const auto gauss = [&](int i, int j, Real a, Real b) {
    return a * std::sqrt(pi / b) * std::exp(-pi * pi * Real(i * i + j * j) / (ppd * ppd) / b);
  };
  Triple sum{}, weights{};
  over_square(radius, [&](int i, int j) {
    const Triple texel = ycxcz_of(light_of(p, x + i, y + j));
    const Triple w = {gauss(i, j, 1, 0.0047L), gauss(i, j, 1, 0.0053L),
                      gauss(i, j, 34.1L, 0.04L) + gauss(i, j, 13.5L, 0.025L)};
    for (std::size_t k = 0; k < 3; ++k) sum[k] += w[k] * texel[k], weights[k] += w[k];
  });
  const Real luminance = (sum[0] / weights[0] + 16) / 116;
  Triple light = rgb_of({(luminance + sum[1] / weights[1] / 500) * white[0], luminance * white[1],
                         (luminance - sum[2] / weights[2] / 200) * white[2]});
  for (Real& c : light) c = std::clamp(c, Real{0}, Real{1});
  return light;
}

/// The lengths of the gradients of edges and of points.
std::array<Real, 2> features(const Pixels& p, int x, int y, Real ppd) {
  const Real s = 0.082L / 2 * ppd;
  const int radius = static_cast<int>(std::ceil(3 * s));
  const auto gauss = [&](int i, int j) { return std::exp(-Real(i * i + j * j) / (2 * s * s)); };
  const auto edge = [&](int i, int j) { return -i * gauss(i, j); };
  const auto point = [&](int i, int j) { return (i * i / (s * s) - 1) * gauss(i, j); };
  std::array<Real, 2> lengths{};
  for (const bool of_points : {false, true}) {
    Real positive = 0, negative = 0, along_x = 0, along_y = 0;
    const auto weight = [&](int i, int j) { return of_points ? point(i, j) : edge(i, j); };
    over_square(radius, [&](int i, int j) {
      const Real w = weight(i, j);
      (w > 0 ? positive : negative) += std::abs(w);
    });
    over_square(radius, [&](int i, int j) {
      const auto normal = [&](Real w) { return w / (w > 0 ? positive : negative); };
      const Real y_of_texel = (ycxcz_of(light_of(p, x + i, y + j))[0] + 16) / 116;
      along_x += normal(weight(i, j)) * y_of_texel;
      along_y += normal(weight(j, i)) * y_of_texel;
    });
    lengths[of_points] = std::hypot(along_x, along_y);
  }
  return lengths;
}

Real slow_error(const Pixels& a, const Pixels& b, int x, int y, Real ppd) {
  const Real colour = colour_error(lab_of(resolved(a, x, y, ppd)), lab_of(resolved(b, x, y, ppd)));
  const auto fa = features(a, x, y, ppd), fb = features(b, x, y, ppd);
  const Real feature =
      std::sqrt(std::max(std::abs(fa[0] - fb[0]), std::abs(fa[1] - fb[1])) / std::numbers::sqrt2_v<Real>);
  return colour == 0 ? 0 : std::pow(colour, 1 - feature);
}

/// Every `step`-th texel of both axes, borders included.
void expect_slow_errors(const Pixels& a, const Pixels& b, double ppd, std::uint32_t step, double tolerance) {
  const std::vector<float> errors = error_map(a, b, {.pixels_per_degree = ppd});
  for (std::uint32_t y = 0; y < a.height; y += step)
    for (std::uint32_t x = 0; x < a.width; x += step)
      ASSERT_NEAR(errors[x + a.width * y],
                  static_cast<double>(slow_error(a, b, static_cast<int>(x), static_cast<int>(y), ppd)),
                  tolerance)
          << x << ", " << y;
}

Pixels formula(bool changed) {
  return drawn(48, 40, [&](auto x, auto y, auto c) {
    return (x * x + 3 * y * y + 5 * x * y + 50 * c + (changed ? (x / 8 + y / 8) % 2 * 16 : 0)) % 256;
  });
}

TEST(Flip, the_default_is_a_screen_of_3840_pixels_as_wide_as_it_is_far) {
  EXPECT_DOUBLE_EQ(pixels_per_degree(0.7, 3840, 0.7), default_pixels_per_degree);
  EXPECT_NEAR(default_pixels_per_degree, 67.02, 0.005);
  EXPECT_EQ(error_map(formula(false), formula(true)),
            error_map(formula(false), formula(true), {.pixels_per_degree = default_pixels_per_degree}));
}

TEST(Flip, equal_pictures_have_no_error) {
  for (const Pixels& p : {random_pixels(1, 1, 1), random_pixels(40, 300, 2), formula(true)})
    EXPECT_THAT(error_map(p, p), testing::Each(0.0f));
}

TEST(Flip, is_symmetric) {
  const Pixels a = random_pixels(150, 37, 3), b = random_pixels(150, 37, 4);
  EXPECT_EQ(error_map(a, b), error_map(b, a));
}

TEST(Flip, lies_within_0_and_1) {
  // Corners of the cube of colours, alone and in patterns that feature filters answer most.
  std::vector<Pixels> pictures{random_pixels(64, 48, 5)};
  for (unsigned corner = 0; corner < 8; ++corner) {
    const auto code = [corner](std::uint32_t c) { return (corner >> c & 1) != 0 ? 255u : 0u; };
    pictures.push_back(drawn(64, 48, [&](auto, auto, auto c) { return code(c); }));
    pictures.push_back(
        drawn(64, 48, [&](auto x, auto y, auto c) { return (x / 4 + y / 4) % 2 ? 255 - code(c) : code(c); }));
  }
  for (const Pixels& a : pictures)
    for (const Pixels& b : pictures)
      for (const float e : error_map(a, b)) ASSERT_TRUE(e >= 0 && e <= 1) << e;
}

TEST(Flip, of_constant_pictures_only_colour_counts) {
  // Filters that sum to 1 change nothing, and there is neither edge nor point.
  const std::vector<std::array<std::uint8_t, 3>> colours{
      {0, 0, 0},   {255, 255, 255}, {100, 100, 100}, {101, 100, 100}, {0, 255, 0}, {0, 0, 255},
      {255, 0, 0}, {12, 200, 77},   {13, 200, 77},   {1, 2, 3},       {90, 0, 255}};
  for (const auto& a : colours)
    for (const auto& b : colours) {
      const Pixels p = constant(30, 7, a), q = constant(30, 7, b);
      const Real expected = colour_error(lab_of(light_of(p, 0, 0)), lab_of(light_of(q, 0, 0)));
      for (const float e : error_map(p, q)) ASSERT_NEAR(e, static_cast<double>(expected), 2e-6);
    }
}

TEST(Flip, worked_by_hand) {
  // Black and white differ by L* alone, by 100: 100^0.7 = 25.1189. Green and blue are furthest apart: 1.
  const auto of = [](std::array<std::uint8_t, 3> a, std::array<std::uint8_t, 3> b) {
    return error_map(constant(1, 1, a), constant(1, 1, b))[0];
  };
  EXPECT_NEAR(of({0, 255, 0}, {0, 0, 255}), 1, 1e-6);
  // L*a*b* of green 87.735, -86.183, 83.180 and of blue 32.297, 79.188, -107.860, as tables of sRGB have them: Hunt makes of a
  // and b -75.61, 72.98 and 25.58, -34.84. 55.438 + |(101.19, 107.82)| = 203.30; 203.30^0.7 = 41.279.
  EXPECT_NEAR(of({0, 0, 0}, {255, 255, 255}), 0.95 + (25.1189 - 0.4 * 41.279) / (0.6 * 41.279) * 0.05, 1e-4);
}

TEST(Flip, is_what_its_formulas_say_texel_by_texel) {
  expect_slow_errors(formula(false), formula(true), default_pixels_per_degree, 6, 5e-6);
  expect_slow_errors(random_pixels(45, 33, 6), random_pixels(45, 33, 7), default_pixels_per_degree, 11, 5e-6);
  expect_slow_errors(random_pixels(30, 30, 8), random_pixels(30, 30, 9), 20, 7, 5e-6);
}

TEST(Flip, of_an_edge_that_moved_by_a_texel) {
  // The edges differ in one texel only; elsewhere both filters see the same side and f is 0. f is a square root, so a
  // rounding error of 1e-8 would show as 1e-4.
  const auto edge = [](std::uint32_t at) {
    return drawn(64, 3, [at](auto x, auto, auto) { return x < at ? 30 : 220; });
  };
  expect_slow_errors(edge(32), edge(33), default_pixels_per_degree, 1, 5e-5);
}

TEST(Flip, of_pictures_smaller_than_the_filters) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {2u, 1u}, {1u, 3u}, {5u, 4u}})
    expect_slow_errors(random_pixels(width, height, width), random_pixels(width, height, height + 50),
                       default_pixels_per_degree, 1, 5e-6);
}

TEST(Flip, equals_the_program_of_its_authors) {
  // Their single header (github.com/NVlabs/flip, src/cpp/FLIP.h, commit 1eb247c) compiled by g++ 12 -O3 gave these for the two
  // pictures formula(false), formula(true), at its default of pixels per degree. The mean is of its map, summed in binary64.
  const std::vector<float> errors = error_map(formula(false), formula(true));
  EXPECT_NEAR(mean(errors), 0.20226017, 1e-6);
  struct Texel {
    std::uint32_t x, y;
    double error;
  };
  for (const auto& [x, y, error] : std::vector<Texel>{{0, 0, 0.018874},
                                                      {47, 0, 0.514850},
                                                      {0, 39, 0.004586},
                                                      {47, 39, 0.301571},
                                                      {24, 20, 0.196585},
                                                      {7, 8, 0.152009},
                                                      {8, 8, 0.123670},
                                                      {33, 5, 0.042383},
                                                      {15, 31, 0.174021},
                                                      {40, 22, 0.225576}})
    EXPECT_NEAR(errors[x + 48 * y], error, 1e-4) << x << ", " << y;
}

TEST(Flip, is_the_same_for_any_number_of_threads) {
  // More than one task along both axes.
  const Pixels a = random_pixels(300, 280, 10), b = random_pixels(300, 280, 11);
  const std::vector<float> one = error_map(a, b, {.threads = 1});
  for (const unsigned threads : {2u, 3u, 7u}) EXPECT_EQ(error_map(a, b, {.threads = threads}), one);
}

TEST(Flip, does_not_depend_on_where_tasks_and_pieces_end) {
  // A picture of two pieces and two tasks: what is far from its borders is what a part of it alone gives there.
  const Pixels a = random_pixels(300, 280, 12), b = random_pixels(300, 280, 13);
  const std::uint32_t left = 90, top = 100;
  const auto part = [&](const Pixels& p) {
    return drawn(80, 60, [&](auto x, auto y, auto c) { return p.rgb[3 * (left + x + 300 * (top + y)) + c]; });
  };
  const std::vector<float> whole = error_map(a, b), piece = error_map(part(a), part(b));
  for (std::uint32_t y = 10; y < 50; ++y)
    for (std::uint32_t x = 10; x < 70; ++x)
      ASSERT_EQ(piece[x + 80 * y], whole[left + x + 300 * (top + y)]) << x << ", " << y;
}

TEST(Flip, the_mean_is_taken_in_binary64) {
  // 2^24 + 2 errors of 1: added one by one in binary32 they stop at 2^24.
  EXPECT_EQ(mean(std::vector<float>((1u << 24) + 2, 1.0f)), 1);
  EXPECT_EQ(mean(std::vector<float>{}), 0);
  EXPECT_EQ(mean(std::vector<float>{0.5f, 0.25f, 1}, std::vector<std::uint8_t>{1, 255, 0}), 0.375);
  EXPECT_EQ(mean(std::vector<float>{0.5f}, std::vector<std::uint8_t>{0}), 0);
  EXPECT_THROW(mean(std::vector<float>{0.5f}, std::vector<std::uint8_t>{}), std::invalid_argument);
}

TEST(Flip, says_what_it_does_not_compare) {
  const auto complaint = [](const Picture& a, const Picture& b, double ppd = 67) {
    return mmverify::tests::complaint_of<std::invalid_argument>(
        [&] { error_map(a, b, {.pixels_per_degree = ppd}); }, "");
  };
  const Pixels p = random_pixels(4, 3, 1), turned = random_pixels(3, 4, 1);
  EXPECT_EQ(complaint(p, turned), "flip: 4 x 3 texels against 3 x 4");
  EXPECT_EQ(complaint(p, {4, 3, std::span(p.rgb).first(35)}),
            "flip: the test: 35 bytes for 4 x 3 texels of 3");
  EXPECT_EQ(complaint({0, 3, {}}, p), "flip: the reference: 0 x 3 texels; 1 to 16384 a side are compared");
  EXPECT_EQ(complaint({16385, 1, {}}, p),
            "flip: the reference: 16385 x 1 texels; 1 to 16384 a side are compared");
  for (const double ppd : {0.0, -1.0, 1001.0, std::nan(""), HUGE_VAL})
    EXPECT_THAT(complaint(p, p, ppd), testing::EndsWith("pixels per degree; 1 to 1000 are taken"));
  for (const double ppd : {least_pixels_per_degree, most_pixels_per_degree})
    EXPECT_THAT(error_map(p, p, {.pixels_per_degree = ppd}), testing::Each(0.0f));
}

}  // namespace
