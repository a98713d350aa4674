// Common parts of the laws of topic micromap: the check of a case, and the cases that it runs on.
#pragma once

#include "proofs/micromap/subject.hpp"

namespace mmverify::proofs::micromap {

inline constexpr char packing_source[] =
    "VkAccelerationStructureGeometryMicromapDataKHR; EXT_mesh_opacity_micromap, Microtriangle Data";
inline constexpr char lossy_source[] = "Vulkan's Opacity Micromaps (Vulkanised 2026), Lossy Micromaps";
inline constexpr char design_source[] = "this project's definition, docs/MICROMAP.md";

/// The map's bytes with every value of the bits after its last state.
std::vector<Bytes> with_paddings(const PackedMap& map);

/// Compares bytes; `what` names them.
Finding same(const char* what, const Bytes& expected, const Bytes& got);

/// The first finding that does not hold; otherwise one with all their answers.
template <class... Findings>
Finding all(const Finding& first, const Findings&... rest) {
  if (!first.holds) return first;
  if constexpr (sizeof...(rest) == 0) {
    return first;
  } else {
    Finding next = all(rest...);
    next.answer = next.answer * 31 + first.answer;
    return next;
  }
}

using Cases = CasesOf<MicromapSubject>;

/// The law on numbered cases.
Law on_cases(Law law, std::vector<Entry> entries, Cases cases);

using MapCheck = std::function<Finding(const MicromapSubject&, const PackedMap&)>;

/// A choice of maps: all 2-state maps of levels 0..2 and all 4-state maps of levels 0 and 1, or only the 4-state
/// ones.
enum class Maps { both_formats, four_state };

/// The entry points of a subject among packing, force-2-state, levels and modes, as ", of it packing, up"; empty if
/// it has them all.
std::string asked_of(const MicromapSubject& s);

/// A law on any of these entry points: it fits a subject that has at least one.
Law on_any_part(Law law);

/// The law on every map of the small levels, a case each.  `first`: its lowest level.
Law on_all_maps(Law law, std::vector<Entry> entries, Maps maps, Level first, MapCheck check);

/// The law on sample maps of each level from `fast.first`.  Without entries it fits a subject with any entry point
/// for packing, force-2-state, levels or modes.
Law on_samples(Law law, std::vector<Entry> entries, Maps maps, MapCheck check);

}  // namespace mmverify::proofs::micromap
