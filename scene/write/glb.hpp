// A writer of a scene with its micromaps: glTF 2.0 with EXT_mesh_opacity_micromap, in one file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "impl/micromap/array.hpp"
#include "scene/read/file.hpp"

namespace mmverify::scene {

/// The micromaps of one primitive, as references into an array.
struct PrimitiveMicromaps {
  std::size_t mesh = 0, number = 0;  ///< meshes[mesh].primitives[number], as in Primitive
  std::size_t micromap = 0;          ///< number in Micromaps::arrays
  impl::micromap::Encoding encoding = impl::micromap::Encoding::u32;
  /// One code a triangle, tightly packed; none: triangle t has record t + base_triangle.
  std::optional<std::span<const std::uint8_t>> indices;
  std::uint32_t base_triangle = 0;
  std::string extras = {};  ///< a JSON object for the extension's `extras`; none if empty
};

struct Micromaps {
  std::span<const impl::micromap::Array> arrays;
  std::span<const PrimitiveMicromaps> primitives;
};

/// The scene of `file` (or of a file's bytes, see load()) as one GLB with the micromaps added.
///   - Buffers and images, wherever they are, become bufferViews of the BIN chunk, with the same bytes.  The rest
///     of the JSON stays, extensions and extras of all kinds included, with its keys sorted.
///   - If a primitive gets micromaps, a strip or fan becomes a list, each triangle with its vertices in the order
///     of glTF 2.0, 3.7.2.1, on which its micromap depends.
///   - All micromaps that the file has are replaced; their bytes stay, unused.
///   - An array without records, all of whose triangles are special indices, gets one record of level 0 that no
///     triangle uses, since the extension has no empty arrays.  Without arrays the extension is left out.
/// The same bytes for the same input.
/// Errors: BadScene if the file, one of its buffers, views or images cannot be read, or an image has no
///   known type; std::invalid_argument if `micromaps` does not fit the scene: a primitive that does not
///   exist, has no triangles, or comes twice, indices that are not one a triangle, an array that does not
///   exist; std::length_error if the file would have 2^32 bytes or more.
/// Source: EXT_mesh_opacity_micromap, draft of 2026 (KhronosGroup/glTF, pull request 2623); docs/GLTF.md.
Bytes to_glb(const std::string& file, const Micromaps& micromaps);
Bytes to_glb(const std::string& name, std::span<const unsigned char> bytes, const Micromaps& micromaps);

/// The bytes of bufferViews that the micromaps of `file` alone read: to_glb() keeps them, and nothing reads them there.
/// Errors: BadScene.
std::uint64_t old_micromap_bytes(const std::string& file);

}  // namespace mmverify::scene
