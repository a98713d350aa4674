// Maps that fit, but hang on other triangles.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/scene/cause/inputs.hpp"

namespace mmverify::proofs::scene {

/// A reading of the file's links under which each triangle has another map.
struct LinkChange {
  std::string code, says;
  /// The maps by triangle of the plan; none: the special index that is stored, or a record that does not exist.
  std::vector<std::optional<mmverify::scene::BakedTriangle>> maps;
};

/// Readings by one rule: offsets or indices that are all equal, another base triangle, another micromap, another
/// primitive's indices, the triangles in reverse.  Domain: `fits(k, map)` says whether a map is right for triangle k.
std::vector<LinkChange> link_changes(const Judged& judged);

}  // namespace mmverify::proofs::scene
