// What a wrong subject does instead: ties, range, levels, or another order that has a name.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// The index that somebody gives an open micro-triangle.
using TriangleIndex = std::function<std::uint32_t(const MicroTriangle&)>;

/// Names the order of these indices at one level, where it is a known one and not the reference's:
///   row order; the reference's or row order with the vertices in another order; the curve's digits with the
///   children permuted, at which depths; the curve without its flips, or without turning the middle triangle.
/// Empty where it is none of these.  Asks each of the 4^n micro-triangles once.  Domain: n in 1..10.
std::string name_order(Level n, const TriangleIndex& index);

/// Lines about a subject by its results of index.equals_reference, from the lowest level on, of which one is refuted.
std::vector<std::string> diagnose(const IndexSubject& subject, const std::vector<Result>& results);

}  // namespace mmverify::proofs::index
