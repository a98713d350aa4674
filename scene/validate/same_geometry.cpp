#include "scene/validate/same_geometry.hpp"

#include <map>
#include <string>
#include <utility>

#include "scene/read/bad_scene.hpp"
#include "scene/read/document.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

struct Drawn {
  Json maps;  ///< the extension without its extras, or nothing
  std::string name;
};

void compare(const Json& document, const char* extension_name, std::vector<FileViolation>& findings) {
  std::map<std::pair<Json, Json>, Drawn> first;
  const Json& meshes = member(document, "meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m)
    for (std::size_t p = 0; p < meshes[m]["primitives"].size(); ++p) {
      const Json& primitive = meshes[m]["primitives"][p];
      Json maps = extension(primitive, extension_name);
      if (maps.is_object()) maps.erase("extras");
      const auto [drawn, is_first] =
          first.try_emplace({member(primitive, "attributes"), member(primitive, "indices")},
                            Drawn{maps, place("mesh", m) + " " + place("primitive", p)});
      if (!is_first && drawn->second.maps != maps)
        findings.push_back({"primitive.same_geometry",
                            "/meshes/" + std::to_string(m) + "/primitives/" + std::to_string(p),
                            "its attributes and indices are those of " + drawn->second.name +
                                ", its micromap or their indices are not"});
    }
}

}  // namespace

std::vector<FileViolation> same_geometry(const Document& document, Draft draft) {
  std::vector<FileViolation> findings;
  compare(document.json, text(draft).extension, findings);
  return findings;
}

}  // namespace mmverify::scene
