// The way from a file's stored maps to right ones, triangle by triangle.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "proofs/scene/cause/cause.hpp"

namespace mmverify::proofs::scene {

/// A planned triangle's repair.
struct MapRepair {
  enum class Kind {
    none,   ///< the stored map is right
    found,  ///< the right map is the stored one, or another of the file, turned or recoded
    baked,  ///< nothing in the file becomes the right map: it has to be baked
  };
  Kind kind = Kind::none;
  mmverify::scene::BakedTriangle map;  ///< the right one; for `none` empty
  std::string did;                     ///< "turned by 1 corner"; for `baked` empty
  bool may_stay = false;  ///< `baked`, and the stored special index, unknown, is not wrong either
};

/// The repair of each planned triangle.  What is tried on a wrong map, in this order: its corners turned, exchanged states
/// or another order (one change for each micromap), the other maps of its micromap, those of others, a special index; where
/// it is a special index, another one comes first.
/// A map whose unknown states are all on the other side is right, unless those of its whole micromap are.
/// `unlinked`: planned triangles whose index named no record, and is the special index UO instead: they get a map if
/// there is one.
/// Errors: exceptions of baking; Interrupted.
std::vector<MapRepair> map_repairs(const Judged& judged, const std::set<std::size_t>& unlinked = {});

}  // namespace mmverify::proofs::scene
