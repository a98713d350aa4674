#include "scene/validate/stale_records.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "scene/read/bad_scene.hpp"
#include "scene/read/document.hpp"
#include "scene/read/load.hpp"
#include "scene/record/bake_record.hpp"
#include "scene/validate/kept_records.hpp"

namespace mmverify::scene {
namespace {

/// Whether a record is of maps for every place that an animation moves the UVs to.
bool was_moving(const std::string& record) {
  return nlohmann::json::parse(record, nullptr, false).is_object() &&
         nlohmann::json::parse(record).contains("moving");
}

}  // namespace

std::vector<FileViolation> stale_records(const Document& document, Draft draft) {
  std::vector<FileViolation> findings;
  try {
    const char* const name = text(draft).extension;
    const std::map<PrimitivePlace, std::string> records = kept_records(document, draft);
    if (records.empty()) return findings;
    const Scene scene = load(document);
    for (const Primitive& primitive : scene.primitives) {
      const auto record = records.find({primitive.mesh, primitive.number});
      if (record == records.end()) continue;
      std::string changes;
      for (const std::string& change : changes_since(record->second, scene, primitive))
        changes += (changes.empty() ? "" : "; ") + change;
      if (changes.empty()) continue;
      if (was_moving(record->second)) changes += "; the maps were baked with --moving";
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
