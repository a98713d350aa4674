// A program as formulas of SMT-LIB 2 over words, for inputs whose exponents are known.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "source/encode/number.hpp"

namespace mmverify::source {

/// Binary32 numbers of one sign whose exponent field is from first to last, below 255.
struct Exponents {
  bool negative = false;
  unsigned first = 0, last = 0;
  friend bool operator==(const Exponents&, const Exponents&) = default;
};

/// Something that must not happen, and whether it does, as the name of a condition.
struct Cause {
  std::string condition, what;
};

struct Formula {
  std::string declarations;  ///< commands
  std::vector<std::pair<std::string, std::string>>
      definitions;        ///< names and formulas, each of names before it
  std::string index;      ///< a word of 32 bits
  std::string undefined;  ///< a condition: the index is undefined, or what must not be comes to be
  std::vector<Cause> causes;
};

/// What the program computes on the binary32 numbers with the bits `u` and `v`.  Domain: their exponents are these.
/// Names that are defined begin with "code_".
/// Throws NotEncoded.
Formula encode(const Program& program, const Exponents& u, const Exponents& v, const std::string& u_bits,
               const std::string& v_bits, Mistake mistake = Mistake::none);

/// An operation that has no formula here; what() begins with file and line where they are known.
struct NotEncoded : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace mmverify::source
