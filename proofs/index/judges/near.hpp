// Points so near to an edge that rounding alone may take them over it.
#pragma once

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// Whether a point of the closed micro-triangle with that index is at most `ulps` units in the last place from p along
/// u and along v, in the arithmetic's numbers; exact ones have no last place, and p itself is asked for.
/// Domain: n <= 16, coordinates that a double holds; an index of 4^n or more is no micro-triangle's: false.
bool reaches(const RationalPoint& p, Level n, std::uint32_t index, Arithmetic arithmetic, std::uint32_t ulps);

}  // namespace mmverify::proofs::index
