// The cutoffs under which all stored maps are right.
#pragma once

#include <optional>
#include <vector>

#include "proofs/scene/cause/inputs.hpp"

namespace mmverify::proofs::scene {

/// Cutoffs from `least` to `greatest`, to 1/2^16.
struct CutoffRange {
  double least, greatest;
};

/// The range under which no known state of these triangles is wrong, and no unknown one needless if there is such a
/// range; none: there is no such cutoff.  Surfaces are taken for MASK.
///   O is right up to the least alpha of its micro-triangle, T above the greatest; an unknown state between the two.
std::optional<CutoffRange> cutoffs(const Judged& judged, const std::vector<std::size_t>& triangles,
                                   const std::vector<States>& stored);

/// The inputs with that cutoff, and MASK, on all surfaces.
Inputs with_cutoff(Inputs inputs, double cutoff);

}  // namespace mmverify::proofs::scene
