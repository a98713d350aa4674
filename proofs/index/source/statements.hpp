// What is to be proved of a function of two floats that somebody wrote: one statement for each level and each pair of
// ranges of exponents, about a formula of that function.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "proofs/engine/result.hpp"
#include "proofs/induction/statement.hpp"

namespace mmverify::proofs::index::source {

/// Binary32 numbers of one sign whose exponent field is from first to last.
struct Range {
  bool negative = false;
  unsigned first = 0, last = 0;
  friend bool operator==(const Range&, const Range&) = default;
};

/// Something that must not happen, and whether it does, as the name of a condition.
struct Cause {
  std::string condition, what;
};

/// What a function gives on the numbers with the bits `u` and `v`, of two ranges.
struct Formula {
  std::string declarations;  ///< commands of SMT-LIB 2
  std::vector<std::pair<std::string, std::string>>
      definitions;        ///< names and formulas, each of names before it
  std::string index;      ///< a word of 32 bits
  std::string undefined;  ///< a condition: there is no index, as the code leaves it undefined
  std::vector<Cause> causes;
};
using Formulas = std::function<Formula(Level, const Range& u, const Range& v)>;

/// A statement's two ranges.
struct Pair {
  Range u, v;
};

/// Two numbers, by their bits.
struct Bits {
  std::uint32_t u, v;
};

/// All pairs of ranges of a level that hold two numbers of the domain, those that index functions tend to be wrong on
/// first, and before them those with one of these exponent fields.  The domain: u and v in [-0, 1], u + v <= 1 + 2^-23.  Together the ranges hold each of its numbers once: -0;
/// all below 2^-(n+26), subnormal ones included; each other exponent by itself.
std::vector<Pair> pairs_of(Level n, const std::vector<unsigned>& fields = {});

/// That many: (n+29)^2 - 45.  Domain: n <= 16.
std::uint64_t count_of_pairs(Level n);

/// For every u and v of the pair's ranges and the domain: the index is that of the exact reference, and defined.
/// spec::index::within_unit, quantise_scaled and curve, run on names.  `at`: for these two numbers alone.
induction::Statement statement_of(Level n, const Pair& pair, const Formula& formula,
                                  const std::optional<Bits>& at = std::nullopt);

/// Constants of a statement that a counterexample gives values: the function's index, a word of 32 bits; whether it is
/// undefined, and each cause of that, words of one bit.
inline constexpr const char* claimed_index = "code_index";
inline constexpr const char* claimed_undefined = "code_undefined";
std::string claimed_cause(std::size_t k);

/// There are such u and v.
induction::Statement witness_of(Level n, const Pair& pair);

}  // namespace mmverify::proofs::index::source
