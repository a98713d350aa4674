// The primitives of all meshes out of a document.
#pragma once

#include <vector>

#include "scene/read/buffers.hpp"
#include "scene/scene.hpp"

namespace mmverify::scene {

/// Errors: BadScene as load() says of accessors, indices, positions and UVs.
std::vector<Primitive> read_primitives(const Document& document, const Buffers& buffers,
                                       const std::vector<Material>& materials);

/// The UVs that a texture is seen at, transformed, by the vertices of a primitive of read_primitives(); none where the
/// primitive has not that set.  Errors: BadScene as load() says of UVs.
std::vector<Uv> read_uvs(const Document& document, const Buffers& buffers, const Primitive& primitive,
                         const BaseColorTexture& texture);

}  // namespace mmverify::scene
