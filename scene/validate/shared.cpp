#include "scene/validate/shared.hpp"

#include <vector>

#include "scene/read/bad_scene.hpp"
#include "scene/read/document.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

std::string of_primitive(const Json& primitive, const std::string& name, std::size_t accessor) {
  if (member(primitive, "indices") == accessor) return "the indices of " + name;
  for (const auto& [attribute, number] : primitive["attributes"].items())
    if (number == accessor) return "the " + shown(attribute) + " of " + name;
  for (const Json& target : member(primitive, "targets"))
    for (const auto& [attribute, number] : target.items())
      if (number == accessor) return "a morph target's " + shown(attribute) + " of " + name;
  return "";
}

/// Whether an accessor of the file reads a view: its elements, or those that it overrides.
bool reads(const Json& accessor, std::size_t view) {
  const Json& sparse = member(accessor, "sparse");
  return member(accessor, "bufferView") == view || member(member(sparse, "indices"), "bufferView") == view ||
         member(member(sparse, "values"), "bufferView") == view;
}

/// The elements of a member that nothing has checked; none if it is no array.
std::vector<Json> elements(const Json& object, const char* name) {
  const Json& array = member(object, name);
  return array.is_array() ? array.get<std::vector<Json>>() : std::vector<Json>();
}

/// The reader of an accessor that is no mesh: a skin or an animation.
std::string of_motion(const Json& document, std::size_t accessor) {
  const std::vector<Json> skins = elements(document, "skins"), animations = elements(document, "animations");
  for (std::size_t k = 0; k < skins.size(); ++k)
    if (member(skins[k], "inverseBindMatrices") == accessor) return "the matrices of " + place("skin", k);
  for (std::size_t k = 0; k < animations.size(); ++k)
    for (const Json& sampler : elements(animations[k], "samplers"))
      for (const char* end : {"input", "output"})
        if (member(sampler, end) == accessor)
          return std::string("an ") + end + " of " + place("animation", k);
  return "";
}

}  // namespace

std::string other_reader_of_view(const Json& document, std::size_t view) {
  for (const auto& [array, name] : {std::pair{"accessors", "accessor"}, {"images", "image"}}) {
    const Json& all = member(document, array);
    for (std::size_t k = 0; k < all.size(); ++k)
      if (reads(all[k], view)) return place(name, k) + "'s";
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
  return of_motion(document, accessor);
}

}  // namespace mmverify::scene
