// Whether a file's EXT_mesh_opacity_micromap is as its draft says: JSON, bytes, and what refers to what.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/validate/draft.hpp"

namespace mmverify::scene {

/// A rule of the extension, or of glTF where the extension leans on it.
struct FileRule {
  const char* id;
  const char* says;
  const char* source;  ///< a heading of the draft, unless another text is named
};

/// All rules, each id once.  Those of records, counts and indices are impl/micromap/rules.hpp's.
std::span<const FileRule> file_rules();

struct FileViolation {
  std::string_view rule;  ///< an id of file_rules()
  std::string pointer;    ///< a JSON pointer into the document, of the property that is wrong
  std::string found;
};

/// "micromap.data: /extensions/EXT_mesh_opacity_micromap/micromaps/0/data: 9 is no index of the 3
/// bufferViews"
std::string describe(const FileViolation& violation);

/// Every violation, in the order of the document; empty for a file that keeps all rules, and for one without
/// the extension.
///   - Of one rule at one place the first eight are listed, then how many more there are.
///   - What cannot be read is not judged further: a file that is no glTF (rule file.readable) not at all.
///   - `draft`: whose rules.  Of the extension's other name nothing is looked at.
///   - glTF's other rules are not looked at; Khronos's gltf-validator knows those, and nothing of this
///   extension.
/// Domain: everything.  Linear in the file's bytes, and in the indices of all primitives; of those, beyond
/// 2^28, and of accessors without a bufferView beyond 2^22, a line (limits.indices) says that they were not
/// judged.
std::vector<FileViolation> validate_micromaps(const std::string& file, Draft draft = newest_draft);
std::vector<FileViolation> validate_micromaps(const std::string& name, std::span<const unsigned char> bytes,
                                              Draft draft = newest_draft);

/// Under which of the extension's two names a document uses it: EXT's and KHR's.
struct NamesUsed {
  bool ext = false, khr = false;
};
/// Of a file that cannot be read: neither.
NamesUsed names_used(const std::string& file);
NamesUsed names_used(const std::string& name, std::span<const unsigned char> bytes);

}  // namespace mmverify::scene
