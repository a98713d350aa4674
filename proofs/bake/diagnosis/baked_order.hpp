// The order of the micro-triangles in a baker's maps.
#pragma once

#include <string>

#include "proofs/bake/subject.hpp"

namespace mmverify::proofs::bake {

/// The name of the order if it is a known one other than the curve's, else empty.  It bakes one map for each
/// micro-triangle of level n, from a texture that is transparent except for a dot inside that micro-triangle. Domain:
/// n in 1..4.  Throws SubjectBroken.
std::string order_of(const BakeSubject& subject, Level n);

}  // namespace mmverify::proofs::bake
