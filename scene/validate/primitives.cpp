#include <limits>

#include "scene/validate/index_use.hpp"
#include "scene/validate/indices.hpp"
#include "scene/validate/shared.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

class Validation {
 public:
  Validation(const Document& document, const Buffers& buffers, const std::vector<RecordCount>& micromaps,
             Report& report)
      : document_(document), buffers_(buffers), micromaps_(micromaps), report_(report) {}

  void primitive(const Json& primitive, const std::string& of) {
    const Json& extensions = member(primitive, "extensions");
    const auto given = extensions.find(report_.extension());
    if (given == extensions.end()) return;
    const std::string at = of + "/extensions/" + report_.extension();
    if (!given->is_object()) {
      report_.add("primitive.object", at, "an object is due, not " + found(*given));
      return;
    }
    if (const Json& mode = member(primitive, "mode"); mode.is_number() && mode != 4)
      report_.add("primitive.mode", of + "/mode", mode.dump() + " where 4, triangles, is due");

    impl::micromap::Input in;
    in.sets = static_cast<impl::micromap::Sets>(impl::micromap::glTF | report_.target().apis);
    in.triangles = triangles(primitive);
    // If the number of records is unknown, no index is too large; the root's part reports the reason.
    in.record_count = records(*given, at).value_or(std::numeric_limits<std::uint64_t>::max());
    bool readable = base_triangle(*given, at, in);
    MicromapIndices indices;
    if (given->contains("micromapIndices")) {
      in.indexed = true;
      readable &= indices_of(*given, at + "/micromapIndices", in, indices);
    }
    if (readable) judge(in, at);
  }

 private:
  RecordCount records(const Json& given, const std::string& at) {
    const auto number = whole(member(given, "micromap"), micromaps_.size());
    if (number) return micromaps_[static_cast<std::size_t>(*number)];
    report_.add("primitive.micromap", at + "/micromap",
                (given.contains("micromap") ? found(given["micromap"]) : std::string("missing, which")) +
                    " is no index of the " + std::to_string(micromaps_.size()) + " micromaps");
    return {};
  }

  bool base_triangle(const Json& given, const std::string& at, impl::micromap::Input& in) {
    if (!given.contains("micromapBaseTriangle")) return true;
    const auto base = whole(given["micromapBaseTriangle"]);
    if (!base)
      report_.add("primitive.base", at + "/micromapBaseTriangle",
                  "a whole number from 0, below 2^32, is due, not " + found(given["micromapBaseTriangle"]));
    else
      in.base_triangle = static_cast<std::uint32_t>(*base);
    return base.has_value();
  }

  std::uint64_t count_of(const Json& accessor) const {
    return document_.json["accessors"][accessor.get<std::size_t>()]["count"].get<std::uint64_t>();
  }

  /// The number of triangles as the draft counts them for mode 4; indices left over draw none.
  std::uint64_t triangles(const Json& primitive) const {
    if (primitive.contains("indices")) return count_of(primitive["indices"]) / 3;
    const Json& attributes = primitive["attributes"];
    return attributes.contains("POSITION") ? count_of(attributes["POSITION"]) / 3 : 0;
  }

  bool indices_of(const Json& given, const std::string& pointer, impl::micromap::Input& in,
                  MicromapIndices& indices) {
    const std::size_t accessors = member(document_.json, "accessors").size();
    const auto accessor = whole(given["micromapIndices"], accessors);
    if (!accessor) {
      report_.add("indices.accessor", pointer,
                  found(given["micromapIndices"]) + " is no index of the " + std::to_string(accessors) +
                      " accessors");
      return false;
    }
    if (const std::string reader =
            other_reader_of_accessor(document_.json, static_cast<std::size_t>(*accessor));
        !reader.empty())
      report_.add("view.shared", pointer,
                  place("accessor", static_cast<std::size_t>(*accessor)) + " is " + reader + ", too");
    auto read =
        read_micromap_indices(document_, buffers_, static_cast<std::size_t>(*accessor), pointer, report_);
    if (!read) return false;
    indices = std::move(*read);
    if (indices.count != in.triangles) {
      report_.add(
          "indices.count", pointer,
          std::to_string(indices.count) + " indices for " + std::to_string(in.triangles) + " triangles");
      in.triangles = std::min(in.triangles, indices.count);
    }
    const std::size_t size = impl::micromap::width(indices.encoding) / 8;
    in.encoding = indices.encoding;
    in.index_stride = size;
    in.indices = indices.bytes.first(static_cast<std::size_t>(in.triangles) * size);
    in.indices_address = indices.address;
    return true;
  }

  /// Judges the indices against the number of the array's records.  The array itself is judged already.
  void judge(const impl::micromap::Input& in, const std::string& at) {
    constexpr std::uint64_t most = std::uint64_t{1} << 28;
    if (in.indexed) {
      if (in.triangles > most - judged_) {
        report_.add("limits.indices", at + "/micromapIndices",
                    "the indices of this and further primitives, beyond 2^28 in all, are not judged");
        return;
      }
      judged_ += in.triangles;
    }
    const std::string pointer = in.indexed ? at + "/micromapIndices" : at;
    for (const impl::micromap::Violation& violation : impl::micromap::validate(in))
      if (of_indices(violation, in)) report_.add(violation, in, pointer);
    validate_index_use(in, report_.target().device.value_or(Device{}), pointer, report_);
  }

  /// Whether a violation is of the indices; the other ones are of the array, whose records are not here.  A signed type
  /// is none of an API's: the build gets the unsigned one of its width, with the same bits.
  static bool of_indices(const impl::micromap::Violation& violation, const impl::micromap::Input& in) {
    using enum impl::micromap::Rule;
    if (violation.rule == index_encoding) return !impl::micromap::is_signed(in.encoding);
    return violation.place == impl::micromap::Place::triangle || violation.rule == align_index;
  }

  const Document& document_;
  const Buffers& buffers_;
  const std::vector<RecordCount>& micromaps_;
  Report& report_;
  std::uint64_t judged_ = 0;
};

}  // namespace

void validate_primitives(const Document& document, const Buffers& buffers,
                         const std::vector<RecordCount>& micromaps, Report& report) {
  Validation validation(document, buffers, micromaps, report);
  const Json& meshes = member(document.json, "meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const Json& primitives = meshes[m]["primitives"];
    for (std::size_t p = 0; p < primitives.size(); ++p)
      validation.primitive(primitives[p],
                           "/meshes/" + std::to_string(m) + "/primitives/" + std::to_string(p));
  }
}

}  // namespace mmverify::scene
