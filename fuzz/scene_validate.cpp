// The validator of EXT_mesh_opacity_micromap: it returns from all bytes, with lines of known rules; and a
// file without findings can be read by a reader that checks nothing.
//
// Input: scene_input.hpp.
//
// Covers: scene/validate/indices.* scene/validate/micromaps.* scene/validate/primitives.* scene/validate/report.*
// Covers: scene/validate/root.* scene/validate/rules.* scene/validate/stored_maps.* scene/validate/draft.*
// Covers: scene/validate/shared.* scene/validate/suspect_record.*
#include <cstring>
#include <nlohmann/json.hpp>

#include "fuzz/scene_input.hpp"
#include "scene/validate/micromaps.hpp"

namespace {

using namespace mmverify::fuzz::scene;
using namespace mmverify::scene;
using Json = nlohmann::json;

const char* const extension_name = "EXT_mesh_opacity_micromap";

/// A reader of every state of every triangle.  The sanitizer sees reads beyond the bounds.
class TrustingReader {
 public:
  TrustingReader(Json json, Bytes binary) : json_(std::move(json)), binary_(std::move(binary)) {}

  void read() {
    for (const Json& mesh : json_.value("meshes", Json::array()))
      for (const Json& primitive : mesh["primitives"])
        if (primitive.contains("extensions") && primitive["extensions"].contains(extension_name))
          read(primitive, primitive["extensions"][extension_name]);
  }
  std::uint64_t opaque() const { return opaque_; }

 private:
  /// A copy of the view, so that one byte more is out of bounds; unknown unless it is in the BIN chunk.
  Bytes view(std::size_t number, bool& known) const {
    const Json& view = json_["bufferViews"][number];
    known &= view["buffer"] == 0 && !json_["buffers"][0].contains("uri");
    if (!known) return {};
    const auto first = binary_.begin() + view.value("byteOffset", 0);
    return {first, first + view["byteLength"].get<int>()};
  }

  void read(const Json& primitive, const Json& given) {
    const Json& micromap =
        json_["extensions"][extension_name]["micromaps"][given["micromap"].get<std::size_t>()];
    bool known = true;
    const Bytes data = view(micromap["data"], known), records = view(micromap["triangles"], known);
    const Json& drawn = json_["accessors"][(primitive.contains("indices") ? primitive["indices"]
                                            : primitive["attributes"].contains("POSITION")
                                                ? primitive["attributes"]["POSITION"]
                                                : Json(0))
                                               .get<std::size_t>()];
    if (!primitive.contains("indices") && !primitive["attributes"].contains("POSITION")) return;
    const auto triangles = drawn["count"].get<std::size_t>() / 3;
    Bytes codes;
    std::size_t width = 0;
    bool is_signed = false;
    if (given.contains("micromapIndices")) {
      const Json& accessor = json_["accessors"][given["micromapIndices"].get<std::size_t>()];
      if (!accessor.contains("bufferView") || accessor.contains("sparse")) return;
      codes = view(accessor["bufferView"], known);
      if (!known) return;
      codes.erase(codes.begin(), codes.begin() + accessor.value("byteOffset", 0));
      const int type = accessor["componentType"];
      width = type == 5121 ? 1 : type == 5122 || type == 5123 ? 2 : 4;
      is_signed = type == 5122 || type == 5124;
    }
    if (!known) return;
    const auto base = given.value("micromapBaseTriangle", std::uint64_t{0});
    for (std::size_t t = 0; t < triangles; ++t) {
      std::uint64_t index = t;
      if (width != 0) {
        std::uint32_t code = 0;
        std::memcpy(&code, codes.data() + t * width, width);
        const std::uint64_t end = std::uint64_t{1} << 8 * width;
        if (code >= end - 4) continue;  // a special index
        if (is_signed && code >= end / 2) fail("clean, with an index below -4");
        index = code;
      }
      read_record(records, index + base, data);
    }
  }

  void read_record(const Bytes& records, std::uint64_t number, const Bytes& data) {
    std::uint32_t offset;
    std::uint16_t level, format;
    if (8 * number + 8 > records.size()) fail("clean, with an index of no record");
    std::memcpy(&offset, records.data() + 8 * number, 4);
    std::memcpy(&level, records.data() + 8 * number + 4, 2);
    std::memcpy(&format, records.data() + 8 * number + 6, 2);
    if (level > 12 || format < 1 || format > 2) fail("clean, with a record of no level or format");
    for (std::uint64_t bit = 0; bit < std::uint64_t{format} << 2 * level; bit += format)
      opaque_ += data.data()[offset + bit / 8] >> bit % 8 & 1;
  }

  Json json_;
  Bytes binary_;
  std::uint64_t opaque_ = 0;
};

bool is_known(std::string_view rule) {
  return std::any_of(file_rules().begin(), file_rules().end(),
                     [&](const FileRule& known) { return rule == known.id; });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes file = as_file(data, size);
  auto found = validate_micromaps(name, file);
#ifdef PLANTED
  std::erase_if(found, [](const FileViolation& violation) { return violation.rule == "index.range"; });
#endif
  for (const FileViolation& violation : found) {
    if (!is_known(violation.rule)) fail("an unknown rule: " + describe(violation));
    if (describe(violation).find('\n') != std::string::npos) fail("a violation of two lines");
  }
  if (!found.empty() || size == 0 || *data == 'r') return 0;
  const std::uint8_t* const json_end = std::find(data + 1, data + size, std::uint8_t{0});
  const std::uint8_t* const binary = std::min(json_end + 1, data + size);
  TrustingReader reader(Json::parse(data + 1, json_end), {binary, data + size});
  reader.read();
  return static_cast<int>(reader.opaque() & 0);
}
