#include "scene/validate/micromaps.hpp"

#include <algorithm>
#include <cctype>

#include "scene/read/bad_scene.hpp"
#include "scene/validate/report.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

bool lists(const Json& json, const char* list, const char* name) {
  const Json& names = member(json, list);
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The pointer of the extension's first use; empty if there is none.
std::string first_use(const Json& json, const char* name) {
  const auto uses = [name](const Json& object) { return member(object, "extensions").contains(name); };
  const std::string tail = std::string("/extensions/") + name;
  if (uses(json)) return tail;
  const Json& meshes = member(json, "meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m)
    for (std::size_t p = 0; p < meshes[m]["primitives"].size(); ++p)
      if (uses(meshes[m]["primitives"][p]))
        return "/meshes/" + std::to_string(m) + "/primitives/" + std::to_string(p) + tail;
  return "";
}

bool names_opacity_micromaps(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name.find("opacity_micromap") != name.npos || name.find("opacitymicromap") != name.npos;
}

/// A name of opacity micromaps that is no draft's, of the root, a primitive or extensionsUsed; or empty.
std::string other_name(const Json& json) {
  const auto is_other = [](const std::string& name) {
    return names_opacity_micromaps(name) &&
           std::none_of(drafts.begin(), drafts.end(),
                        [&](const DraftText& d) { return name == d.extension; });
  };
  const auto on = [&](const Json& object) {
    for (const auto& [name, unused] : member(object, "extensions").items())
      if (is_other(name)) return shown(name);
    return std::string();
  };
  if (std::string name = on(json); !name.empty()) return name;
  for (const Json& mesh : member(json, "meshes"))
    for (const Json& primitive : mesh["primitives"])
      if (std::string name = on(primitive); !name.empty()) return name;
  for (const Json& name : member(json, "extensionsUsed"))
    if (is_other(name.get<std::string>())) return shown(name.get<std::string>());
  return "";
}

void validate_lists(const Json& json, Report& report) {
  const std::string use = first_use(json, report.extension());
  if (!use.empty() && !lists(json, "extensionsUsed", report.extension()))
    report.add("used.listed", "/extensionsUsed", "it is used at " + use + ", and not listed");
  if (report.newest() && lists(json, "extensionsRequired", report.extension()))
    report.add("required.unlisted", "/extensionsRequired",
               "it is listed, though the file renders the same without it");
}

/// A later minor version may be read as 2.0; what it adds is not judged.
void validate_version(const Json& json, Report& report) {
  const std::string& version = json["asset"]["version"].get_ref<const std::string&>();
  if (version != "2.0")
    report.add("file.newer", "/asset/version", "glTF " + shown(version) + " is judged by the rules of 2.0");
}

template <class Open>
std::vector<FileViolation> validated(const Open& open, Draft draft, const Target& target) {
  Report report(draft, target);
  try {
    const Document document = open();
    const Buffers buffers(document);
    validate_version(document.json, report);
    validate_lists(document.json, report);
    const std::vector<RecordCount> micromaps = validate_root(document, buffers, report);
    validate_primitives(document, buffers, micromaps, report);
  } catch (const UnreadVersion& unread) {
    report.add("file.version", "/asset", unread.what());
  } catch (const UnreadExtension& unread) {
    report.add("limits.extension", "", unread.what());
  } catch (const BadScene& bad) {
    report.add("file.readable", "", bad.what());
  }
  return report.taken();
}

template <class Open>
NamesUsed used(const Open& open) {
  try {
    const Document document = open();
    const auto by = [&document](Draft draft) {
      return !first_use(document.json, text(draft).extension).empty();
    };
    return {by(Draft::ext_2), by(Draft::khr), other_name(document.json)};
  } catch (const BadScene&) {
    return {};
  }
}

}  // namespace

std::vector<FileViolation> validate_micromaps(const std::string& file, Draft draft, const Target& target) {
  return validated([&] { return open_document(file); }, draft, target);
}

std::vector<FileViolation> validate_micromaps(const std::string& name, std::span<const unsigned char> bytes,
                                              Draft draft, const Target& target) {
  return validated([&] { return open_document(name, bytes); }, draft, target);
}

std::vector<FileViolation> validate_micromaps(const std::function<Document()>& open, Draft draft,
                                              const Target& target) {
  return validated(open, draft, target);
}

NamesUsed names_used(const std::string& file) {
  return used([&] { return open_document(file); });
}

NamesUsed names_used(const std::string& name, std::span<const unsigned char> bytes) {
  return used([&] { return open_document(name, bytes); });
}

}  // namespace mmverify::scene
