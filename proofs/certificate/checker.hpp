// Checks certificates of proofs by a SAT solver: each step must follow from the steps before by unit propagation alone.
#pragma once

#include <cstdint>
#include <functional>
#include <istream>
#include <stdexcept>

namespace mmverify::proofs::certificate {

/// The contents of a certificate that follows.
struct Proved {
  std::uint64_t inputs = 0, nodes = 0;
  std::uint64_t steps = 0;        ///< clauses that the solver derived, and merges
  std::uint64_t assumptions = 0;  ///< literals that the claims rest on
  std::uint64_t claims = 0;       ///< pairs of literals that are never true together
};

/// A step does not follow, or a line is no step; what() names the line.
struct NotValid : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads a certificate, a step a line, each with a 0 at its end:
///   i V        V is an input
///   f V        V is false
///   n V A B    V is A AND B; A and B are of earlier lines
///   a L        the claims are about inputs that make L true
///   L ...      a clause that follows from the lines before
///   m L ...    likewise: two nodes are equal, or two literals exclude each other
///   d L ...    that clause is needed no more
///   o L M      the claim: one of L and M is true for all inputs that count
/// A variable has one line i, f or n, before its first use: so the lines define a circuit, and any values of its inputs
/// satisfy them. A clause follows if its negation leads to a contradiction by unit propagation.
/// `each_line` is called for each line; it may throw.
/// Errors: NotValid. Source: E. Goldberg, Y. Novikov: Verification of Proofs of Unsatisfiability for CNF Formulas, 2003.
/// Test: certificate_test.
Proved check(std::istream& certificate, const std::function<void()>& each_line = {});

}  // namespace mmverify::proofs::certificate
