// `mmverify validate` on a file of any kind: it returns from all bytes, with findings of known codes; and
// other readers accept a file without errors.
//
// Input: a byte that names the form of the rest.
//   's'   a sidecar's JSON up to a zero byte, then the bytes that every file beside it has
//   'a'   an array file of version 2, whose checksum is corrected first
//   else  a file as it is, with nothing beside it
//
// Covers: scene/validate/build.* scene/validate/container.* scene/validate/file.* scene/validate/issues.* scene/validate/sidecar.*
// Covers: scene/validate/index_use.* scene/validate/members.* scene/validate/same_geometry.* scene/validate/target.*
// Covers: scene/validate/vuids.* scene/validate/cutoffs.* scene/validate/kept_records.* scene/validate/stale_records.*
// Covers: scene/record/* scene/read/json_fault.*
#include <cstring>
#include <nlohmann/json.hpp>

#include "fuzz/scene_input.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/validate/file.hpp"
#include "spec/array/container.hpp"

namespace {

using namespace mmverify::fuzz::scene;
using namespace mmverify::scene;
using Json = nlohmann::json;

/// A reader of every state of every triangle of a raw array.  The sanitizer sees reads beyond the bounds.
class TrustingReader {
 public:
  TrustingReader(const Json& json, const Bytes& beside) : json_(json), beside_(beside) {}

  void read() {
    const Bytes records = buffer(json_["records"]), data = buffer(json_["data"]);
    const auto stride = json_["records"].is_null() ? 8 : json_["records"].value("stride", std::uint64_t{8});
    for (const Json& geometry : json_.value("geometries", Json::array())) {
      const auto base = geometry.value("baseTriangle", std::uint64_t{0});
      const bool indexed = geometry.contains("indices") && !geometry["indices"].is_null() &&
                           geometry["indices"]["type"] != "none";
      const Bytes indices = indexed ? buffer(geometry["indices"]) : Bytes();
      // A million triangles in so few bytes are one triangle over and over.
      const auto triangles = std::min(geometry["triangles"].get<std::uint64_t>(), std::uint64_t{1} << 16);
      for (std::uint64_t t = 0; t < triangles; ++t) {
        const auto index = indexed ? index_at(geometry["indices"], indices, t) : t;
        if (index) read_record(records, stride * (*index + base), data);
      }
    }
  }
  std::uint64_t opaque() const { return opaque_; }

 private:
  /// A copy of the buffer, so that one byte more is out of bounds.
  Bytes buffer(const Json& json) const {
    if (json.is_null()) return {};
    const auto offset = json.value("offset", std::uint64_t{0}),
               bytes = json.value("bytes", beside_.size() - offset);
    const auto first = beside_.begin() + static_cast<std::ptrdiff_t>(offset);
    return {first, first + static_cast<std::ptrdiff_t>(bytes)};
  }

  /// The index of a triangle; none for a special index.
  static std::optional<std::uint64_t> index_at(const Json& json, const Bytes& indices, std::uint64_t t) {
    const std::string type = json["type"];
    const std::size_t width = type == "u8" ? 1 : type.ends_with("16") ? 2 : 4;
    std::uint32_t code = 0;
    std::memcpy(&code, indices.data() + t * json.value("stride", std::uint64_t{width}), width);
    const std::uint64_t end = std::uint64_t{1} << 8 * width;
    if (code >= end - 4) return {};
    if (type[0] == 'i' && code >= end / 2) return {};  // glTF alone forbids it
    return code;
  }

  void read_record(const Bytes& records, std::uint64_t at, const Bytes& data) {
    std::uint32_t offset;
    std::uint16_t level, format;
    if (at + 8 > records.size()) fail("no error, and an index of no record");
    std::memcpy(&offset, records.data() + at, 4);
    std::memcpy(&level, records.data() + at + 4, 2);
    std::memcpy(&format, records.data() + at + 6, 2);
    if (format < 1 || format > 2) fail("no error, and a record of no format");
    for (std::uint64_t bit = 0; bit < std::uint64_t{format} << 2 * level; bit += format)
      opaque_ += data.data()[offset + bit / 8] >> bit % 8 & 1;
  }

  const Json& json_;
  const Bytes& beside_;
  std::uint64_t opaque_ = 0;
};

/// Writes the FNV-1a sum of all but the last four bytes into those four.
void seal(Bytes& file) {
  if (file.size() < 4) return;
  const std::uint32_t sum = mmverify::spec::array::checksum(std::span(file).first(file.size() - 4));
  std::memcpy(file.data() + file.size() - 4, &sum, 4);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::uint8_t* const end = data + size;
  const std::uint8_t* const json_end = *data == 's' ? std::find(data + 1, end, std::uint8_t{0}) : end;
  Bytes file(data + 1, json_end);
  const Bytes beside(std::min(json_end + 1, end), end);
  if (*data == 'a') seal(file);
  std::optional<Judged> judged;
  try {
    judged = validate_file(name, file, {}, [&](const std::string& of) {
      if (*data != 's') throw BadScene(name, of, "there is no file");
      return beside;
    });
  } catch (const BadScene&) {
    return 0;  // of no kind
  }
  for (const FileViolation& finding : judged->findings) {
    issue_of(finding.rule);  // or std::out_of_range ends this
    if (describe(finding).find('\n') != std::string::npos) fail("a finding of two lines");
  }
  if (judged->count(Severity::error) != 0) return 0;
  if (judged->kind == FileKind::array && !mmverify::spec::array::read(file))
    fail("no error, and the specification does not read it");
  if (judged->kind != FileKind::sidecar) return 0;
  const Json json = Json::parse(file);
  TrustingReader reader(json, beside);
  reader.read();
  return static_cast<int>(reader.opaque() & 0);
}
