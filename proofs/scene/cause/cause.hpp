// The cause of wrong maps: the one change under which all stored maps are right.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "scene/validate/stored_maps.hpp"

namespace mmverify::proofs::scene {

/// The maps of a file, and the inputs that they are judged by.
struct Judged {
  const mmverify::scene::Scene& scene;
  const mmverify::scene::StoredMaps& maps;
  float margin = 0;
  bool two_state = false;  ///< the maps were forced to 2-state
  /// The UVs of a primitive by another set or transform; empty where the file lacks the set.
  std::function<std::vector<mmverify::scene::Uv>(const mmverify::scene::Primitive&,
                                                 const mmverify::scene::BaseColorTexture&)>
      uvs = {};
  /// The end of the search for a cause; none: it takes as long as it takes.
  std::optional<std::chrono::steady_clock::time_point> until = {};
};

/// A command looks for a cause for so long; files of some million micro-triangles take a tenth of it.
inline constexpr std::chrono::seconds most_cause_time{30};

/// The end of a search that has no cause by Judged::until.
struct OutOfTime : std::runtime_error {
  OutOfTime() : std::runtime_error("the search for a cause ran out of time") {}
};

struct Cause {
  std::string code;             ///< stable: "corners", "v_flipped", ...
  std::string says;             ///< a sentence
  std::uint64_t wrong = 0;      ///< triangles whose stored maps are wrong or needlessly unknown
  std::uint64_t explained = 0;  ///< those among them that the change makes right
};

/// The cause, if one change of the list in docs/CAUSES.md makes all maps right.
///   right: each known state is that of the exact bake; few micro-triangles are needlessly unknown
/// No cause: the maps are right, or no single change explains them.
/// Domain: at least one triangle.  Errors: Interrupted; OutOfTime; exceptions of baking.
std::optional<Cause> cause_of(const Judged& judged);

/// The cause `unknown_side`, if most unknown states of right maps are on the other side than alpha at their centroids.
/// The search looks at some 2^18 micro-triangles.
/// Domain: at least one triangle; 4-state maps.  Errors: exceptions of baking.
std::optional<Cause> side_cause_of(const Judged& judged);

}  // namespace mmverify::proofs::scene
