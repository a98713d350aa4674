#include "scene/read/buffers.hpp"

#include "scene/read/bad_scene.hpp"
#include "scene/read/extensions.hpp"
#include "scene/read/meshopt.hpp"
#include "scene/read/resource.hpp"

namespace mmverify::scene {
namespace {

/// The bytes of a buffer; none of a fallback that was left out of the file.
Bytes read_buffer(const Document& document, std::size_t index, const nlohmann::json& buffer) {
  const std::string at = place("buffer", index);
  const auto uri = buffer.find("uri");
  const bool fallback = is_meshopt_fallback(buffer);
  if (uri == buffer.end()) {
    if (index == 0 && document.binary) return *document.binary;
    if (fallback) return {};
    throw BadScene(document.file, at, "no URI, and no BIN chunk of a GLB to take its place");
  }
  const std::string& name = uri->get_ref<const std::string&>();
  if (fallback && is_missing(document, name, at)) return {};
  return read_resource(document, name, at);
}

}  // namespace

Buffers::Buffers(const Document& document) : document_(&document) {
  const nlohmann::json& buffers = member(document.json, "buffers");
  for (std::size_t k = 0; k < buffers.size(); ++k) {
    check_extensions(document, buffers[k], place("buffer", k));
    buffers_.push_back(read_buffer(document, k, buffers[k]));
    if (is_placeholder(k)) continue;
    // A buffer may have more bytes, since GLB pads.
    if (const auto due = buffers[k]["byteLength"].get<std::size_t>(); buffers_.back().size() < due)
      throw BadScene(document.file, place("buffer", k),
                     "byteLength is " + std::to_string(due) + ", there are " +
                         std::to_string(buffers_.back().size()) + " bytes; truncated file?");
    else
      buffers_.back().resize(due);
  }
}

bool Buffers::is_placeholder(std::size_t buffer) const {
  return buffers_[buffer].empty() && is_meshopt_fallback(document_->json["buffers"][buffer]);
}

std::span<const unsigned char> Buffers::stored(std::size_t view, std::size_t buffer, std::size_t offset,
                                               std::size_t length) const {
  const Bytes& bytes = buffers_[buffer];
  // Both are below 2^31, so that the sum does not overflow.
  if (offset + length > bytes.size())
    throw BadScene(document_->file, place("bufferView", view),
                   "bytes " + std::to_string(offset) + ".." + std::to_string(offset + length) + " of a " +
                       std::to_string(bytes.size()) + "-byte buffer; truncated file?");
  return std::span(bytes).subspan(offset, length);
}

void Buffers::check_view(std::size_t index) const {
  const tinygltf::BufferView& view = document_->model.bufferViews[index];
  const auto buffer = static_cast<std::size_t>(view.buffer);
  if (!is_placeholder(buffer)) stored(index, buffer, view.byteOffset, view.byteLength);
  for (const MeshoptView& packed :
       meshopt_views(*document_, document_->json["bufferViews"][index], place("bufferView", index)))
    stored(index, packed.buffer, packed.offset, packed.length);
}

std::span<const unsigned char> Buffers::view(std::size_t index) const {
  const tinygltf::BufferView& view = document_->model.bufferViews[index];
  const auto buffer = static_cast<std::size_t>(view.buffer);
  const std::string at = place("bufferView", index);
  const nlohmann::json& json = document_->json["bufferViews"][index];
  check_extensions(*document_, json, at);
  const auto all = meshopt_views(*document_, json, at);
  if (all.empty() || (!has_meshopt() && !is_placeholder(buffer)))
    return stored(index, buffer, view.byteOffset, view.byteLength);
  const MeshoptView& packed = all.front();
  const auto found = decoded_.find(index);
  if (found != decoded_.end()) return found->second;
  if (packed.count * packed.stride != view.byteLength)
    throw BadScene(document_->file, at + ": " + packed.extension,
                   std::to_string(packed.count) + " elements of " + std::to_string(packed.stride) +
                       " bytes for a view of " + std::to_string(view.byteLength));
  const auto compressed = stored(index, packed.buffer, packed.offset, packed.length);
  return decoded_.emplace(index, decode_meshopt(packed, compressed, document_->file, at)).first->second;
}

}  // namespace mmverify::scene
