// Maps of meshes whose index buffers were rewritten: triangles in another order, corners turned.
#pragma once

#include <optional>

#include "proofs/scene/cause/cause.hpp"
#include "proofs/scene/cause/examined.hpp"

namespace mmverify::proofs::scene {

/// The cause, if at least three of four wrong triangles fit a record of the file, their own or another one, in some order
/// of their corners.  A map fits if each state is as it should be; unknown ones may be on either side.
///   "corners"                  records are their own
///   "other_triangles"          records are others', corners are not turned
///   "corners+other_triangles"  both
/// The others have to fit nearly: tools that compress change UVs by little.
/// Errors: exceptions of baking.
std::optional<Cause> rewritten_indices(const Examined& examined);

}  // namespace mmverify::proofs::scene
