// A decoder of bufferViews that meshoptimizer has compressed.
#pragma once

#include <string>
#include <vector>

#include "scene/read/document.hpp"

namespace mmverify::scene {

/// EXT_meshopt_compression or KHR_meshopt_compression of a bufferView.
struct MeshoptView {
  std::string extension;  ///< its name
  std::size_t buffer = 0, offset = 0, length = 0, stride = 0, count = 0;
  std::string mode, filter = "NONE";
};

/// The extension's objects on a bufferView, under either name.  `at`: the view's place.
/// Errors: BadScene if a member has another type than in the extension's schema, or the buffer is not there.
std::vector<MeshoptView> meshopt_views(const Document& document, const nlohmann::json& view,
                                       const std::string& at);

/// Whether a buffer is a placeholder for what is stored compressed: it may lack its bytes.
bool is_meshopt_fallback(const nlohmann::json& buffer);

/// Whether this build decodes.
bool has_meshopt() noexcept;

/// The count * stride bytes of a view.
/// Errors: BadScene if mode, filter, stride and count do not go together; DamagedData if the decoder refuses the
/// bytes; UnreadExtension for a filter or a version of the code that the library does not know, and in a
/// build without the library.
/// Source: EXT_meshopt_compression, KHR_meshopt_compression.
Bytes decode_meshopt(const MeshoptView& view, std::span<const unsigned char> compressed,
                     const std::string& file, const std::string& at);

}  // namespace mmverify::scene
