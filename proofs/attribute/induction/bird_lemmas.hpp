// The lemmas about upright micro-triangles along the curve and about Bird's order, each written by running the
// specification's own templates on names.  No level occurs in them: M = 2m, m and N are variables.
#pragma once

#include "proofs/attribute/induction/lemmas.hpp"

namespace mmverify::proofs::attribute::induction {

/// Upright micro-triangles along the curve, counted and found.
void add_upright(std::vector<Statement>& all, const Parts<Counted>& by);
/// Bird's order: corners, halvings, the middles of edges, numbers.
void add_bird(std::vector<Statement>& all, const Parts<Counted>& by);

}  // namespace mmverify::proofs::attribute::induction
