#include "scene/validate/sidecar.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <list>
#include <map>
#include <utility>

#include "scene/read/bad_scene.hpp"
#include "scene/read/file.hpp"
#include "scene/read/json_fault.hpp"
#include "scene/read/unique_names.hpp"
#include "scene/validate/members.hpp"
#include "scene/validate/target.hpp"
#include "scene/validate/vuids.hpp"

namespace mmverify::scene {
namespace {

namespace micromap = impl::micromap;
using Json = nlohmann::json;

constexpr std::uint64_t any = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t bits_32 = std::uint64_t{1} << 32;

struct Buffer {
  std::span<const unsigned char> bytes;
  std::uint64_t address = 0;
};

class Sidecar {
 public:
  Sidecar(const Beside& beside, Report& report) : beside_(beside), report_(report), members_(report) {}

  void judge(const Json& json) {
    members_.allow(json, "",
                   {"schema", "apis", "records", "data", "usageCounts", "geometries", "limits", "lossy"});
    micromap::Input array;
    bool good = apis(json, array);
    good &= limits(json, array);
    good &= records(json, array);
    apis_ = array.sets;
    if (is_null(json, "data")) {
      array.data = {};
    } else if (const auto buffer = buffer_of(json, "", "data", {"file", "offset", "bytes", "address"})) {
      array.data = buffer->bytes;
      array.data_address = buffer->address;
    } else {
      good = false;
    }
    array_counts_ = counts(json, "", good);
    if (array_counts_) array.array_counts = *array_counts_;
    std::vector<micromap::Input> geometries;
    if (json.contains("geometries")) {
      const Json& given = json["geometries"];
      if (!given.is_array()) {
        members_.type("/geometries", "an array", given);
        good = false;
      } else {
        for (std::size_t g = 0; g < given.size(); ++g)
          good &= geometry(given[g], "/geometries/" + std::to_string(g), geometries);
      }
    }
    if (good) validate_build(array, geometries, device_, report_);
  }

 private:
  bool apis(const Json& json, micromap::Input& in) {
    constexpr std::array<std::pair<const char*, micromap::Sets>, 4> known{
        {{"ext", micromap::EXT}, {"khr", micromap::KHR}, {"dxr", micromap::DXR}, {"gltf", micromap::glTF}}};
    if (!members_.there(json, "", "apis")) return false;
    const Json& given = json["apis"];
    if (!given.is_array() || given.empty()) {
      report_.add("sidecar.api", "/apis", "an array of at least one is due, not " + found(given));
      return false;
    }
    in.sets = 0;
    bool good = true;
    for (std::size_t k = 0; k < given.size(); ++k) {
      const auto one =
          std::find_if(known.begin(), known.end(), [&](const auto& api) { return given[k] == api.first; });
      if (one == known.end()) {
        report_.add("sidecar.api", "/apis/" + std::to_string(k),
                    found(given[k]) + " is none of ext, khr, dxr, gltf");
        good = false;
      } else {
        in.sets = static_cast<micromap::Sets>(in.sets | one->second);
      }
    }
    if (report_.target().apis != 0) in.sets = report_.target().apis;
    return good;
  }

  /// Whether a member says that there is no such buffer, as for the null micromap.
  static bool is_null(const Json& json, const char* name) {
    return json.contains(name) && json[name].is_null();
  }

  bool limits(const Json& json, micromap::Input& in) {
    bool good = members_.yes_or_no(json, "", "lossy", in.lossy);
    if (json.contains("limits")) {
      const std::optional<Device> own = read_device(json["limits"], "/limits", report_);
      good &= own.has_value();
      device_ = own.value_or(Device{});
    }
    device_ = report_.target().device.value_or(device_);
    in.limits = device_.limits;
    return good;
  }

  bool records(const Json& json, micromap::Input& in) {
    if (is_null(json, "records")) return true;
    const auto buffer =
        buffer_of(json, "", "records", {"file", "offset", "bytes", "address", "stride", "count"});
    if (!buffer) return false;
    const auto stride = members_.number(json["records"], "/records", "stride", micromap::record_bytes);
    if (!stride) return false;
    const std::uint64_t size = buffer->bytes.size();
    const std::uint64_t fit =
        *stride == 0 || size < micromap::record_bytes ? 0 : (size - micromap::record_bytes) / *stride + 1;
    const auto count = members_.number(json["records"], "/records", "count", fit, bits_32);
    if (!count) return false;
    in.records = buffer->bytes;
    in.records_address = buffer->address;
    in.record_stride = *stride;
    in.record_count = *count;
    return true;
  }

  /// The bytes that a member refers to.
  std::optional<Buffer> buffer_of(const Json& object, const std::string& at, const char* name,
                                  std::initializer_list<const char*> members) {
    if (!members_.there(object, at, name)) return {};
    const Json& json = object[name];
    const std::string pointer = at + "/" + name;
    if (!members_.is_object(json, pointer)) return {};
    members_.allow(json, pointer, members);
    if (!members_.there(json, pointer, "file")) return {};
    if (!json["file"].is_string()) {
      members_.type(pointer + "/file", "a string", json["file"]);
      return {};
    }
    const auto file = file_of(json["file"].get<std::string>(), pointer + "/file");
    const auto offset = members_.number(json, pointer, "offset", 0),
               address = members_.number(json, pointer, "address", 0);
    if (!file || !offset || !address) return {};
    const std::uint64_t left = *offset <= file->size() ? file->size() - *offset : 0;
    const auto bytes = members_.number(json, pointer, "bytes", left);
    if (!bytes) return {};
    if (*offset > file->size() || *bytes > left) {
      report_.add("sidecar.range", pointer,
                  std::to_string(*bytes) + " bytes from " + std::to_string(*offset) + " on of a file of " +
                      std::to_string(file->size()));
      return {};
    }
    return Buffer{file->subspan(static_cast<std::size_t>(*offset), static_cast<std::size_t>(*bytes)),
                  *address};
  }

  std::optional<std::span<const unsigned char>> file_of(const std::string& name, const std::string& pointer) {
    // A name is the same on every system: it has no drive and no backslash.
    if (!stays_within(name) || name.find_first_of("\\:") != std::string::npos) {
      report_.add("sidecar.path", pointer, shown(name) + " is no name in the sidecar's folder");
      return {};
    }
    if (const auto known = files_.find(name); known != files_.end()) return known->second;
    try {
      return files_.emplace(name, beside_(name)).first->second;
    } catch (const BadScene& bad) {
      report_.add("sidecar.file", pointer, bad.what());
      return {};
    }
  }

  /// The usage counts; none if the member is missing.  `good` becomes false if they cannot be read.
  std::optional<std::vector<micromap::UsageCount>> counts(const Json& object, const std::string& at,
                                                          bool& good) {
    if (!object.contains("usageCounts")) return {};
    const Json& given = object["usageCounts"];
    const std::string pointer = at + "/usageCounts";
    if (!given.is_array()) {
      members_.type(pointer, "an array", given);
      good = false;
      return {};
    }
    std::vector<micromap::UsageCount> all;
    for (std::size_t k = 0; k < given.size(); ++k) {
      const std::string one = pointer + "/" + std::to_string(k);
      if (!members_.is_object(given[k], one)) {
        good = false;
        continue;
      }
      members_.allow(given[k], one, {"count", "level", "format"});
      std::array<std::uint32_t, 3> values{};
      constexpr const char* names[] = {"count", "level", "format"};
      for (std::size_t c = 0; c < 3; ++c) {
        const auto value = members_.there(given[k], one, names[c])
                               ? members_.number(given[k], one, names[c], 0, bits_32)
                               : std::nullopt;
        good &= value.has_value();
        values[c] = static_cast<std::uint32_t>(value.value_or(0));
      }
      all.push_back({values[0], values[1], values[2]});
    }
    return all;
  }

  bool geometry(const Json& json, const std::string& at, std::vector<micromap::Input>& geometries) {
    if (!members_.is_object(json, at)) return false;
    members_.allow(json, at, {"triangles", "indices", "baseTriangle", "usageCounts"});
    micromap::Input in;
    bool good = members_.there(json, at, "triangles");
    const auto triangles = members_.number(json, at, "triangles", 0, bits_32),
               base = members_.number(json, at, "baseTriangle", 0, bits_32);
    good &= triangles && base;
    in.triangles = triangles.value_or(0);
    in.base_triangle = static_cast<std::uint32_t>(base.value_or(0));
    if (json.contains("indices") && !json["indices"].is_null()) good &= indices(json, at, in);
    if (auto given = counts(json, at, good))
      in.geometry_counts = geometry_counts_.emplace_back(std::move(*given));
    geometries.push_back(in);
    return good;
  }

  /// Index type NONE: triangle t has index t, and there is no buffer.
  void no_indices(const Json& given, const std::string& pointer) {
    members_.allow(given, pointer, {"type", "file", "offset", "bytes", "address", "stride"});
    if ((apis_ & (micromap::EXT | micromap::KHR)) == 0) return;
    for (const char* name : {"file", "address"})
      if (given.contains(name) && given[name] != 0)
        return report_.add("index.none", pointer + "/" + name, found(given[name]) + " for index type NONE",
                           vuids_of("index.none", apis_, cases::always));
  }

  bool indices(const Json& json, const std::string& at, micromap::Input& in) {
    if (const Json& one = json["indices"]; one.is_object() && one.contains("type") && one["type"] == "none") {
      no_indices(one, at + "/indices");
      return true;
    }
    const auto buffer =
        buffer_of(json, at, "indices", {"file", "offset", "bytes", "address", "stride", "type"});
    if (!buffer) return false;
    const Json& given = json["indices"];
    const std::string pointer = at + "/indices";
    if (!members_.there(given, pointer, "type")) return false;
    constexpr const char* types[] = {"u8", "u16", "u32", "i16", "i32"};
    const auto one =
        std::find_if(std::begin(types), std::end(types), [&](const char* t) { return given["type"] == t; });
    if (one == std::end(types)) {
      members_.type(pointer + "/type", "u8, u16, u32, i16, i32 or none", given["type"]);
      return false;
    }
    in.indexed = true;
    in.encoding = static_cast<micromap::Encoding>(one - std::begin(types));
    in.indices = buffer->bytes;
    in.indices_address = buffer->address;
    const auto stride = members_.number(given, pointer, "stride", micromap::width(in.encoding) / 8);
    in.index_stride = stride.value_or(0);
    return stride.has_value();
  }

  const Beside& beside_;
  Report& report_;
  const Members members_;
  Device device_;
  micromap::Sets apis_ = 0;
  std::map<std::string, Bytes> files_;
  std::optional<std::vector<micromap::UsageCount>> array_counts_;
  std::list<std::vector<micromap::UsageCount>> geometry_counts_;  ///< a list, since the inputs point into it
};

}  // namespace

void validate_sidecar(std::span<const unsigned char> bytes, const Beside& beside, Report& report) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) {
    report.add("sidecar.readable", "", json_fault(text));
    return;
  }
  if (!json.is_object()) {
    report.add("sidecar.readable", "", "an object is due, not " + found(json));
    return;
  }
  if (const auto twice = twice_named(text)) {
    report.add("sidecar.readable", *twice, "an object has two members of this name");
    return;
  }
  if (!json.contains("schema") || json["schema"] != "mmverify.array/1") {
    report.add("sidecar.schema", "/schema", json.contains("schema") ? found(json["schema"]) : "missing");
    return;
  }
  Sidecar(beside, report).judge(json);
}

}  // namespace mmverify::scene
