// The GLB container, as it is written.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "scene/read/file.hpp"

namespace mmverify::scene {

/// Bytes of a GLB whose JSON and BIN chunk hold so many; both are padded to four.  0 of `binary`: no such
/// chunk.
///   12 + 8 + pad(json) + (binary = 0 ? 0 : 8 + pad(binary))
/// Errors: std::length_error where its header, 32 bits, cannot say so many.
/// Source: glTF 2.0, 4.4.
std::uint64_t glb_size(std::uint64_t json, std::uint64_t binary);

/// The bytes of buffer 0, written piece by piece, each of them a bufferView of the document.
class BinaryChunk {
 public:
  explicit BinaryChunk(nlohmann::json& document) : document_(&document) {}

  /// At a multiple of four, as every component of an accessor may ask.  Returns where it begins.
  std::size_t append(std::span<const unsigned char> bytes);

  /// Appends them as a new bufferView, and returns its number; `target` is glTF's, 0: none.
  std::size_t add_view(std::span<const unsigned char> bytes, int target = 0);

  const Bytes& bytes() const { return bytes_; }

 private:
  nlohmann::json* document_;
  Bytes bytes_;
};

/// The file of a document, whose buffers become one: what has been appended to `binary`.
/// Errors: std::length_error as glb_size() has it.
Bytes glb(nlohmann::json document, const BinaryChunk& binary);

}  // namespace mmverify::scene
