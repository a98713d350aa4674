#include "scene/edit/index_codes.hpp"

#include <algorithm>
#include <cstring>

#include "scene/validate/indices.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;
using impl::micromap::Encoding;

Code code_at(std::span<const unsigned char> bytes, std::size_t at, Encoding encoding) {
  const std::size_t width = impl::micromap::width(encoding) / 8;
  std::uint32_t code = 0;
  std::memcpy(&code, bytes.data() + at * width, width);
  const auto state = impl::micromap::special_state(code, encoding);
  return state ? special(*state) : Code{code};
}

/// The code as it is stored.  Domain: a code that the encoding holds.
std::uint32_t stored(Code code, Encoding encoding) {
  return is_special(code) ? impl::micromap::special_code(static_cast<impl::micromap::State>(~code), encoding)
                          : static_cast<std::uint32_t>(code);
}

/// The triangles of a list, as the validator counts them.
std::size_t triangles_of(const Json& json, const Json& primitive) {
  const auto count = [&](const Json& accessor) {
    return json.at("accessors").at(accessor.get<std::size_t>()).at("count").get<std::size_t>() / 3;
  };
  if (primitive.contains("indices")) return count(primitive["indices"]);
  const Json& positions = member(primitive.at("attributes"), "POSITION");
  return positions.is_number() ? count(positions) : 0;
}

int type_of_component(Encoding encoding) {
  switch (encoding) {
    case Encoding::u8: return TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
    case Encoding::u16: return TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    case Encoding::i16: return TINYGLTF_COMPONENT_TYPE_SHORT;
    case Encoding::i32: return TINYGLTF_COMPONENT_TYPE_INT;
    default: return TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  }
}

/// The codes in an encoding.
Bytes bytes_of(const std::vector<Code>& codes, Encoding encoding) {
  const std::size_t width = impl::micromap::width(encoding) / 8;
  Bytes bytes(codes.size() * width);
  for (std::size_t t = 0; t < codes.size(); ++t) {
    const std::uint32_t code = stored(codes[t], encoding);
    std::memcpy(bytes.data() + t * width, &code, width);
  }
  return bytes;
}

/// The least encoding that holds plain codes up to `most`, from the given one on.
Encoding holding(Encoding encoding, Code most) {
  while (static_cast<std::uint64_t>(most) >= impl::micromap::index_limit(encoding)) {
    if (encoding == Encoding::u32 || encoding == Encoding::i32)
      throw std::length_error("the indices reach beyond 32 bits");
    encoding = encoding == Encoding::u8    ? Encoding::u16
               : encoding == Encoding::u16 ? Encoding::u32
                                           : Encoding::i32;
  }
  return encoding;
}

/// Updates the members min and max of an accessor, where it has them.
void set_range(Json& accessor, const std::vector<Code>& codes, Encoding encoding) {
  if (codes.empty()) return;
  const auto value = [&](Code code) { return is_signed(encoding) ? code : Code{stored(code, encoding)}; };
  Code least = value(codes[0]), greatest = least;
  for (const Code code : codes) {
    least = std::min(least, value(code));
    greatest = std::max(greatest, value(code));
  }
  if (accessor.contains("min")) accessor["min"] = {least};
  if (accessor.contains("max")) accessor["max"] = {greatest};
}

/// Whether another primitive reads the accessor, with other codes or as the indices of its vertices.
bool has_other_readers(const EditedFile& file, const LinkedPrimitive& to,
                       const std::vector<LinkedPrimitive>& others) {
  for (const LinkedPrimitive& other : others)
    if (other.accessor == to.accessor && other.codes != to.codes &&
        (other.mesh != to.mesh || other.number != to.number))
      return true;
  for (const Json& mesh : member(file.json, "meshes"))
    for (const Json& primitive : mesh.at("primitives"))
      if (member(primitive, "indices") == Json(*to.accessor)) return true;
  return false;
}

}  // namespace

Json& extension_of(EditedFile& file, std::size_t mesh, std::size_t number) {
  return file.json.at("meshes").at(mesh).at("primitives").at(number).at("extensions").at(micromap_extension);
}

std::vector<LinkedPrimitive> linked_primitives(const EditedFile& file, const Document& document,
                                               const Buffers& buffers) {
  std::vector<LinkedPrimitive> all;
  const Json& meshes = member(file.json, "meshes");
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh)
    for (std::size_t number = 0; number < meshes[mesh].at("primitives").size(); ++number) {
      const Json& primitive = meshes[mesh]["primitives"][number];
      const Json& given = extension(primitive, micromap_extension);
      if (given.empty()) continue;
      LinkedPrimitive one{mesh,
                          number,
                          given.at("micromap").get<std::size_t>(),
                          given.value("micromapBaseTriangle", std::uint32_t{0}),
                          {},
                          Encoding::u32,
                          {}};
      one.codes.resize(triangles_of(file.json, primitive));
      for (std::size_t t = 0; t < one.codes.size(); ++t) one.codes[t] = static_cast<Code>(t);
      if (given.contains("micromapIndices")) {
        one.accessor = given["micromapIndices"].get<std::size_t>();
        Report report;
        const MicromapIndices indices =
            read_micromap_indices(document, buffers, *one.accessor, "", report).value();
        one.encoding = indices.encoding;
        for (std::size_t t = 0; t < one.codes.size(); ++t)
          one.codes[t] = code_at(indices.bytes, t, indices.encoding);
      }
      all.push_back(std::move(one));
    }
  return all;
}

void write_codes(EditedFile& file, const LinkedPrimitive& to, const std::vector<LinkedPrimitive>& others) {
  const std::vector<Code>& codes = to.codes;
  const Code most = codes.empty() ? 0 : std::max<Code>(0, *std::max_element(codes.begin(), codes.end()));
  const Encoding encoding = holding(to.encoding, most);
  const Bytes bytes = bytes_of(codes, encoding);
  Json accessor = {{"type", "SCALAR"}};
  if (to.accessor) {
    Json& old = file.json.at("accessors").at(*to.accessor);
    const auto offset = old.value("byteOffset", std::uint64_t{0});
    if (encoding == to.encoding && old.contains("bufferView") && !old.contains("sparse") &&
        !has_other_readers(file, to, others) &&
        file.is_alone(old["bufferView"].get<std::size_t>(), offset, bytes.size())) {
      file.overwrite(old["bufferView"].get<std::size_t>(), offset, bytes);
      return set_range(old, codes, encoding);
    }
    accessor = old;
    accessor.erase("sparse");
    accessor.erase("byteOffset");
  }
  const Json& micromap = file.json.at("extensions").at(micromap_extension).at("micromaps").at(to.micromap);
  accessor["bufferView"] = file.add_view(file.buffer_of(micromap.at("data").get<std::size_t>()), bytes);
  accessor["componentType"] = type_of_component(encoding);
  accessor["count"] = codes.size();
  set_range(accessor, codes, encoding);
  Json& accessors = file.json["accessors"];
  accessors.push_back(std::move(accessor));
  extension_of(file, to.mesh, to.number)["micromapIndices"] = accessors.size() - 1;
}

}  // namespace mmverify::scene
