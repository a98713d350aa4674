// Links of primitives under which more of their triangles have a map that fits.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/scene/cause/cause.hpp"

namespace mmverify::proofs::scene {

/// A primitive's new link.
struct Relink {
  std::size_t primitive = 0;  ///< number in Scene::primitives
  std::size_t micromap = 0;
  std::uint64_t base = 0;
  std::optional<std::size_t> indices_of;  ///< the primitive whose indices it gets; none: its own
  std::string says;                       ///< "linked to micromap 1"
};

/// For each primitive the link under which most of a sample of its triangles fit their maps, corners turned or not, if
/// these are more than as it is and at least three of four: another micromap, another base triangle, another primitive's
/// micromap and indices.
/// Errors: exceptions of baking; Interrupted.
std::vector<Relink> relinks(const Judged& judged);

}  // namespace mmverify::proofs::scene
