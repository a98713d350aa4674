#include "scene/validate/target.hpp"

#include <algorithm>

#include "scene/read/bad_scene.hpp"
#include "scene/read/file.hpp"
#include "scene/read/json_fault.hpp"
#include "scene/read/unique_names.hpp"
#include "scene/validate/members.hpp"

namespace mmverify::scene {

std::optional<Device> read_device(const nlohmann::json& given, const std::string& pointer, Report& report) {
  const Members members(report);
  if (!members.is_object(given, pointer)) return {};
  members.allow(given, pointer,
                {"twoStateLevel", "fourStateLevel", "lossyFourStateLevel", "triangles", "indexTypeUint8",
                 "disallowMixedSpecialIndex"});
  Device device;
  bool good = true;
  const auto level = [&](const char* name, std::uint32_t& to) {
    const auto value = members.number(given, pointer, name, to, std::uint64_t{1} << 32);
    if (value) to = static_cast<std::uint32_t>(*value);
    good &= value.has_value();
  };
  level("twoStateLevel", device.limits.two_state_level);
  level("fourStateLevel", device.limits.four_state_level);
  level("lossyFourStateLevel", device.limits.lossy_four_state_level);
  const auto triangles = members.number(given, pointer, "triangles", device.limits.triangles);
  if (triangles) device.limits.triangles = *triangles;
  good &= triangles.has_value();
  good &= members.yes_or_no(given, pointer, "indexTypeUint8", device.index_uint8);
  good &= members.yes_or_no(given, pointer, "disallowMixedSpecialIndex", device.disallow_mixed);
  if (!good) return {};
  return device;
}

Device read_device(const std::string& file) {
  const Bytes bytes = read_file(file, file, "the limits");
  const auto bad = [&](const std::string& pointer, const std::string& found) {
    throw BadScene(file, pointer.empty() ? "the limits" : pointer, found);
  };
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded()) bad("", json_fault(text));
  if (const auto twice = twice_named(text)) bad(*twice, "an object has two members of this name");
  Report report;
  const std::optional<Device> device = read_device(json, "", report);
  if (const auto findings = report.taken(); !findings.empty()) bad(findings[0].pointer, findings[0].found);
  return device.value();
}

}  // namespace mmverify::scene
