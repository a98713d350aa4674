#include "scene/validate/file.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "scene/read/bad_scene.hpp"
#include "scene/read/document.hpp"
#include "scene/validate/container.hpp"
#include "scene/validate/cutoffs.hpp"
#include "scene/validate/report.hpp"
#include "scene/validate/same_geometry.hpp"
#include "scene/validate/sidecar.hpp"
#include "scene/validate/stale_records.hpp"

namespace mmverify::scene {
namespace {

bool begins(std::span<const unsigned char> bytes, std::string_view with) {
  return bytes.size() >= with.size() && std::memcmp(bytes.data(), with.data(), with.size()) == 0;
}

/// The kind of a file by its outermost object's members.  If the JSON is damaged, the members before the
/// fault count.
class Outermost : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool is_sidecar() const { return schema_ || (build_ && !asset_); }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(std::int64_t) override { return true; }
  bool number_unsigned(std::uint64_t) override { return true; }
  bool number_float(double, const std::string&) override { return true; }
  bool string(std::string& value) override {
    schema_ |= depth_ == 1 && key_ == "schema" && value.starts_with("mmverify.array/");
    return true;
  }
  bool binary(nlohmann::json::binary_t&) override { return true; }
  bool start_array(std::size_t) override { return enter(); }
  bool end_array() override { return leave(); }
  bool start_object(std::size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool key(std::string& key) override {
    if (depth_ != 1) return true;
    key_ = key;
    asset_ |= key == "asset";
    build_ |= key == "records" || key == "apis";
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 private:
  bool enter() {
    ++depth_;
    return true;
  }
  bool leave() {
    --depth_;
    return true;
  }

  std::size_t depth_ = 0;
  std::string key_;
  bool schema_ = false, build_ = false, asset_ = false;
};

/// A sidecar's schema may be anywhere in it, since JSON may be damaged.  A sidecar with another schema has
/// members of a build, and lacks glTF's `asset`.
bool is_sidecar(std::span<const unsigned char> json) {
  constexpr std::string_view name = "\"mmverify.array/";
  if (std::search(json.begin(), json.end(), name.begin(), name.end()) != json.end()) return true;
  Outermost outermost;
  nlohmann::json::sax_parse(json.begin(), json.end(), &outermost);
  return outermost.is_sidecar();
}

FileKind known_kind(const std::string& name, std::span<const unsigned char> bytes) {
  if (const auto kind = kind_of(bytes)) return *kind;
  throw BadScene(name, "byte 0",
                 "neither JSON (glTF, or the sidecar of an array) nor GLB, MMARRAYS, mmtr, mmdg or mmat");
}

/// The document; none if it cannot be read: the validator of micromaps reports the reason.
std::optional<Document> opened(const std::function<Document()>& open) try {
  return open();
} catch (const BadScene&) {
  return {};
}

/// Judges a glTF file by the drafts whose extension it uses, or by `draft`, and reports a file without the
/// extension.
template <class Names, class Validate>
void judge_gltf(Judged& judged, std::optional<Draft> draft, const Names& names, const Validate& validate,
                const std::function<Document()>& open) {
  const NamesUsed used = names();
  const std::optional<Document> document = opened(open);
  const auto add_all = [&](const std::vector<FileViolation>& found) {
    judged.findings.insert(judged.findings.end(), found.begin(), found.end());
  };
  const auto judge = [&](Draft by) {
    judged.drafts.push_back(by);
    add_all(validate(by));
    if (!document) return;
    add_all(same_geometry(*document, by));
    add_all(stale_records(*document, by));
  };
  if (draft) {
    judge(*draft);
  } else {
    if (used.ext || !used.khr) judge(newest_draft);
    if (used.khr) judge(Draft::khr);
  }
  const auto add = [&](const char* code, const std::string& pointer, const std::string& found) {
    judged.findings.push_back({code, pointer, found});
  };
  if (!used.ext && !used.khr) {
    if (judged.count(Severity::advice) == judged.findings.size())
      add("file.no_micromaps", "",
          used.other.empty() ? "no object has the extension"
                             : "the file has " + used.other + "; " + text(newest_draft).extension + " and " +
                                   text(Draft::khr).extension + " are read");
  } else if (draft && !(*draft == Draft::khr ? used.khr : used.ext)) {
    add("draft.name", "/extensionsUsed",
        std::string("draft ") + text(*draft).name + " has " + text(*draft).extension + ", the file has " +
            text(used.khr ? Draft::khr : newest_draft).extension);
  }
  if (document) add_all(cutoffs_above_1(*document));
}

}  // namespace

std::optional<FileKind> kind_of(std::span<const unsigned char> bytes) {
  if (const auto kind = container_kind(bytes)) return kind;
  if (begins(bytes, "glTF")) return FileKind::gltf;
  auto at = bytes.begin();
  if (begins(bytes, "\xef\xbb\xbf")) at += 3;
  at = std::find_if(at, bytes.end(),
                    [](unsigned char c) { return c != ' ' && c != '\t' && c != '\n' && c != '\r'; });
  if (at == bytes.end() || *at != '{') return {};
  return is_sidecar(bytes) ? FileKind::sidecar : FileKind::gltf;
}

const char* name_of(FileKind kind) noexcept {
  constexpr const char* names[] = {"sidecar", "gltf", "array", "tree", "dag", "attributes"};
  return names[static_cast<std::size_t>(kind)];
}

std::uint64_t Judged::count(Severity severity) const {
  return static_cast<std::uint64_t>(
      std::count_if(findings.begin(), findings.end(),
                    [severity](const FileViolation& f) { return issue_of(f.rule).severity == severity; }));
}

Judged validate_file(const std::string& name, std::span<const unsigned char> bytes,
                     std::optional<Draft> draft, const Beside& beside, const Target& target) {
  Judged judged{known_kind(name, bytes)};
  if (judged.kind == FileKind::gltf) {
    judge_gltf(
        judged, draft, [&] { return names_used(name, bytes); },
        [&](Draft by) { return validate_micromaps(name, bytes, by, target); },
        [&] { return open_document(name, bytes); });
    return judged;
  }
  Report report(newest_draft, target);
  if (judged.kind == FileKind::sidecar)
    validate_sidecar(bytes, beside, report);
  else
    validate_container(judged.kind, bytes, report);
  judged.findings = report.taken();
  return judged;
}

Judged validate_file(const std::string& file, std::optional<Draft> draft, const Target& target) {
  const Bytes bytes = read_file(file, file, "");
  if (known_kind(file, bytes) == FileKind::gltf) {
    Judged judged{FileKind::gltf};
    judge_gltf(
        judged, draft, [&] { return names_used(file); },
        [&](Draft by) { return validate_micromaps(file, by, target); }, [&] { return open_document(file); });
    return judged;
  }
  const auto beside_it = [&](const std::string& name) {
    const std::filesystem::path path = in_folder_of(file, name, name);
    // A buffer may be empty: the null micromap has no records.
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error) && std::filesystem::is_empty(path, error))
      return Bytes();
    return read_file(path, file, name);
  };
  return validate_file(file, bytes, draft, beside_it, target);
}

}  // namespace mmverify::scene
