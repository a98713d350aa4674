// The changes that may explain wrong maps: of the inputs, and of the stored maps.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "proofs/scene/cause/inputs.hpp"

namespace mmverify::proofs::scene {

/// A baker that took other inputs.
struct InputChange {
  std::string code, says;
  std::function<void(Inputs&)> make;
};
/// The changes of inputs that change anything in this scene, the likelier ones first.
std::vector<InputChange> input_changes(const Judged& judged);

/// A baker, or a tool, that wrote the states otherwise.
struct MapChange {
  std::string code, says;
  /// The right state of micro-triangle k of a stored map.  Domain: 4^level states; k below their number.
  std::function<impl::micromap::State(const States&, Level, std::uint32_t k)> state;
  /// The right map of a stored one.  Domain: 4^level states.
  States undo(const States& map, Level n) const;
};
/// Exchanged states, and orders other than the curve's.
const std::vector<MapChange>& map_changes();

/// The map of a triangle whose vertex k is vertex order[k] of the stored map's.
States turned(const States& map, Level n, const mmverify::scene::VertexOrder& order);

}  // namespace mmverify::proofs::scene
