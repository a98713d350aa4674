// Who places which mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "impl/scene/document.hpp"

namespace mmverify::impl::scene {

/// Uses of each mesh: nodes that name it, each times the instances of EXT_mesh_gpu_instancing.
/// Errors: BadScene where a node has two parents or is its own ancestor: nodes are trees (glTF 2.0, 3.5.2).
std::vector<std::uint64_t> mesh_uses(const Document& document);

}  // namespace mmverify::impl::scene
