#include "scene/validate/shared.hpp"

#include "scene/read/bad_scene.hpp"
#include "scene/read/document.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

std::string of_primitive(const Json& primitive, const std::string& name, std::size_t accessor) {
  if (member(primitive, "indices") == accessor) return "the indices of " + name;
  for (const auto& [attribute, number] : primitive["attributes"].items())
    if (number == accessor) return "the " + shown(attribute) + " of " + name;
  return "";
}

}  // namespace

std::string other_reader_of_view(const Json& document, std::size_t view) {
  for (const auto& [array, name] : {std::pair{"accessors", "accessor"}, {"images", "image"}}) {
    const Json& all = member(document, array);
    for (std::size_t k = 0; k < all.size(); ++k)
      if (member(all[k], "bufferView") == view) return place(name, k) + "'s";
  }
  return "";
}

std::string other_reader_of_accessor(const Json& document, std::size_t accessor) {
  const Json& meshes = member(document, "meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m)
    for (std::size_t p = 0; p < meshes[m]["primitives"].size(); ++p)
      if (std::string reader = of_primitive(meshes[m]["primitives"][p],
                                            place("mesh", m) + " " + place("primitive", p), accessor);
          !reader.empty())
        return reader;
  return "";
}

}  // namespace mmverify::scene
