// The lemmas about the curve, each written by running the specification's own templates on names.  No level occurs in them:
// M = 2m and m are variables.
#pragma once

#include "proofs/attribute/induction/lemmas.hpp"

namespace mmverify::proofs::attribute::induction {

/// The curve numbers the micro-triangles of every level: a bijection, digit by digit.
void add_curve_words(std::vector<Statement>& all);
/// From a number on the curve back to its micro-triangle, by spec::index::corners.
void add_curve_corners(std::vector<Statement>& all, const Parts<Counted>& by);

}  // namespace mmverify::proofs::attribute::induction
