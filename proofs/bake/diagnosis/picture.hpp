// A counterexample as a picture.
#pragma once

#include <string>

#include "proofs/bake/truth/offender.hpp"

namespace mmverify::proofs::bake {

/// An SVG: the texels around the worst micro-triangle, or around the base triangle where all are right; its
/// outline; the line where alpha is at its threshold; the point that contradicts the state.
std::string picture(const Case& one, Level n, const std::optional<Offender>& offender);

}  // namespace mmverify::proofs::bake
