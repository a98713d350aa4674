// The statements of a certificate as questions for a second SAT solver, which gets none of the first one's steps.
#pragma once

#include <cstddef>
#include <istream>
#include <ostream>
#include <vector>

namespace mmverify::proofs::certificate {

/// The circuit, the assumptions and the statements of a certificate: merges, exclusions and claims, in their order.
class Statements {
 public:
  /// Reads the lines i, f, n, a, m and o of checker.hpp, and passes over the solver's own steps.
  /// Errors: NotValid.
  explicit Statements(std::istream& certificate);

  std::size_t size() const { return statements_.size(); }

  /// Writes DIMACS that no values satisfy if statement k follows from the circuit, the assumptions and the statements
  /// before it.  Domain: k < size().
  /// Test: statements_test.
  void write_one(std::ostream& out, std::size_t k) const;
  /// Writes DIMACS that no values satisfy if all statements are true of the circuit under its assumptions.
  /// Test: statements_test.
  void write_all(std::ostream& out) const;

 private:
  struct Line {
    char kind;
    std::vector<int> numbers;
  };
  std::vector<Line> lines_;
  std::vector<std::size_t> statements_;  ///< places in lines_
  int variables_ = 0;
};

}  // namespace mmverify::proofs::certificate
