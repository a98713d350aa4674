#include "scene/write/container.hpp"

#include <limits>
#include <stdexcept>

#include "scene/read/meshopt.hpp"

namespace mmverify::scene {
namespace {

constexpr std::uint64_t header = 12, chunk_header = 8;

constexpr std::uint64_t padded(std::uint64_t size) { return (size + 3) / 4 * 4; }

void put_word(Bytes& out, std::uint64_t word) {
  for (int k = 0; k < 4; ++k) out.push_back(static_cast<unsigned char>(word >> (8 * k)));
}

template <class Content>
void put_chunk(Bytes& out, std::uint32_t type, const Content& content, unsigned char padding) {
  put_word(out, padded(content.size()));
  put_word(out, type);
  out.insert(out.end(), content.begin(), content.end());
  out.resize(static_cast<std::size_t>(padded(out.size())), padding);
}

}  // namespace

std::uint64_t glb_size(std::uint64_t json, std::uint64_t binary) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  if (json <= most && binary <= most) {
    const std::uint64_t size =
        header + chunk_header + padded(json) + (binary == 0 ? 0 : chunk_header + padded(binary));
    if (size <= most) return size;
  }
  throw std::length_error("a GLB holds less than 2^32 bytes; there are " + std::to_string(json) +
                          " of JSON and " + std::to_string(binary) + " of buffers, images and micromaps");
}

std::size_t BinaryChunk::append(std::span<const unsigned char> bytes) {
  bytes_.resize(static_cast<std::size_t>(padded(bytes_.size())));
  const std::size_t at = bytes_.size();
  glb_size(0, at + bytes.size());
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  return at;
}

std::size_t BinaryChunk::add_view(std::span<const unsigned char> bytes, int target) {
  nlohmann::json view = {{"buffer", 0}, {"byteLength", bytes.size()}};
  view["byteOffset"] = append(bytes);
  if (target != 0) view["target"] = target;
  nlohmann::json& views = (*document_)["bufferViews"];
  views.push_back(std::move(view));
  return views.size() - 1;
}

std::size_t BinaryChunk::add_placeholder(nlohmann::json buffer) {
  buffer.erase("uri");
  placeholders_.push_back(std::move(buffer));
  return placeholders_.size();
}

Bytes glb(nlohmann::json document, const BinaryChunk& binary) {
  if (binary.bytes().empty()) {
    document.erase("buffers");
  } else {
    // Other members of the first buffer, such as a name or extras, stay.
    nlohmann::json buffer = nlohmann::json::object();
    if (const auto buffers = document.find("buffers"); buffers != document.end() && !buffers->empty())
      buffer = buffers->front();
    if (is_meshopt_fallback(buffer)) buffer = nlohmann::json::object();
    buffer.erase("uri");
    buffer["byteLength"] = binary.bytes().size();
    document["buffers"] = nlohmann::json::array({std::move(buffer)});
    for (const nlohmann::json& placeholder : binary.placeholders())
      document["buffers"].push_back(placeholder);
  }
  const std::string json = document.dump();
  constexpr std::uint32_t json_type = 0x4E4F534A, binary_type = 0x004E4942;
  const std::uint64_t size = glb_size(json.size(), binary.bytes().size());
  Bytes out{'g', 'l', 'T', 'F'};
  out.reserve(static_cast<std::size_t>(size));
  put_word(out, 2);
  put_word(out, size);
  put_chunk(out, json_type, json, ' ');
  if (!binary.bytes().empty()) put_chunk(out, binary_type, binary.bytes(), 0);
  return out;
}

}  // namespace mmverify::scene
