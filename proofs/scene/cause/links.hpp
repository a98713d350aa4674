// Maps that fit, but hang on other triangles.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "proofs/scene/cause/inputs.hpp"

namespace mmverify::proofs::scene {

/// A reading of the file's links under which triangles have other maps.
struct LinkChange {
  std::string code, says;
  /// The map of a triangle of the plan; none where the reading names none: the stored map stays.
  std::function<std::optional<mmverify::scene::BakedTriangle>(std::size_t triangle)> map;
};

/// Readings by one rule: offsets or indices that are all equal, another base triangle, another micromap, another
/// primitive's indices, the triangles in reverse.  Domain: `judged` outlives them.
std::vector<LinkChange> link_changes(const Judged& judged);

}  // namespace mmverify::proofs::scene
