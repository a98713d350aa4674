#include "scene/edit/rules.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "impl/micromap/validate.hpp"
#include "scene/edit/index_codes.hpp"
#include "scene/edit/map_edits.hpp"
#include "scene/edit/record_sizes.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/validate/indices.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;
namespace micromap = impl::micromap;

/// The number behind a word in a pointer: 3 in "/accessors/3/count".
std::optional<std::size_t> number_behind(const std::string& pointer, const std::string& word) {
  const auto at = pointer.find("/" + word + "/");
  if (at == std::string::npos) return {};
  return std::stoul(pointer.substr(at + word.size() + 2));
}

/// The rounds of repairs and new findings.
constexpr int most_rounds = 8;

class Rules {
 public:
  explicit Rules(EditedFile& file) : file_(file), json_(file.json) {}

  RepairedRules repaired() {
    RepairedRules& all = all_;
    for (int round = 0; round < most_rounds; ++round) {
      all.left = validate_micromaps([&] { return file_.reopened(file_.written()); });
      bool changes = false;
      for (const FileViolation& violation : all.left) {
        if (!done_.insert({std::string(violation.rule), violation.pointer}).second) continue;
        const std::string did = repair(violation);
        if (did.empty()) continue;
        all.repairs.push_back({std::string(violation.rule), violation.pointer, did});
        changes = true;
      }
      if (!changes) break;
    }
    return std::move(all_);
  }

 private:
  /// Repairs one finding; what was done, empty for nothing.
  std::string repair(const FileViolation& violation) {
    using Repair = std::string (Rules::*)(const std::string&);
    static const std::map<std::string_view, Repair> repairs{
        {"used.listed", &Rules::list_use},
        {"required.unlisted", &Rules::unlist_requirement},
        {"micromap.name", &Rules::erase},
        {"micromap.missing", &Rules::count_records},
        {"view.stride", &Rules::tighten},
        {"usage.array", &Rules::count_records},
        {"usage.integer", &Rules::count_records},
        {"usage.length", &Rules::count_records},
        {"counts.zero", &Rules::count_records},
        {"counts.level_12", &Rules::count_records},
        {"counts.format", &Rules::count_records},
        {"counts.array", &Rules::count_records},
        {"records.whole", &Rules::cut_records},
        {"micromap.view", &Rules::find_views},
        {"record.format", &Rules::lay_out},
        {"record.level_12", &Rules::lay_out},
        {"record.overlap", &Rules::lay_out},
        {"record.region", &Rules::lay_out},
        {"primitive.micromap", &Rules::first_micromap},
        {"primitive.base", &Rules::erase},
        {"indices.component", &Rules::unsigned_bytes},
        {"indices.normalized", &Rules::erase},
        {"indices.count", &Rules::cut_indices},
        {"align.index", &Rules::align},
        {"index.special", &Rules::drop_indices},
        {"index.range", &Rules::drop_indices},
    };
    const auto found = repairs.find(violation.rule);
    if (found == repairs.end()) return "";
    try {
      return (this->*found->second)(violation.pointer);
    } catch (const Json::exception&) {
      return "";  // a part that the repair needs is missing or of another type, which is a finding of its own
    } catch (const std::bad_optional_access&) {
      return "";  // indices that cannot be read, likewise
    }
  }

  std::string list_use(const std::string&) {
    json_["extensionsUsed"].push_back(micromap_extension);
    return "listed the extension";
  }

  std::string unlist_requirement(const std::string&) {
    Json& names = json_["extensionsRequired"];
    names.erase(std::remove(names.begin(), names.end(), micromap_extension), names.end());
    if (names.empty()) json_.erase("extensionsRequired");  // glTF has no empty lists
    return "took the extension out";
  }

  std::string erase(const std::string& pointer) {
    const Json::json_pointer at(pointer);
    json_.at(at.parent_pointer()).erase(at.back());
    return "took it out";
  }

  /// The micromap of a pointer; none if its views cannot be read.
  std::optional<std::size_t> readable_micromap(const std::string& pointer) {
    const auto number = number_behind(pointer, "micromaps");
    if (!number) return {};
    const Json& given = micromap_of(*number);
    const std::size_t views = member(json_, "bufferViews").size();
    for (const char* name : {"data", "triangles"})
      if (!whole(member(given, name), views)) return {};
    return number;
  }

  Json& micromap_of(std::size_t number) {
    return json_.at("extensions").at(micromap_extension).at("micromaps").at(number);
  }

  std::string count_records(const std::string& pointer) {
    const auto number = readable_micromap(pointer);
    if (!number) return "";
    const auto records = file_.view(micromap_of(*number).at("triangles").get<std::size_t>());
    for (std::uint64_t at = 0; at + micromap::record_bytes <= records.size(); at += micromap::record_bytes) {
      const micromap::Record record = micromap::record_at(records, at);
      if (record.level > 12 || record.format < 1 || record.format > 2)
        return size_records(*number, false);  // the counts are not at fault
    }
    if (records.size() < micromap::record_bytes) return "";
    // Usage counts that fit other levels of the records, and their bytes too, are right: the levels are wrong.
    if (const std::string did = size_records(*number, true); !did.empty()) return did;
    const Json before = micromap_of(*number);
    write_usage_counts(file_, *number);
    return before == micromap_of(*number) ? "" : "counted the records anew";
  }

  /// Takes a byteStride out; elements that lie apart are put together.
  std::string tighten(const std::string& pointer) {
    std::size_t size = 1, count = 0;
    std::size_t view = json_.at(Json::json_pointer(pointer)).get<std::size_t>();
    std::uint64_t offset = 0;
    if (pointer.ends_with("/triangles")) size = micromap::record_bytes;
    if (pointer.ends_with("/micromapIndices")) {
      const Json& accessor = json_.at("accessors").at(view);
      offset = accessor.value("byteOffset", std::uint64_t{0});
      const int type = accessor.at("componentType").get<int>();
      size = type < TINYGLTF_COMPONENT_TYPE_SHORT ? 1 : type < TINYGLTF_COMPONENT_TYPE_INT ? 2 : 4;
      count = accessor.at("count").get<std::size_t>();
      view = accessor.at("bufferView").get<std::size_t>();
    }
    const auto bytes = file_.view(view);
    if (!file_.is_alone(view, 0, bytes.size())) return "";
    Json& given = json_.at("bufferViews").at(view);
    const auto stride = given.at("byteStride").get<std::size_t>();
    const bool are_apart = size != 1 && stride > size && offset == 0 &&
                           (count == 0 || (count - 1) * stride + size <= bytes.size());
    if (are_apart) {
      Bytes tight;
      for (std::size_t at = 0; at + size <= bytes.size(); at += stride)
        tight.insert(tight.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                     bytes.begin() + static_cast<std::ptrdiff_t>(at + size));
      file_.replace(view, tight);
    }
    json_.at("bufferViews").at(view).erase("byteStride");
    return "took byteStride out";
  }

  std::string cut_records(const std::string& pointer) {
    const auto view = json_.at(Json::json_pointer(pointer)).get<std::size_t>();
    const auto bytes = file_.view(view);
    if (bytes.size() < micromap::record_bytes) return "";
    const std::size_t size = bytes.size() / micromap::record_bytes * micromap::record_bytes;
    if (file_.is_compressed(view))
      file_.replace(view, Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)));
    else
      json_.at("bufferViews").at(view)["byteLength"] = size;
    return "cut what is behind the last record";
  }

  /// Lays records out one after another, if their maps fill the data so; else gives them the levels and formats that
  /// fill the bytes between their offsets; else looks for other views.
  std::string lay_out(const std::string& pointer) {
    const auto number = readable_micromap(pointer);
    if (!number) return "";
    const std::vector<micromap::Record> before = records_of(*number);
    std::vector<micromap::Record> records = before;
    if (put_one_after_another(records, data_of(*number).size()))
      return records != before && write_records(*number, records) ? "laid the maps one after another" : "";
    const std::string did = size_records(*number, false);
    return did.empty() ? find_views(pointer) : did;
  }

  /// Gives the records the levels and formats that fill the bytes between their offsets.  `counted`: only if the usage
  /// counts are these.
  std::string size_records(std::size_t number, bool counted) {
    const std::vector<micromap::Record> records = records_of(number);
    const auto sized = sized_by_gaps(records, data_of(number).size());
    if (!sized || *sized == records) return "";
    if (counted && !are_micromap(micromap::record_buffer(*sized), data_of(number), micromap_of(number)))
      return "";
    if (!write_records(number, *sized)) return "";
    std::size_t changed = 0, first = 0;
    for (std::size_t r = records.size(); r-- > 0;)
      if (!(records[r] == (*sized)[r])) ++changed, first = r;
    return "gave record " + std::to_string(first) +
           (changed == 1 ? "" : " and " + std::to_string(changed - 1) + " more") +
           " the level and format that fill its bytes";
  }

  std::vector<micromap::Record> records_of(std::size_t number) {
    const auto bytes = file_.view(micromap_of(number).at("triangles").get<std::size_t>());
    std::vector<micromap::Record> records;
    for (std::uint64_t at = 0; at + micromap::record_bytes <= bytes.size(); at += micromap::record_bytes)
      records.push_back(micromap::record_at(bytes, at));
    return records;
  }
  std::span<const std::uint8_t> data_of(std::size_t number) {
    return file_.view(micromap_of(number).at("data").get<std::size_t>());
  }
  /// False if somebody else reads the records' bytes.
  bool write_records(std::size_t number, const std::vector<micromap::Record>& records) {
    const auto view = micromap_of(number).at("triangles").get<std::size_t>();
    if (!file_.is_alone(view, 0, file_.view(view).size())) return false;
    file_.overwrite(view, 0, micromap::record_buffer(records));
    return true;
  }

  /// Gives the records the offsets of maps without gaps, if these end where the data does.
  static bool put_one_after_another(std::vector<micromap::Record>& records, std::uint64_t data) {
    std::vector<micromap::Record> moved = records;
    std::uint64_t end = 0;
    for (micromap::Record& r : moved) {
      if (r.level > 12 || r.format < 1 || r.format > 2) return false;
      r.offset = static_cast<std::uint32_t>(end);
      end +=
          micromap::packed_bytes(micromap::micro_triangles(r.level), static_cast<micromap::Format>(r.format));
    }
    if (end != data) return false;
    records = moved;
    return true;
  }

  /// Links a micromap to views that nothing else reads, if one pair of them is records and data that keep all rules: a
  /// tool that renumbers views, and does not know the extension, leaves such.
  std::string find_views(const std::string& pointer) {
    constexpr std::size_t most = 64;
    const auto number = number_behind(pointer, "micromaps");
    if (!number) return "";
    Json& given = micromap_of(*number);
    const std::vector<std::size_t> views = file_.unread_views();
    std::vector<std::pair<std::size_t, std::size_t>> fitting;
    for (const std::size_t triangles : views)
      for (const std::size_t data : views)
        if (triangles != data && views.size() <= most &&
            are_micromap(file_.view(triangles), file_.view(data), given))
          fitting.emplace_back(triangles, data);
    if (fitting.size() != 1) return "";
    given["triangles"] = fitting[0].first;
    given["data"] = fitting[0].second;
    return "named bufferViews that nothing else reads";
  }

  /// Whether these are the records and data that a micromap's usage counts are about.
  static bool are_micromap(std::span<const std::uint8_t> records, std::span<const std::uint8_t> data,
                           const Json& given) try {
    std::vector<micromap::UsageCount> counts;
    for (std::size_t k = 0; k < given.at("usageCounts").size(); ++k)
      counts.push_back({given["usageCounts"][k].get<std::uint32_t>(),
                        given.at("usageLevels").at(k).get<std::uint32_t>(),
                        given.at("usageFormats").at(k).get<std::uint32_t>()});
    micromap::Input in;
    in.sets = micromap::glTF;
    in.records = records;
    in.record_count = in.records.size() / micromap::record_bytes;
    in.data = data;
    in.array_counts = counts;
    return in.record_count != 0 && micromap::validate(in).empty();
  } catch (const Json::exception&) {
    return false;  // no counts
  }

  std::string first_micromap(const std::string& pointer) {
    json_.at(Json::json_pointer(pointer).parent_pointer())["micromap"] = 0;
    return "named micromap 0";
  }

  std::string unsigned_bytes(const std::string& pointer) {
    Json& type = json_.at(Json::json_pointer(pointer));
    if (type != TINYGLTF_COMPONENT_TYPE_BYTE) return "";
    type = TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;  // special indices have the same bytes
    return "named unsigned bytes";
  }

  std::string cut_indices(const std::string& pointer) {
    const auto mesh = number_behind(pointer, "meshes"), number = number_behind(pointer, "primitives");
    const std::size_t accessor = json_.at(Json::json_pointer(pointer)).get<std::size_t>();
    std::size_t primitives = 0;
    for (const Json& one : member(json_, "meshes"))
      for (const Json& primitive : one.at("primitives"))
        primitives +=
            member(extension(primitive, micromap_extension), "micromapIndices") == Json(accessor) ? 1 : 0;
    if (primitives != 1) return "";
    const Json& primitive = json_.at("meshes").at(*mesh).at("primitives").at(*number);
    const Json& of =
        primitive.contains("indices") ? primitive["indices"] : primitive.at("attributes").at("POSITION");
    const auto triangles = json_["accessors"].at(of.get<std::size_t>()).at("count").get<std::size_t>() / 3;
    Json& count = json_["accessors"][accessor]["count"];
    if (count.get<std::size_t>() < triangles || triangles == 0) return "";
    count = triangles;
    return "cut the indices behind the last triangle's";
  }

  /// Copies indices to an aligned place.
  std::string align(const std::string& pointer) {
    Json& accessor = json_.at("accessors").at(json_.at(Json::json_pointer(pointer)).get<std::size_t>());
    const int type = accessor.at("componentType").get<int>();
    const std::size_t size = type < TINYGLTF_COMPONENT_TYPE_SHORT ? 1
                             : type < TINYGLTF_COMPONENT_TYPE_INT ? 2
                                                                  : 4;
    if (accessor.contains("sparse") || !accessor.contains("bufferView")) return "";
    const auto view = accessor["bufferView"].get<std::size_t>();
    const auto bytes = file_.view(view).subspan(accessor.value("byteOffset", std::size_t{0}),
                                                accessor.at("count").get<std::size_t>() * size);
    const Bytes copy(bytes.begin(), bytes.end());
    accessor["bufferView"] = file_.add_view(file_.buffer_of(view), copy);
    accessor.erase("byteOffset");
    return "copied the indices to an aligned place";
  }

  /// Makes indices that name no record the special index UO.
  std::string drop_indices(const std::string& pointer) {
    const auto mesh = number_behind(pointer, "meshes"), number = number_behind(pointer, "primitives");
    if (!mesh || !number) return "";
    Json& given = extension_of(file_, *mesh, *number);
    const Document document = file_.reopened(file_.written());
    const Buffers buffers(document);
    const auto records =
        file_.view(micromap_of(given.at("micromap").get<std::size_t>()).at("triangles").get<std::size_t>())
            .size() /
        micromap::record_bytes;
    std::vector<LinkedPrimitive> primitives = linked_primitives(file_, document, buffers);
    const auto primitive =
        std::find_if(primitives.begin(), primitives.end(),
                     [&](const LinkedPrimitive& one) { return one.mesh == *mesh && one.number == *number; });
    if (!primitive->accessor && primitive->base == 0) return "";
    // A base triangle that is too large moves all indices out.
    const auto greatest =
        std::max_element(primitive->codes.begin(), primitive->codes.end(),
                         [&](auto a, auto b) { return plain(*primitive, a) < plain(*primitive, b); });
    if (primitive->base != 0 && plain(*primitive, *greatest) <= records) {
      given.erase("micromapBaseTriangle");
      return "took the base triangle out";
    }
    if (!primitive->accessor) return "";
    std::size_t dropped = 0;
    for (std::size_t t = 0; t < primitive->codes.size(); ++t) {
      Code& code = primitive->codes[t];
      if (is_special(code)) continue;
      if (plain(*primitive, code) != 0 && plain(*primitive, code) + primitive->base <= records) continue;
      code = special(micromap::State::UO);
      all_.unlinked.push_back({*mesh, *number, t});
      ++dropped;
    }
    write_codes(file_, *primitive, primitives);
    return "set " + std::to_string(dropped) + (dropped == 1 ? " index that names" : " indices that name") +
           " no record to the special index UO, unknown";
  }

  /// The number behind a plain code; 0 for one that is none.
  static std::uint64_t plain(const LinkedPrimitive& primitive, Code code) {
    if (is_special(code)) return 0;
    const bool is_valid =
        !primitive.accessor || is_index(static_cast<std::uint32_t>(code), primitive.encoding);
    return is_valid ? static_cast<std::uint64_t>(code) + 1 : 0;
  }

  EditedFile& file_;
  Json& json_;
  RepairedRules all_;
  std::set<std::pair<std::string, std::string>> done_;
};

}  // namespace

RepairedRules repair_rules(EditedFile& file) { return Rules(file).repaired(); }

}  // namespace mmverify::scene
