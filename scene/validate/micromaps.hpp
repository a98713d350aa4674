// The validator of a file's EXT_mesh_opacity_micromap against its draft: JSON, bytes, and references.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/validate/draft.hpp"
#include "scene/validate/target.hpp"

namespace mmverify::scene {

struct Document;

/// A rule of the extension, or of glTF if the extension depends on it.
struct FileRule {
  const char* id;
  const char* says;
  const char* source;  ///< a heading of the draft, unless it names another text
};

/// All rules, each id once.  The rules of records, counts and indices are those of impl/micromap/rules.hpp.
std::span<const FileRule> file_rules();

struct FileViolation {
  std::string_view rule;  ///< an id of file_rules()
  std::string pointer;    ///< the JSON pointer of the wrong property in the document
  std::string found;
  std::vector<std::string_view> vuids = {};  ///< Vulkan's identifiers of the broken rule: vuids.hpp
};

/// "micromap.data: /extensions/EXT_mesh_opacity_micromap/micromaps/0/data: 9 is no index of the 3
/// bufferViews"
std::string describe(const FileViolation& violation);

/// Every violation, in the order of the document; empty for a file that keeps all rules, and for one without
/// the extension.
///   - For one rule at one place the first eight are listed, then the number of the others.
///   - A part that cannot be read is not judged further, and a file that is no glTF (rule file.readable) not at all.
///   - `draft` names the rules.  Uses of the extension's other name are ignored.
///   - glTF's other rules are not checked; Khronos's gltf-validator knows those, and nothing of this extension.
///   - The rules of the target's APIs apply, too, to what a build gets: an engine may put a buffer at any address, and
///     hands over a signed index type as the unsigned one of its width.
/// Domain: everything.  Linear in the file's bytes, and in the indices of all primitives.  Indices beyond
/// 2^28 in all, and elements beyond 2^22 of an accessor without a bufferView, are not judged; a finding
/// (limits.indices) reports this.
std::vector<FileViolation> validate_micromaps(const std::string& file, Draft draft = newest_draft,
                                              const Target& target = {});
std::vector<FileViolation> validate_micromaps(const std::string& name, std::span<const unsigned char> bytes,
                                              Draft draft = newest_draft, const Target& target = {});

/// The violations of the document that `open` returns; its BadScene is a finding.
std::vector<FileViolation> validate_micromaps(const std::function<Document()>& open,
                                              Draft draft = newest_draft, const Target& target = {});

/// The names of the extension that a document uses: EXT's and KHR's.
struct NamesUsed {
  bool ext = false, khr = false;
  std::string other;  ///< a name of opacity micromaps that is neither, such as NV_opacity_micromap; or empty
};
/// The names used by a file; none if it cannot be read.
NamesUsed names_used(const std::string& file);
NamesUsed names_used(const std::string& name, std::span<const unsigned char> bytes);

}  // namespace mmverify::scene
