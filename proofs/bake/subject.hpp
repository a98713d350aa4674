// A subject of topic bake: a baker of maps of base triangles, built in or in the dock.
#pragma once

#include "proofs/bake/mesh/mesh_case.hpp"
#include "proofs/bake/support.hpp"
#include "proofs/engine/topic.hpp"

namespace mmverify::proofs::bake {

using spec::micromap::State;

/// The formats with Vulkan's numbers.
enum class Format : std::uint8_t { two_state = 1, four_state = 2 };

struct Baked {
  std::vector<State> states;  ///< of all 4^n micro-triangles, in the order of the index
  bool padded = true;         ///< the bits after the last state are zeros
};

/// The baking function of a subject, and the rules that it follows.
struct Functions {
  static constexpr char topic[] = "bake";
  /// Nothing if the subject does not support the case.  Several threads may call at once.  Empty: it bakes meshes alone.
  std::function<std::optional<Baked>(const Case&, Level, Format)> bake = {};
  bool centroid = false;  ///< its unknown states are those of spec/bake/state.hpp, micro_state
  Support support = {};   ///< cases are drawn inside it
  bool tight = true;      ///< it promises that a state is unknown only if it has to be
  /// A whole mesh in one array; nothing if the subject does not support the case.
  std::function<std::optional<array::Answer>(const MeshCase&)> bake_mesh = {};
  bool own_levels = false;  ///< each map's level is bake_mesh's choice, up to the one that is asked for
  /// A baker answers for whole micro-triangles.
  bool exact_answers() const { return true; }
};

using BakeSubject = SubjectOf<Functions>;
using BakeSubjectPtr = std::shared_ptr<const BakeSubject>;

/// The specification bake-spec; this project's baker bake; and two that sample, centre-sample and corner-samples,
/// which bake.conservative refutes.
const std::vector<BakeSubjectPtr>& built_in_subjects();

inline constexpr auto built_in = built_in_of<built_in_subjects>;

/// A mutant's change to the states of a map in 4-state.
using Spoil = std::function<void(const Case&, Level, std::vector<State>&)>;

/// `base` with spoiled maps; a map in 2-state is forced from the spoiled one.
Mutant spoiled(const char* name, const std::string& base, Levels levels, const Spoil& spoil);
inline constexpr auto mutant = mutant_of<built_in_subjects>;

/// The subject that a library offers; null where it has no baker.  It runs in worker processes; what goes
/// wrong there comes out of the calls as SubjectBroken.
BakeSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

/// ceil(4^n b / 8).
std::size_t packed_bytes(Level n, Format format);

std::vector<std::uint8_t> packed(const std::vector<State>& states, Format format);

/// Domain: packed_bytes(n, format) bytes.
Baked unpacked(std::span<const std::uint8_t> bytes, Level n, Format format);

}  // namespace mmverify::proofs::bake
