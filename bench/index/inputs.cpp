#include "bench/index/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mmverify::bench {
namespace {

/// Whether a point is in the triangle, exactly: if the greater is at least 1/2, 1 - greater is a double; else
/// the sum is below 1.
bool in_triangle(const InputPoint& p) {
  const auto [lesser, greater] = std::minmax(p.u, p.v);
  return lesser >= 0 && (greater < 0.5 || lesser <= 1 - greater);
}

std::mt19937_64 engine(const NumberType& numbers, Inputs inputs, std::uint32_t level, std::uint64_t seed) {
  // seed_seq and the engine are the standard's to the bit; a distribution's numbers would be the library's.
  std::seed_seq words{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                      static_cast<std::uint32_t>(numbers.precision), static_cast<std::uint32_t>(inputs),
                      level};
  return std::mt19937_64(words);
}

}  // namespace

std::string_view to_string(StiffRecipe kind) {
  switch (kind) {
    case StiffRecipe::lines: return "lines";
    case StiffRecipe::diagonal: return "diagonal";
    case StiffRecipe::straddling: return "straddling";
    case StiffRecipe::hypotenuse: break;
  }
  return "hypotenuse";
}

IndexInputs::IndexInputs(const NumberType& numbers, Inputs inputs, std::uint32_t level, std::uint64_t seed)
    : numbers_(numbers), inputs_(inputs), level_(level), random_(engine(numbers, inputs, level, seed)) {}

InputPoint IndexInputs::next(StiffRecipe& kind) {
  kind = static_cast<StiffRecipe>(count_++ % stiff_recipes);
  while (true) {
    const InputPoint p = inputs_ == Inputs::uniform ? uniform() : candidate(kind);
    if (in_triangle(p)) return p;
  }
}

// The remainder favours small numbers by less than count / 2^64.
std::uint64_t IndexInputs::below(std::uint64_t count) { return random_() % count; }

int IndexInputs::between(int least, int most) {
  return least + static_cast<int>(below(static_cast<std::uint64_t>(most - least) + 1));
}

double IndexInputs::unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

std::uint32_t IndexInputs::some_level() {
  return below(2) == 0 ? level_ : static_cast<std::uint32_t>(below(level_ + 1));
}

/// A random k / 2^level with 0 <= k / 2^level <= limit.
double IndexInputs::line(std::uint32_t level, double limit) {
  const double N = std::ldexp(1.0, static_cast<int>(level));
  return static_cast<double>(below(static_cast<std::uint64_t>(limit * N) + 1)) / N;
}

/// A number up to `most` ulp from x.
double IndexInputs::beside(double x, int most) {
  const int steps = between(-most, most);
  x = numbers_.rounded(x);
  if (x > 0 || steps <= 0) return numbers_.neighbour(x, steps);
  return numbers_.rounded(std::ldexp(numbers_.ulp(1) * steps, -between(0, 20)));
}

InputPoint IndexInputs::uniform() {
  constexpr std::uint64_t one = std::uint64_t{1} << 53;
  std::uint64_t u = random_() >> 11, v = random_() >> 11;
  if (u + v > one) u = one - u, v = one - v;
  return {numbers_.rounded(static_cast<double>(u) * 0x1p-53),
          numbers_.rounded(static_cast<double>(v) * 0x1p-53)};
}

InputPoint IndexInputs::candidate(StiffRecipe kind) {
  const double N = std::ldexp(1.0, static_cast<int>(level_));
  InputPoint p{0, 0};
  switch (kind) {
    case StiffRecipe::lines: {
      const double u = line(some_level(), 1);
      p = {beside(u, 3), beside(line(some_level(), 1 - u), 3)};
      break;
    }
    case StiffRecipe::diagonal: {
      const double sum = line(some_level(), 1);
      const double u = below(2) == 0 ? numbers_.rounded(sum * unit()) : beside(line(some_level(), sum), 3);
      p = {u, u < sum ? beside(sum - u, 3) : 0};
      break;
    }
    case StiffRecipe::straddling: {
      // The powers of 2 are equally likely, down to the line beside 0: farther out, fractions have lost bits
      // and need no rounding.
      const double above = static_cast<double>(below(std::uint64_t{1} << below(level_ + 1)) + 1) / N;
      const double u = numbers_.neighbour(numbers_.rounded(above), -between(1, 4));
      // Eighths of what u lacks, from one to sixteen: the sum of the fractions falls on either side of 1.
      const double rest = (above - u) * static_cast<double>(between(1, 16)) / 8;
      p = {u, numbers_.rounded((below(2) == 0 ? 0 : line(level_, 1 - above)) + std::max(rest, 0.0))};
      break;
    }
    case StiffRecipe::hypotenuse: {
      const double u = numbers_.rounded(unit());
      p = {u, beside(1 - u, 3)};
      break;
    }
  }
  if (below(2) == 0) std::swap(p.u, p.v);
  return p;
}

}  // namespace mmverify::bench
