// The primitives of all meshes out of a document.
#pragma once

#include <vector>

#include "scene/read/buffers.hpp"
#include "scene/scene.hpp"

namespace mmverify::scene {

/// Errors: BadScene as load() says of accessors, indices, positions and UVs.
std::vector<Primitive> read_primitives(const Document& document, const Buffers& buffers,
                                       const std::vector<Material>& materials);

}  // namespace mmverify::scene
