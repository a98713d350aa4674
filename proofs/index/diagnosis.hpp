// Diagnosis of a wrong index: ties, range, levels, or another order with a known name.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// The index of an open micro-triangle by a subject.
using TriangleIndex = std::function<std::uint32_t(const MicroTriangle&)>;

/// The name of the order of these indices at one level, if it is a known one other than the reference's:
///   row order; the reference's or row order with the vertices in another order; the curve's digits with the
///   children permuted, at which depths; the curve without its flips, or without turning the middle triangle.
/// Empty for any other order.  Calls `index` once for each of the 4^n micro-triangles.  Domain: n in 1..10.
std::string name_order(Level n, const TriangleIndex& index);

/// Lines about a subject by its results of index.equals_reference, from the lowest level on.  Domain: one of them is
/// refuted.
std::vector<std::string> diagnose(const IndexSubject& subject, const std::vector<Result>& results);

}  // namespace mmverify::proofs::index
