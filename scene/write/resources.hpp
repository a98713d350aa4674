// A writer of the buffers and images of a document into one chunk.
#pragma once

#include "scene/read/buffers.hpp"
#include "scene/write/container.hpp"

namespace mmverify::scene {

/// Appends all buffers to `binary`, and updates the views of `json`, the document's JSON to be written.
/// Errors: BadScene if a view lies outside its buffer.
void embed_buffers(const Document& document, const Buffers& buffers, nlohmann::json& json,
                   BinaryChunk& binary);

/// Puts the bytes of images with URIs into views, unchanged, and names their types.
/// Errors: BadScene if one cannot be read, or neither its bytes nor the document name its type.
void embed_images(const Document& document, nlohmann::json& json, BinaryChunk& binary);

}  // namespace mmverify::scene
