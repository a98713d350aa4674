// The order in which a baker's maps have their micro-triangles.
#pragma once

#include <string>

#include "proofs/bake/subject.hpp"

namespace mmverify::proofs::bake {

/// What it is called if it is another known one; empty where it is the curve's, or none that is known.  One map for each
/// micro-triangle of level n is baked, of a texture that is transparent but for a dot inside it.
/// Domain: n in 1..4.  Throws SubjectBroken.
std::string order_of(const BakeSubject& subject, Level n);

}  // namespace mmverify::proofs::bake
