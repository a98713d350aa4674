// The buffers and images of a document, put into one chunk.
#pragma once

#include "scene/read/buffers.hpp"
#include "scene/write/container.hpp"

namespace mmverify::scene {

/// Appends all buffers to `binary`, and has the views of `json`, the document's JSON to be written, follow.
/// Errors: BadScene where a view lies outside its buffer.
void embed_buffers(const Document& document, const Buffers& buffers, nlohmann::json& json,
                   BinaryChunk& binary);

/// Puts the bytes of images with URIs into views, unchanged, and names their types.
/// Errors: BadScene where one cannot be read, or neither its bytes nor the document say its type.
void embed_images(const Document& document, nlohmann::json& json, BinaryChunk& binary);

}  // namespace mmverify::scene
