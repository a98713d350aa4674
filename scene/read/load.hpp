// A reader of glTF 2.0.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "scene/scene.hpp"

namespace mmverify::scene {

struct Document;

/// The scene of a .gltf (with buffers and images beside it or in data URIs) or a .glb; the first bytes tell
/// them apart.
///   - Triangle lists, strips and fans become lists in the vertex order of glTF 2.0, 3.7.2.1. Vertices left
///     over at the end are dropped; points and lines have no triangles.
///   - Normalised integers become float32 as in 3.11; others only under KHR_mesh_quantization.
///   - Images are decoded if a primitive's material is MASK or BLEND and its base colour names them.
///   - Meshopt's and Draco's compression is decoded, if the build has their libraries.
///   - Of several images of a texture one is taken, see texture_source(); Scene::notes has which.
///   - A mesh is used once per node that names it, in any scene, times EXT_mesh_gpu_instancing's count.
/// Errors: BadScene, which names file and place, if
///   - a file or chunk is missing, empty or cut off. All buffers and images count, even unused ones: a program
///     that writes the scene again writes every image;
///   - the JSON is no glTF 2.0 or needs a later one, of wrong types, with references to nothing, nested more than 64 deep;
///   - an accessor reaches beyond its view, a view beyond its buffer, an index beyond the vertices;
///   - a position or UV is not finite; nodes have two parents or form a circle;
///   - an object that is read has an extension that the file requires and that is not read here, or its bytes
///     are compressed in a way that this build does not read (UnreadExtension); other required names do not matter;
///   - an image to decode is of no kind that is read, damaged, empty or beyond 16384 texels a side;
///   - it is larger than 2^31 - 1 bytes a file, or than 2^26 vertices and triangles in all.
Scene load(const std::string& file);

/// The scene of a file's bytes in memory; messages call the file `name`.
/// Errors: as above, and BadScene if a URI names a file.
Scene load(const std::string& name, std::span<const unsigned char> bytes);

/// The scene of a document.
/// Errors: as above.
Scene load(const Document& document);

/// Decodes the images that load() left out.  One that cannot be decoded stays as it is; so does each beyond `texels`
/// texels in all.
void decode_other_images(const Document& document, Scene& scene, std::uint64_t texels);

/// The placed uses of the meshes of a file, in one order.  If no node places a mesh, each mesh is used once,
/// at the identity.
/// Errors: as of load().
std::vector<MeshUse> load_uses(const std::string& file);
std::vector<MeshUse> load_uses(const std::string& name, std::span<const unsigned char> bytes);

}  // namespace mmverify::scene
