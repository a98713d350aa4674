#include "scene/validate/stale_records.hpp"

#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "scene/read/bad_scene.hpp"
#include "scene/read/document.hpp"
#include "scene/read/load.hpp"
#include "scene/record/bake_record.hpp"

namespace mmverify::scene {
namespace {

/// A primitive by its mesh and its number there.
using PrimitivePlace = std::pair<std::size_t, std::size_t>;

std::map<PrimitivePlace, std::string> records_of(const nlohmann::json& document, const char* extension_name) {
  std::map<PrimitivePlace, std::string> records;
  const nlohmann::json& meshes = member(document, "meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m)
    for (std::size_t p = 0; p < meshes[m]["primitives"].size(); ++p) {
      const nlohmann::json& extras = member(extension(meshes[m]["primitives"][p], extension_name), "extras");
      if (extras.is_object() && extras.contains(bake_record_name))
        records[{m, p}] = extras[bake_record_name].dump();
    }
  return records;
}

}  // namespace

std::vector<FileViolation> stale_records(const Document& document, Draft draft) {
  std::vector<FileViolation> findings;
  try {
    const char* const name = text(draft).extension;
    const std::map<PrimitivePlace, std::string> records = records_of(document.json, name);
    if (records.empty()) return findings;
    const Scene scene = load(document);
    for (const Primitive& primitive : scene.primitives) {
      const auto record = records.find({primitive.mesh, primitive.number});
      if (record == records.end()) continue;
      std::string changes;
      for (const std::string& change : changes_since(record->second, scene, primitive))
        changes += (changes.empty() ? "" : "; ") + change;
      if (changes.empty()) continue;
      findings.push_back({"bake.stale",
                          "/meshes/" + std::to_string(primitive.mesh) + "/primitives/" +
                              std::to_string(primitive.number) + "/extensions/" + name + "/extras/" +
                              bake_record_name,
                          changes});
    }
  } catch (const BadScene&) {
    // The validator of micromaps reports the reason.
  } catch (const std::invalid_argument&) {
    // Another program's record.
  }
  return findings;
}

}  // namespace mmverify::scene
