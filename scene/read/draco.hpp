// A decoder of primitives that Draco has compressed.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "scene/read/buffers.hpp"

namespace mmverify::scene {

/// The elements of a compressed primitive, tightly packed in the component types of their accessors.
struct DracoMesh {
  Bytes indices;
  std::map<std::string, Bytes> attributes;  ///< by name: POSITION, TEXCOORD_0 ...

  /// The elements of an attribute; null if it stands in its accessor's view.
  const Bytes* attribute(const std::string& name) const {
    const auto found = attributes.find(name);
    return found == attributes.end() ? nullptr : &found->second;
  }
};

/// Whether this build decodes.
bool has_draco() noexcept;

/// The mesh of a primitive with KHR_draco_mesh_compression; none of another one, and none if an accessor has
/// its elements uncompressed, too, and this build does not decode.  `at`: the primitive's place.
/// Errors: BadScene if the extension's object is malformed, the primitive is a strip, or its accessors have other
/// counts and types than the mesh; DamagedData if the decoder refuses the bytes; UnreadExtension in a
/// build without the library.
/// Source: KHR_draco_mesh_compression.
std::optional<DracoMesh> draco_mesh(const Document& document, const Buffers& buffers,
                                    const nlohmann::json& primitive, const std::string& at);

}  // namespace mmverify::scene
