// Meshes drawn at random, in which many triangles are nearly others.
#pragma once

#include "proofs/bake/mesh/mesh_case.hpp"

namespace mmverify::proofs::bake {

/// Mesh k of a level, the same everywhere.  The first mesh_pairs() have two triangles: the second one comes from the first
/// in each way in turn.  The others have 2 to 9 triangles.  Textures have up to 8x8 texels, every third all features.
/// Formats: 4-state, or either one.
std::uint64_t mesh_pairs();
MeshCase mesh_sample(std::uint64_t seed, Level n, std::uint64_t k, bool any_format);
const char* mesh_samples_text();

}  // namespace mmverify::proofs::bake
