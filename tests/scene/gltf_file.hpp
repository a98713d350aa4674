// Small glTF files, built piece by piece: sound ones, and then whatever a test does to them.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace mmverify::tests {

using Json = nlohmann::json;

inline std::string base64(const std::string& bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 3; ++i)
      word = word << 8 | (k + i < bytes.size() ? static_cast<unsigned char>(bytes[k + i]) : 0u);
    for (std::size_t i = 0; i < 4; ++i)
      text += k + i > bytes.size() ? '=' : digits[word >> (18 - 6 * i) & 63];
  }
  return text;
}

inline std::string little_endian(std::uint32_t word) {
  std::string bytes(4, '\0');
  for (std::size_t k = 0; k < 4; ++k) bytes[k] = static_cast<char>(word >> (8 * k));
  return bytes;
}

inline std::string big_endian(std::uint32_t word) {
  const std::string bytes = little_endian(word);
  return {bytes.rbegin(), bytes.rend()};
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

/// A chunk of a PNG, with its CRC: PNG 3rd edition, 5.3 and annex D.
inline std::string png_chunk(const std::string& type, const std::string& data) {
  std::uint32_t crc = 0xffffffff;
  for (const char c : type + data) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(~crc);
}

/// A PNG of one IDAT of stored blocks.  `rows`: of each row its bytes as PNG stores them.
/// The checksum of its texels is zero, which the decoder does not look at.
inline std::string png(std::uint32_t width, std::uint32_t height, int bits, int colour_type,
                       const std::vector<std::string>& rows, const std::string& before_idat = "") {
  std::string pixels;
  for (const std::string& row : rows) pixels += std::string(1, '\0') + row;
  const auto size = static_cast<std::uint32_t>(pixels.size());
  const std::string length = little_endian(size | (~size & 0xffff) << 16);
  return "\x89PNG\r\n\x1a\n" +
         png_chunk("IHDR", big_endian(width) + big_endian(height) + static_cast<char>(bits) +
                               static_cast<char>(colour_type) + std::string(3, '\0')) +
         before_idat + png_chunk("IDAT", "\x78\x01\x01" + length + pixels + std::string(4, '\0')) +
         png_chunk("IEND", "");
}

/// One of 2 x 2 RGBA texels, alpha 0, 85, 170, 255.
inline std::string small_png() {
  return png(2, 2, 8, 6, {std::string("\1\2\3\0\1\2\3\x55", 8), "\1\2\3\xaa\1\2\3\xff"});
}

struct GltfFile {
  Json json = {{"asset", {{"version", "2.0"}}}};
  std::string bytes;  ///< of buffer 0

  std::size_t add(const char* array, Json element) {
    json[array].push_back(std::move(element));
    return json[array].size() - 1;
  }

  std::size_t add_view(const std::string& data) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    const std::size_t at = bytes.size();
    bytes += data;
    return add("bufferViews", {{"buffer", 0}, {"byteOffset", at}, {"byteLength", data.size()}});
  }

  template <class T>
  std::size_t add_accessor(const std::vector<T>& values, int component_type, const char* type,
                           std::size_t components, bool normalized = false) {
    Json accessor = {{"bufferView", add_view(bytes_of(values))},
                     {"componentType", component_type},
                     {"type", type},
                     {"count", values.size() / components}};
    if (normalized) accessor["normalized"] = true;
    return add("accessors", std::move(accessor));
  }

  Json& primitive() { return json["meshes"][0]["primitives"][0]; }
  Json& accessor(const char* attribute) {
    return json["accessors"][primitive()["attributes"][attribute].get<std::size_t>()];
  }
  Json& view(const char* attribute) {
    return json["bufferViews"][accessor(attribute)["bufferView"].get<std::size_t>()];
  }
  Json& base_color() { return json["materials"][0]["pbrMetallicRoughness"]; }

  void set_buffer_length() { json["buffers"][0]["byteLength"] = bytes.size(); }

  static void write(const std::filesystem::path& file, const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
  }

  std::string glb() const {
    std::string text = json.dump(), binary = bytes;
    text.resize((text.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4);
    const auto size = [](std::size_t bytes) { return little_endian(static_cast<std::uint32_t>(bytes)); };
    return "glTF" + size(2) + size(28 + text.size() + binary.size()) + size(text.size()) + "JSON" + text +
           size(binary.size()) + std::string("BIN\0", 4) + binary;
  }

  std::string gltf_with_data_uri() const {
    Json embedded = json;
    embedded["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(bytes);
    return embedded.dump();
  }
};

/// A GLB of two chunks, taken apart by their lengths alone.
inline GltfFile taken_apart(const std::vector<unsigned char>& glb) {
  const std::string file(glb.begin(), glb.end());
  const auto word = [&](std::size_t at) {
    std::uint32_t value;
    std::memcpy(&value, file.data() + at, 4);
    return value;
  };
  GltfFile parts;
  const std::size_t json = word(12);
  parts.json = Json::parse(file.substr(20, json));
  parts.bytes = file.substr(28 + json, word(20 + json));
  return parts;
}

inline std::vector<unsigned char> as_bytes(const std::string& text) { return {text.begin(), text.end()}; }

/// Two triangles of a unit square under an alpha-tested 2 x 2 texture, all in buffer 0.
inline GltfFile square() {
  GltfFile file;
  const auto positions = file.add_accessor<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 5126, "VEC3", 3);
  const auto uvs = file.add_accessor<float>({0, 1, 1, 1, 1, 0, 0, 0}, 5126, "VEC2", 2);
  const auto indices = file.add_accessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, 5123, "SCALAR", 1);
  file.add("images",
           {{"bufferView", file.add_view(small_png())}, {"mimeType", "image/png"}, {"name", "leaf"}});
  file.add("textures", {{"source", 0}});
  file.add("materials", {{"name", "leaf"},
                         {"alphaMode", "MASK"},
                         {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  file.add("meshes", {{"primitives",
                       {{{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uvs}}},
                         {"indices", indices},
                         {"material", 0}}}}});
  file.add("nodes", {{"mesh", 0}});
  file.add("scenes", {{"nodes", {0}}});
  file.add("buffers", {{"byteLength", file.bytes.size()}});
  return file;
}

}  // namespace mmverify::tests
