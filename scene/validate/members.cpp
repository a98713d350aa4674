#include "scene/validate/members.hpp"

#include <algorithm>

#include "scene/read/bad_scene.hpp"

namespace mmverify::scene {

using Json = nlohmann::json;

void Members::type(const std::string& pointer, const std::string& due, const Json& is) const {
  report_.add("sidecar.type", pointer, due + " is due, not " + found(is));
}

void Members::allow(const Json& object, const std::string& at,
                    std::initializer_list<const char*> names) const {
  for (const auto& [name, _] : object.items())
    if (std::find(names.begin(), names.end(), name) == names.end())
      report_.add("sidecar.unknown", at, "no member is called " + shown(name));
}

bool Members::is_object(const Json& json, const std::string& at) const {
  if (!json.is_object()) type(at, "an object", json);
  return json.is_object();
}

bool Members::there(const Json& object, const std::string& at, const char* name) const {
  if (!object.contains(name)) report_.add("sidecar.missing", at, std::string(name) + " is not there");
  return object.contains(name);
}

std::optional<std::uint64_t> Members::number(const Json& object, const std::string& at, const char* name,
                                             std::uint64_t otherwise, std::uint64_t end) const {
  if (!object.contains(name)) return otherwise;
  if (object[name].is_number_integer() && object[name] == 0) return 0;
  const auto value = whole(object[name], end);
  if (!value)
    type(at + "/" + name, "a whole number from 0, below " + std::to_string(end) + ",", object[name]);
  return value;
}

bool Members::yes_or_no(const Json& object, const std::string& at, const char* name, bool& to) const {
  if (!object.contains(name)) return true;
  if (!object[name].is_boolean()) {
    type(at + "/" + name, "true or false", object[name]);
    return false;
  }
  to = object[name].get<bool>();
  return true;
}

}  // namespace mmverify::scene
