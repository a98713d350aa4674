// Easy and stiff points for an index function, in the number type that it receives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string_view>

#include "bench/number_type.hpp"

namespace mmverify::bench {

enum class Inputs : std::uint8_t {
  uniform,  ///< spread evenly over the triangle, then rounded
  stiff,    ///< a few ulp from where the answer changes
};

/// The recipe of a stiff point; sample number k is of kind k mod 4.
enum class StiffRecipe : std::uint8_t {
  lines,       ///< u and v each up to 3 ulp from a grid line
  diagonal,    ///< u+v up to 3 ulp of v from a diagonal line, u anywhere or near a line
  straddling,  ///< uf+vf a hair on either side of 1, uf or vf just below 1 and the other tiny
  hypotenuse,  ///< u+v up to 3 ulp of v below 1
};
inline constexpr std::size_t stiff_recipes = 4;
std::string_view to_string(StiffRecipe kind);

/// A point, exact in doubles, and representable in the wanted number type.
struct InputPoint {
  double u, v;
};

/// An endless stream of points of the closed triangle (u, v >= 0 and u+v <= 1 hold exactly), the same for the
/// same arguments on every machine.
///   Lines are those of the wanted level, half of the time, or of a coarser one, so that points often meet the
///   few lines that all levels share.  Beside the line 0, where ulps become ever smaller, a few ulp of 1, and
///   down to 2^-20 of them, stand in.
class IndexInputs {
 public:
  /// Domain: level 0..16.
  IndexInputs(const NumberType& numbers, Inputs inputs, std::uint32_t level, std::uint64_t seed);

  /// The next sample; its kind, if the points are stiff.
  InputPoint next(StiffRecipe& kind);

 private:
  std::uint64_t below(std::uint64_t count);
  int between(int least, int most);
  double unit();
  std::uint32_t some_level();
  double line(std::uint32_t level, double limit);
  double beside(double x, int most);
  InputPoint uniform();
  InputPoint candidate(StiffRecipe kind);

  NumberType numbers_;
  Inputs inputs_;
  std::uint32_t level_;
  std::uint64_t count_ = 0;
  std::mt19937_64 random_;
};

}  // namespace mmverify::bench
