// Repairs of broken rules that the file's own data suffice for.
#pragma once

#include <string>
#include <vector>

#include "scene/edit/edited_file.hpp"
#include "scene/validate/micromaps.hpp"

namespace mmverify::scene {

struct RuleRepair {
  std::string rule;     ///< a code of docs/ISSUES.md
  std::string pointer;  ///< the JSON pointer of its finding
  std::string did;      ///< a sentence's end: "counted the records"
};

/// A triangle of a file.
struct TriangleOfFile {
  std::size_t mesh = 0, number = 0;  ///< meshes[mesh].primitives[number]
  std::size_t triangle = 0;
};

struct RepairedRules {
  std::vector<RuleRepair> repairs;
  std::vector<FileViolation> left;       ///< findings for which there is no repair
  std::vector<TriangleOfFile> unlinked;  ///< triangles whose index named no record, and is UO now
};

/// Repairs what validate_micromaps() finds: usage counts, lists of extensions, strides, alignment, padding, indices that
/// name no record.  Such an index becomes the special index UO, and a base triangle or micromap that cannot be read
/// becomes 0; the maps have to be judged afterwards.
/// Errors: BadScene.
RepairedRules repair_rules(EditedFile& file);

}  // namespace mmverify::scene
