// Statements about a function of two floats given as source: one for each level and each pair of ranges of exponents,
// about a formula of that function.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "proofs/engine/result.hpp"
#include "proofs/induction/statement.hpp"

namespace mmverify::proofs::index::source {

/// Binary32 numbers of one sign whose exponent field is from first to last.
struct Range {
  bool negative = false;
  unsigned first = 0, last = 0;
  friend bool operator==(const Range&, const Range&) = default;
};

/// A cause of undefined behaviour: the name of its condition, and words for it.
struct Cause {
  std::string condition, what;
};

/// The result of a function on the numbers with the bits `u` and `v`, of two ranges.
struct Formula {
  std::string declarations;  ///< commands of SMT-LIB 2
  std::vector<std::pair<std::string, std::string>>
      definitions;        ///< names and formulas; each formula uses earlier names
  std::string index;      ///< a word of 32 bits
  std::string undefined;  ///< the condition that the code leaves the index undefined
  std::vector<Cause> causes;
};
using Formulas = std::function<Formula(Level, const Range& u, const Range& v)>;

/// The two ranges of a statement.
struct Pair {
  Range u, v;
};

/// Two numbers as bits.
struct Bits {
  std::uint32_t u, v;
};

/// All pairs of ranges of a level that hold two numbers of the domain: u and v in [-0, 1], u + v <= 1 + 2^-23.  Pairs
/// with one of the exponent fields `fields` come first, then those on which index functions tend to be wrong.  The
/// ranges contain each number of the domain once: -0; all below 2^-(n+26), subnormal ones included; each other
/// exponent by itself.
std::vector<Pair> pairs_of(Level n, const std::vector<unsigned>& fields = {});

/// The number of these pairs: (n+29)^2 - 45.  Domain: n <= 16.
std::uint64_t count_of_pairs(Level n);

/// The rule that an index follows: exact arithmetic, or the published code run in binary32.
enum class Dialect { exact, published };

/// The statement that for every u and v of the pair's ranges and the domain the index is defined, and the dialect's:
///   exact      spec::index::within_unit, quantise_scaled and curve, run on names
///   published  the same with the upper half from uf + vf >= 1 - 2^-25 on: by index.published_differs_where the
///              published code, which adds uf and vf in binary32, has this index for every pair
/// `at`: for these two numbers only.
induction::Statement statement_of(Level n, const Pair& pair, const Formula& formula, Dialect dialect,
                                  const std::optional<Bits>& at = std::nullopt);

/// Constants of a statement that a counterexample gives values: the function's index, a word of 32 bits; whether it
/// is undefined, and each cause of that, words of one bit.
inline constexpr const char* claimed_index = "code_index";
inline constexpr const char* claimed_undefined = "code_undefined";
std::string claimed_cause(std::size_t k);

/// The statement that such u and v exist.
induction::Statement witness_of(Level n, const Pair& pair);

}  // namespace mmverify::proofs::index::source
