// A writer of the GLB container.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "scene/read/file.hpp"

namespace mmverify::scene {

/// The bytes of a GLB whose JSON and BIN chunk have `json` and `binary` bytes; both are padded to four.
/// If `binary` is 0, there is no BIN chunk.
///   12 + 8 + pad(json) + (binary = 0 ? 0 : 8 + pad(binary))
/// Errors: std::length_error if the sum exceeds its header's 32 bits.
/// Source: glTF 2.0, 4.4.
std::uint64_t glb_size(std::uint64_t json, std::uint64_t binary);

/// The bytes of buffer 0, appended piece by piece.
class BinaryChunk {
 public:
  explicit BinaryChunk(nlohmann::json& document) : document_(&document) {}

  /// Appends bytes at a multiple of four, which every component of an accessor may require, and returns their
  /// offset.
  std::size_t append(std::span<const unsigned char> bytes);

  /// Appends bytes as a new bufferView, and returns its number; `target` is glTF's, 0: none.
  std::size_t add_view(std::span<const unsigned char> bytes, int target = 0);

  /// Keeps a buffer without bytes, the fallback of compressed views, and returns its number in the file.
  std::size_t add_placeholder(nlohmann::json buffer);

  const Bytes& bytes() const { return bytes_; }
  const std::vector<nlohmann::json>& placeholders() const { return placeholders_; }

 private:
  nlohmann::json* document_;
  Bytes bytes_;
  std::vector<nlohmann::json> placeholders_;
};

/// The file of a document whose buffers become one, `binary`, and its placeholders behind it.
/// Errors: std::length_error as of glb_size().
Bytes glb(nlohmann::json document, const BinaryChunk& binary);

}  // namespace mmverify::scene
