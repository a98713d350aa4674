#include "scene/read/buffers.hpp"

#include "scene/read/bad_scene.hpp"
#include "scene/read/resource.hpp"

namespace mmverify::scene {
namespace {

Bytes read_buffer(const Document& document, std::size_t index, const nlohmann::json& buffer) {
  const std::string at = place("buffer", index);
  const auto uri = buffer.find("uri");
  if (uri == buffer.end()) {
    if (index == 0 && document.binary) return *document.binary;
    throw BadScene(document.file, at, "no URI, and no BIN chunk of a GLB to take its place");
  }
  return read_resource(document, uri->get_ref<const std::string&>(), at);
}

}  // namespace

Buffers::Buffers(const Document& document) : document_(&document) {
  const nlohmann::json& buffers = member(document.json, "buffers");
  for (std::size_t k = 0; k < buffers.size(); ++k) {
    buffers_.push_back(read_buffer(document, k, buffers[k]));
    // A buffer may have more bytes, since GLB pads.
    if (const auto due = buffers[k]["byteLength"].get<std::size_t>(); buffers_.back().size() < due)
      throw BadScene(document.file, place("buffer", k),
                     "byteLength is " + std::to_string(due) + ", there are " +
                         std::to_string(buffers_.back().size()) + " bytes; truncated file?");
    else
      buffers_.back().resize(due);
  }
}

std::span<const unsigned char> Buffers::view(std::size_t index) const {
  const tinygltf::BufferView& view = document_->model.bufferViews[index];
  const Bytes& buffer = buffers_[static_cast<std::size_t>(view.buffer)];
  // Both are below 2^31, so that the sum does not overflow.
  if (view.byteOffset + view.byteLength > buffer.size())
    throw BadScene(document_->file, place("bufferView", index),
                   "bytes " + std::to_string(view.byteOffset) + ".." +
                       std::to_string(view.byteOffset + view.byteLength) + " of a " +
                       std::to_string(buffer.size()) + "-byte buffer; truncated file?");
  return std::span(buffer).subspan(view.byteOffset, view.byteLength);
}

}  // namespace mmverify::scene
