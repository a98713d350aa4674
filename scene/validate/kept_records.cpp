#include "scene/validate/kept_records.hpp"

#include "scene/read/document.hpp"
#include "scene/record/bake_record.hpp"

namespace mmverify::scene {

std::map<PrimitivePlace, std::string> kept_records(const Document& document, Draft draft) {
  std::map<PrimitivePlace, std::string> records;
  const nlohmann::json& meshes = member(document.json, "meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m)
    for (std::size_t p = 0; p < meshes[m]["primitives"].size(); ++p) {
      const nlohmann::json& extras =
          member(extension(meshes[m]["primitives"][p], text(draft).extension), "extras");
      if (extras.is_object() && extras.contains(bake_record_name))
        records[{m, p}] = extras[bake_record_name].dump();
    }
  return records;
}

std::optional<int> recorded_states(const Document& document, Draft draft) {
  std::optional<int> all;
  for (const auto& [place, record] : kept_records(document, draft)) {
    const nlohmann::json read = nlohmann::json::parse(record);
    const nlohmann::json states = member(read, "states");
    if (states != 2 && states != 4) return {};
    if (all && *all != states.get<int>()) return {};
    all = states.get<int>();
  }
  return all;
}

}  // namespace mmverify::scene
