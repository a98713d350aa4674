// A reader of nodes and of the meshes that they place.
#pragma once

#include <vector>

#include "scene/read/buffers.hpp"
#include "scene/scene.hpp"

namespace mmverify::scene {

/// The meshes and their uses: the nodes that name a mesh, each times the instances of
/// EXT_mesh_gpu_instancing.
/// Errors: BadScene if a node has two parents or is its own ancestor, since nodes are trees (glTF 2.0,
/// 3.5.2); for scales of instances as of read_floats().
std::vector<Mesh> read_meshes(const Document& document, const Buffers& buffers);

/// Every use of a mesh, in the order of nodes, parents before children.  If no node places a mesh, each mesh
/// is used once, at the identity.
/// Domain: a document whose meshes read_meshes() has read.  Errors: as of it.
std::vector<MeshUse> read_uses(const Document& document, const Buffers& buffers);

}  // namespace mmverify::scene
