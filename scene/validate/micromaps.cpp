#include "scene/validate/micromaps.hpp"

#include <algorithm>

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

void validate_lists(const Json& json, Report& report) {
  const std::string use = first_use(json, report.extension());
  if (!use.empty() && !lists(json, "extensionsUsed", report.extension()))
    report.add("used.listed", "/extensionsUsed", "it is used at " + use + ", and not listed");
  if (report.newest() && lists(json, "extensionsRequired", report.extension()))
    report.add("required.unlisted", "/extensionsRequired",
               "it is listed, though the file renders the same without it");
}

template <class Open>
std::vector<FileViolation> validated(const Open& open, Draft draft) {
  Report report(draft);
  try {
    const Document document = open();
    const Buffers buffers(document);
    validate_lists(document.json, report);
    const std::vector<RecordCount> micromaps = validate_root(document, buffers, report);
    validate_primitives(document, buffers, micromaps, report);
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
    return {by(Draft::ext_2), by(Draft::khr)};
  } catch (const BadScene&) {
    return {};
  }
}

}  // namespace

std::vector<FileViolation> validate_micromaps(const std::string& file, Draft draft) {
  return validated([&] { return open_document(file); }, draft);
}

std::vector<FileViolation> validate_micromaps(const std::string& name, std::span<const unsigned char> bytes,
                                              Draft draft) {
  return validated([&] { return open_document(name, bytes); }, draft);
}

std::vector<FileViolation> validate_micromaps(const std::function<Document()>& open, Draft draft) {
  return validated(open, draft);
}

NamesUsed names_used(const std::string& file) {
  return used([&] { return open_document(file); });
}

NamesUsed names_used(const std::string& name, std::span<const unsigned char> bytes) {
  return used([&] { return open_document(name, bytes); });
}

}  // namespace mmverify::scene
