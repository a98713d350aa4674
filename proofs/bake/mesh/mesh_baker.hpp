// Bakers of whole meshes: from a baker of one triangle and a builder of arrays, and somebody else's.
#pragma once

#include "proofs/bake/subject.hpp"

namespace mmverify::proofs::bake {

using MeshBaker = std::function<std::optional<array::Answer>(const MeshCase&)>;
/// The states of a triangle's map, or nothing if the subject does not support the case.
using StatesOfTriangle =
    std::function<std::optional<std::vector<State>>(const MeshCase&, std::size_t triangle)>;

/// An array of the triangles' maps, built as `options` say, by this project's builder or by the specification.
std::optional<array::Answer> mesh_array(const char* builder, const MeshCase& mesh,
                                        const StatesOfTriangle& states_of,
                                        const array::BuildOptions& options = {});

/// The states of each triangle's own map, by the subject's `bake`.
StatesOfTriangle own_states(const Functions& functions);

/// Each triangle's own map in an array: special indices where a map is uniform, one record for equal maps.
MeshBaker mesh_baker_of(const Functions& functions, const char* builder);

/// The baker of meshes of a library that offers one.
MeshBaker mesh_baker_of(const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::bake
