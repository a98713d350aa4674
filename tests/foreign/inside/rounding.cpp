// Topic index: rounded arithmetic by another hand, and what is wrong with it.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/foreign/inside/index.hpp"

namespace mmverify::tests::foreign {
namespace {

using namespace proofs::index;
using proofs::Levels;

/// Rounded arithmetic: each operation in `Carrier`, then rounded to the format.
template <class Carrier>
class Rounded : public Hand {
 public:
  Rounded(Arithmetic arithmetic, bool formula, Fault fault)
      : Hand(fault, arithmetic, arithmetic == Arithmetic::binary16 ? 15 : 16), formula_(formula) {}

  void index(Level n, Batch batch, std::span<std::uint32_t> out) const {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = at(n, carried(batch.points[t].u.raw(), 30), carried(batch.points[t].v.raw(), 30));
  }
  void index(Level n, FloatBatch batch, std::span<std::uint32_t> out) const {
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = at(n, batch.u[t], batch.v[t]);
  }
  std::uint32_t index(Level n, const RationalPoint& p) const { return at(n, carried(p.u), carried(p.v)); }

 private:
  static Carrier carried(std::int64_t raw, int bits) { return std::ldexp(static_cast<Carrier>(raw), -bits); }
  static Carrier carried(const spec::Rational& q) {
    return static_cast<Carrier>(q.numerator()) / static_cast<Carrier>(q.denominator());
  }

  /// To the nearest number of the format, ties to even.
  Carrier rounded(Level n, Carrier x) const {
    if (fault == "computes_wider"_fault || (fault == "wider_from_level_7"_fault && n >= 7)) return x;
    switch (arithmetic) {
      case Arithmetic::binary16: {
        int exponent = 0;
        std::frexp(x, &exponent);
        const int unit = std::max(exponent - 11, -24);
        return std::ldexp(std::nearbyint(std::ldexp(x, -unit)), unit);
      }
      case Arithmetic::binary32: return static_cast<Carrier>(static_cast<float>(x));
      default: return static_cast<Carrier>(static_cast<double>(x));
    }
  }

  std::uint32_t at(Level n, Carrier u, Carrier v) const {
    return formula_ ? formula(n, u, v) : steps(n, u, v);
  }

  std::uint32_t formula(Level n, Carrier u, Carrier v) const {
    const auto r = [this, n](Carrier x) { return rounded(n, x); };
    const auto N = static_cast<Carrier>(std::uint32_t{1} << n);
    const Carrier un = r(u * N), vn = r(v * N);
    const Carrier fu = r(un - std::floor(un)), fv = r(vn - std::floor(vn));
    const bool upper = fault == "compares_the_difference"_fault ? std::min(fu, fv) >= r(1 - std::max(fu, fv))
                                                                : r(fu + fv) >= 1;
    // The middle of the half square, whose index takes no rounding.
    const std::int64_t part = upper ? 2 : 1, one = std::int64_t{3} << n;
    return static_cast<std::uint32_t>(
        vulkan(Bary<std::int64_t>{3 * static_cast<std::int64_t>(std::floor(un)) + part,
                                  3 * static_cast<std::int64_t>(std::floor(vn)) + part, one},
               n, Fault::none));
  }

  std::uint32_t steps(Level n, Carrier u, Carrier v) const {
    const auto r = [this, n](Carrier x) { return rounded(n, x); };
    Carrier w = r(r(1 - u) - v);
    bool mid = false, top = false;
    std::uint32_t index = 0;
    for (Level depth = 0; depth < n; ++depth) {
      const Carrier a = u, b = v, c = w;
      if (c > Carrier(0.5)) {
        index = 4 * index + (top ? 2 : 0);
        u = r(2 * a), v = r(2 * b), w = r(r(c - a) - b);
      } else if (b > Carrier(0.5) || (b == Carrier(0.5) && !mid)) {
        index = 4 * index + 3;
        u = r(2 * a), v = r(r(b - a) - c), w = r(2 * c);
        top = !top;
      } else if (a >= Carrier(0.5) && !(b == Carrier(0.5) && mid)) {
        index = 4 * index + (top ? 0 : 2);
        u = r(r(a - b) - c), v = r(2 * b), w = r(2 * c);
      } else {
        index = 4 * index + 1;
        u = r(r(a + b) - c), v = r(r(c + a) - b), w = r(r(b + c) - a);
        mid = !mid;
      }
    }
    return index;
  }

  const bool formula_;
};

/// binary16 pairs, as binary32 numbers: Vulkan's formula with what may go wrong in it.
class HalfPairs : public Hand {
 public:
  explicit HalfPairs(Fault fault) : Hand(fault, Arithmetic::binary32, 16) {}
  void index(Level n, Batch batch, std::span<std::uint32_t> out) const {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = at(n, static_cast<float>(batch.points[t].u.raw()) * 0x1p-30f,
                  static_cast<float>(batch.points[t].v.raw()) * 0x1p-30f);
  }
  void index(Level n, FloatBatch batch, std::span<std::uint32_t> out) const {
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = at(n, batch.u[t], batch.v[t]);
  }
  std::uint32_t index(Level n, const RationalPoint& p) const {
    return at(
        n, static_cast<float>(static_cast<double>(p.u.numerator()) / static_cast<double>(p.u.denominator())),
        static_cast<float>(static_cast<double>(p.v.numerator()) / static_cast<double>(p.v.denominator())));
  }

 private:
  std::uint32_t at(Level n, float u, float v) const {
    if (fault == "subnormals_are_zero"_fault) {
      u = u < 0x1p-14f ? 0 : u;
      v = v < 0x1p-14f ? 0 : v;
    }
    const auto one = std::int64_t{1} << 24;
    const auto N = std::int64_t{1} << n;
    const std::int64_t su = static_cast<std::int64_t>(u * 0x1p24f) * N,
                       sv = static_cast<std::int64_t>(v * 0x1p24f) * N;
    const std::int64_t fu = su % one, fv = sv % one;
    bool upper = fu + fv >= one;
    // Above 1/2 binary16 has steps of 2^-11: a sum within half a step of 1 becomes 1.
    if (fault == "sum_in_binary16"_fault) upper = fu + fv >= one - (one >> 12);
    const std::int64_t part = upper ? 2 : 1;
    return static_cast<std::uint32_t>(
        vulkan(Bary<std::int64_t>{3 * (su / one) + part, 3 * (sv / one) + part, 3 * N}, n,
               fault == "v_corner_is_first"_fault ? fault : Fault::none));
  }
};

}  // namespace

InsideRows right_rounding() {
  std::vector<InsideFault> all;
  const auto add = [&all](InsideFault f) { all.push_back(std::move(f)); };
  const Fault none = Fault::none;
  for (const bool formula : {false, true}) {
    add(fault<Rounded<double>>("index.rounded_arithmetic_errs", formula ? "formula_16" : "steps_16", "",
                               {1, 10}, Arithmetic::binary16, formula, none));
    add(fault<Rounded<double>>("index.rounded_arithmetic_errs", formula ? "formula_32" : "steps_32", "",
                               {1, 10}, Arithmetic::binary32, formula, none));
    add(fault<Rounded<double>>("index.rounded_arithmetic_errs", formula ? "formula_64" : "steps_64", "",
                               {1, 10}, Arithmetic::binary64, formula, none));
  }
  add(fault<HalfPairs>("index.exact_on_binary16", "formula", "", {10, 10}, none));
  return all;
}

InsideRows faults_of_rounding() {
  std::vector<InsideFault> all;
  const auto add = [&all](InsideFault f) { all.push_back(std::move(f)); };

  const char* law = "index.rounded_arithmetic_errs";
  const auto rounded = [&](const char* name, const char* wrong, Arithmetic a, bool by_formula, Fault f) {
    add(fault<Rounded<long double>>(law, name, wrong, {1, 10}, a, by_formula, f));
  };
  rounded("formula_32_computes_wider", "it rounds nothing", Arithmetic::binary32, true,
          "computes_wider"_fault);
  rounded("steps_64_computes_wider", "it rounds nothing", Arithmetic::binary64, false,
          "computes_wider"_fault);
  rounded("compares_the_difference", "it asks min >= 1 - max, which is exact", Arithmetic::binary32, true,
          "compares_the_difference"_fault);
  rounded("wider_from_level_7", "from level 7 on it rounds nothing", Arithmetic::binary16, true,
          "wider_from_level_7"_fault);

  law = "index.exact_on_binary16";
  const auto pairs = [&](const char* name, const char* wrong) {
    add(fault<HalfPairs>(law, name, wrong, {10, 10}, named(name)));
  };
  pairs("sum_in_binary16", "the sum of the fractions is rounded to binary16");
  pairs("subnormals_are_zero", "subnormal binary16 numbers count as zero");
  pairs("v_corner_is_first", "the v-corner's triangle has index 0");
  return all;
}

}  // namespace mmverify::tests::foreign
