// Encodes a program as SMT-LIB 2 formulas over words, for inputs in given ranges of exponents.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "subjects/source/encode/number.hpp"

namespace mmverify::source {

/// Binary32 numbers of one sign whose exponent field is in first..last, below 255.
struct Exponents {
  bool negative = false;
  unsigned first = 0, last = 0;
  friend bool operator==(const Exponents&, const Exponents&) = default;
};

/// An event that must not happen, and the name of the condition that it does.
struct Cause {
  std::string condition, what;
};

struct Formula {
  std::string declarations;  ///< SMT-LIB commands
  std::vector<std::pair<std::string, std::string>>
      definitions;        ///< names and formulas, each over earlier names
  std::string index;      ///< a 32-bit word
  std::string undefined;  ///< a condition: the index is undefined, or a forbidden event happens
  std::vector<Cause> causes;
};

/// Encodes the program's result for binary32 inputs with the bits `u_bits` and `v_bits`. Domain: their signs
/// and exponents are those of `u` and `v`. Defined names begin with "code_".
/// Throws NotEncoded.
Formula encode(const Program& program, const Exponents& u, const Exponents& v, const std::string& u_bits,
               const std::string& v_bits, Mistake mistake = Mistake::none);

/// An operation that has no formula; what() begins with file and line if they are known.
struct NotEncoded : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace mmverify::source
