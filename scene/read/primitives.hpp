// A reader of the primitives of all meshes of a document.
#pragma once

#include <vector>

#include "scene/read/buffers.hpp"
#include "scene/scene.hpp"

namespace mmverify::scene {

/// The primitives of all meshes.  Errors: BadScene as load() says of accessors, indices, positions and UVs.
std::vector<Primitive> read_primitives(const Document& document, const Buffers& buffers,
                                       const std::vector<Material>& materials);

/// The UVs at which a primitive of read_primitives() reads a texture, transformed, by vertex; none if the
/// primitive lacks that set.  Errors: BadScene as load() says of UVs.
std::vector<Uv> read_uvs(const Document& document, const Buffers& buffers, const Primitive& primitive,
                         const BaseColorTexture& texture);

}  // namespace mmverify::scene
