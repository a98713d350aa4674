// [memory] impl/index/index.hpp and impl/common/binary16.hpp against the exact specification and an oracle of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "impl/common/binary16.hpp"
#include "impl/index/index.hpp"
#include "impl/index/wide.hpp"
#include "spec/fixed.hpp"
#include "spec/index/index.hpp"
#include "spec/rational.hpp"
#include "tests/impl/every_target.hpp"
#include "tests/sanitized.hpp"

namespace impl_index_test {

namespace fast = mmverify::impl::index;
namespace spec = mmverify::spec;
using mmverify::impl::Binary16;
using mmverify::tests::on_every_target;
using spec::Fixed64;
using spec::Rational;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan_float = std::numeric_limits<float>::quiet_NaN();
constexpr float tiny = std::numeric_limits<float>::denorm_min();
constexpr float huge = std::numeric_limits<float>::max();

Rational exact(float x) {
  int exponent = 0;
  const auto significand = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 24));
  exponent -= 24;
  const spec::Integer scale = spec::Integer(1) << std::abs(exponent);
  return exponent < 0 ? Rational(significand, scale) : Rational(significand * scale);
}

Rational clamped(float x) {
  if (!(x > 0)) return Rational(0);
  return x < 1 ? exact(x) : Rational(1);
}

std::uint32_t spec_curve(float u, float v, std::uint32_t n) {
  return spec::index::reference(spec::Point<Rational>{exact(u), exact(v)}, n);
}

std::uint32_t spec_rows(float u, float v, std::uint32_t n) {
  return spec::index::w_minor(spec::Point<Rational>{clamped(u), clamped(v)}, n);
}

// Every bit pattern alike, but half of the time within [0, 1], where the questions are.
std::vector<float> random_floats(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<float> x(count);
  for (float& f : x) {
    const auto bits = static_cast<std::uint32_t>(random());
    f = (bits & 1) != 0 ? std::bit_cast<float>(static_cast<std::uint32_t>(random()))
                        : static_cast<float>(bits >> 8) * 0x1p-24f;
  }
  return x;
}

// Six columns of corners with a guard word on either side of each; the spans start off alignment by `skew`
// words.
class Columns {
 public:
  Columns(std::size_t count, std::size_t skew) : count_(count), skew_(skew) {
    for (auto& column : columns_) column.assign(count + skew + 1, guard);
  }
  fast::CornerSpans spans() { return {span(0), span(1), span(2), span(3), span(4), span(5)}; }
  fast::Corners at(std::size_t k) const {
    const auto get = [&](std::size_t c) { return columns_[c][skew_ + k]; };
    return {fast::Vertex{get(0), get(1)}, fast::Vertex{get(2), get(3)}, fast::Vertex{get(4), get(5)}};
  }
  bool guards_intact() const {
    return std::all_of(columns_.begin(), columns_.end(), [&](const auto& column) {
      return column.back() == guard &&
             std::all_of(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(skew_),
                         [](std::uint32_t x) { return x == guard; });
    });
  }

 private:
  static constexpr std::uint32_t guard = 0xdeadbeef;
  std::span<std::uint32_t> span(std::size_t c) { return std::span(columns_[c]).subspan(skew_, count_); }

  std::size_t count_, skew_;
  std::array<std::vector<std::uint32_t>, 6> columns_;
};

// ---- Points

struct Points {
  std::vector<float> u, v;
};

// Neighbours, a few steps of the last place away, of crossings of grid lines on and beside the long edge, of
// square centres, and of the pairs where a sum of fractions in floats rounds up to 1.
Points stiff_points(std::uint32_t n) {
  const auto N = static_cast<float>(1u << n);
  Points points;
  const auto add_neighbours = [&points](float u0, float v0) {
    for (int du = -2; du <= 2; ++du) {
      for (int dv = -2; dv <= 2; ++dv) {
        float u = u0, v = v0;
        for (int s = 0; s < std::abs(du); ++s) u = std::nextafter(u, du < 0 ? -infinity : infinity);
        for (int s = 0; s < std::abs(dv); ++s) v = std::nextafter(v, dv < 0 ? -infinity : infinity);
        points.u.push_back(u);
        points.v.push_back(v);
      }
    }
  };
  for (std::uint32_t k = 0; k < 30; ++k) {
    const auto i = static_cast<float>(static_cast<std::uint32_t>(k * 0x9e3779b9u) % (1u << n));
    for (const float j : {N - 1 - i, N - i, (N - i) / 2, 0.0f}) add_neighbours(i / N, j / N);
    add_neighbours((i + 0.5f) / N, (N - 0.5f - i) / N);
  }
  for (const float below_one : {1 - 0x1p-24f, 1 - 0x1p-23f})
    for (const float little : {0x1p-24f, 0x1p-25f, 0x1.8p-25f, 0x1p-26f, 0x1p-100f}) {
      add_neighbours(below_one / N, little / N);
      add_neighbours(little / N, below_one / N);
    }
  return points;
}

TEST(ImplIndex, AnswersEveryBitPattern) {
  const std::array odd{0.0f,
                       -0.0f,
                       tiny,
                       -tiny,
                       0x1p-126f,
                       -0x1p-126f,
                       0.25f,
                       -0.25f,
                       1.0f,
                       -1.0f,
                       2.0f,
                       0x1p31f,
                       huge,
                       -huge,
                       infinity,
                       -infinity,
                       nan_float,
                       -nan_float,
                       std::bit_cast<float>(0x7f800001u),
                       1.0f - 0x1p-24f,
                       1.0f + 0x1p-23f};
  const auto finite_twin = [](float x) { return std::isnan(x) ? 0.0f : std::clamp(x, -2.0f, 2.0f); };
  for (const float u : odd) {
    for (const float v : odd) {
      for (std::uint32_t n = 0; n <= 16; ++n) {
        const float a = finite_twin(u), b = finite_twin(v);
        ASSERT_EQ(fast::from_barycentrics(u, v, n), spec_curve(a, b, n)) << u << ' ' << v << ' ' << n;
        ASSERT_EQ(fast::w_minor(u, v, n), spec_rows(a, b, n)) << u << ' ' << v << ' ' << n;
        ASSERT_LT(fast::from_barycentrics(u, v, n), std::uint64_t{1} << (2 * n));
        ASSERT_LT(fast::w_minor(u, v, n), std::uint64_t{1} << (2 * n));
      }
    }
  }
}

#if defined(__SSE2__)
// Engines run with subnormals flushed to zero; the promise is that nothing changes.
TEST(ImplIndex, AnswersAlikeWithSubnormalsFlushed) {
  for (const std::uint32_t n : {0u, 1u, 8u, 16u}) {
    Points p = stiff_points(n);
    for (const float small : {tiny, -tiny, 0x1p-127f, 0x1p-130f})
      for (const float other : {0.0f, 0.5f, 1.0f, 1 - 0x1p-24f, tiny})
        for (const bool swapped : {false, true}) {
          p.u.push_back(swapped ? other : small);
          p.v.push_back(swapped ? small : other);
        }
    std::vector<std::uint32_t> curve, rows, scalar_curve, scalar_rows;
    for (std::size_t k = 0; k < p.u.size(); ++k) {
      curve.push_back(fast::from_barycentrics(p.u[k], p.v[k], n));
      rows.push_back(fast::w_minor(p.u[k], p.v[k], n));
    }
    on_every_target([&] {
      std::vector<std::uint32_t> batch_curve(p.u.size()), batch_rows(p.u.size());
      scalar_curve.clear();
      scalar_rows.clear();
      const unsigned before = _mm_getcsr();
      _mm_setcsr(before | 0x8040);  // flush to zero, subnormals are zeros
      fast::from_barycentrics(p.u, p.v, n, batch_curve);
      fast::w_minor(p.u, p.v, n, batch_rows);
      for (std::size_t k = 0; k < p.u.size(); ++k) {
        scalar_curve.push_back(fast::from_barycentrics(p.u[k], p.v[k], n));
        scalar_rows.push_back(fast::w_minor(p.u[k], p.v[k], n));
      }
      _mm_setcsr(before);
      EXPECT_EQ(batch_curve, curve) << "level " << n;
      EXPECT_EQ(batch_rows, rows) << "level " << n;
      EXPECT_EQ(scalar_curve, curve) << "level " << n;
      EXPECT_EQ(scalar_rows, rows) << "level " << n;
    });
  }
}
#endif

// Level 1: the children at the corners w, u and v are 0, 2 and 3, the one between them 1.  A compiler evaluates the index.
static_assert(fast::from_barycentrics(0.125f, 0.125f, 1) == 0 &&
              fast::from_barycentrics(0.25f, 0.375f, 1) == 1 &&
              fast::from_barycentrics(0.75f, 0.125f, 1) == 2 &&
              fast::from_barycentrics(0.125f, 0.75f, 1) == 3);
static_assert(fast::from_barycentrics(0.5f, 0, 1) == 2, "a tie goes to the greater u");
static_assert(fast::from_barycentrics(std::numeric_limits<float>::quiet_NaN(), 0, 1) == 0 &&
              fast::from_barycentrics(std::numeric_limits<float>::infinity(), -1, 1) == 2);
static_assert(fast::from_barycentrics_wide(0.75f, 0.125f, 1) == 2 && fast::w_minor(0.125f, 0.125f, 1) == 0);

TEST(ImplIndex, TakesLevelsBeyondTheLastForTheLast) {
  const std::array<float, 1> u{0.3f}, v{0.6f};
  std::array<std::uint32_t, 1> out{};
  const std::array<std::uint32_t, 1> index{0x12345678};
  for (const std::uint32_t n : {17u, 31u, 32u, 64u, 0xffffffffu}) {
    EXPECT_EQ(fast::from_barycentrics(u[0], v[0], n), fast::from_barycentrics(u[0], v[0], 16));
    EXPECT_EQ(fast::w_minor(u[0], v[0], n), fast::w_minor(u[0], v[0], 16));
    EXPECT_EQ(fast::corners(index[0], n), fast::corners(index[0], 16));
    fast::from_barycentrics(u, v, n, out);
    EXPECT_EQ(out[0], fast::from_barycentrics(u[0], v[0], 16));
    fast::w_minor(u, v, n, out);
    EXPECT_EQ(out[0], fast::w_minor(u[0], v[0], 16));
    Columns columns(1, 0);
    fast::corners(index, n, columns.spans());
    EXPECT_EQ(columns.at(0), fast::corners(index[0], 16));
  }
}

TEST(ImplIndex, BatchesEqualTheScalarAtEveryLength) {
  on_every_target([] {
    constexpr std::uint32_t guard = 0xdeadbeef;
    for (std::size_t count = 0; count <= 67; ++count) {
      for (std::size_t skew = 0; skew < 4; ++skew) {
        const std::uint32_t n = static_cast<std::uint32_t>(count + 5 * skew) % 17;
        // Vectors of the exact size, so that a sanitizer sees a read beyond either end.
        const auto u = random_floats(count + skew, static_cast<std::uint32_t>(3 + count));
        const auto v = random_floats(count + skew, static_cast<std::uint32_t>(1000 + count));
        const auto us = std::span(u).subspan(skew), vs = std::span(v).subspan(skew);
        std::vector<std::uint32_t> curve(count + skew + 1, guard), rows = curve;
        fast::from_barycentrics(us, vs, n, std::span(curve).subspan(skew, count));
        fast::w_minor(us, vs, n, std::span(rows).subspan(skew, count));
        for (std::size_t k = 0; k < count; ++k) {
          ASSERT_EQ(curve[skew + k], fast::from_barycentrics(us[k], vs[k], n))
              << us[k] << ' ' << vs[k] << ' ' << n;
          ASSERT_EQ(rows[skew + k], fast::w_minor(us[k], vs[k], n)) << us[k] << ' ' << vs[k] << ' ' << n;
        }
        for (std::size_t k = 0; k < skew; ++k) ASSERT_TRUE(curve[k] == guard && rows[k] == guard);
        ASSERT_TRUE(curve.back() == guard && rows.back() == guard) << "wrote beyond the end";
      }
    }
  });
}

TEST(ImplIndex, RefusesSpansOfDifferentLengths) {
  std::vector<float> three(3), four(4);
  std::vector<std::uint32_t> out(4, 7), index(4);
  EXPECT_THROW(fast::from_barycentrics(three, four, 2, out), std::invalid_argument);
  EXPECT_THROW(fast::from_barycentrics(four, three, 2, out), std::invalid_argument);
  EXPECT_THROW(fast::from_barycentrics(three, three, 2, out), std::invalid_argument);
  EXPECT_THROW(fast::w_minor(three, four, 2, out), std::invalid_argument);
  EXPECT_EQ(out, std::vector<std::uint32_t>(4, 7));
  Columns columns(3, 0);
  EXPECT_THROW(fast::corners(index, 2, columns.spans()), std::invalid_argument);
  EXPECT_THROW(fast::w_minor_corners(index, columns.spans()), std::invalid_argument);
}

// ---- Triangles

TEST(ImplIndex, CornerBatchesEqualTheScalar) {
  on_every_target([] {
    std::mt19937 random(5);
    for (std::size_t count = 0; count <= 67; ++count) {
      for (std::size_t skew = 0; skew < 4; ++skew) {
        std::vector<std::uint32_t> index(count + skew);
        for (auto& x : index) x = static_cast<std::uint32_t>(random());
        const auto in = std::span<const std::uint32_t>(index).subspan(skew);
        const std::uint32_t n = static_cast<std::uint32_t>(count + skew) % 17;
        Columns curve(count, skew), rows(count, skew);
        fast::corners(in, n, curve.spans());
        fast::w_minor_corners(in, rows.spans());
        for (std::size_t k = 0; k < count; ++k) {
          ASSERT_EQ(curve.at(k), fast::corners(in[k], n)) << in[k] << " level " << n;
          ASSERT_EQ(rows.at(k), fast::w_minor_corners(in[k])) << in[k];
        }
        ASSERT_TRUE(curve.guards_intact() && rows.guards_intact());
      }
    }
  });
}

}  // namespace impl_index_test
