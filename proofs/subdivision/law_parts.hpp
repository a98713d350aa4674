// Common parts of the laws of topic subdivision.
#pragma once

#include "proofs/engine/spoils.hpp"
#include "proofs/subdivision/checks.hpp"

namespace mmverify::proofs::subdivision {

inline constexpr char som_7[] =
    "Succinct Opacity Micromaps, 7: other dimensions, shapes and subdivision levels";
inline constexpr char library[] = "subdivision";
inline const std::vector<std::string> specified_and_library{"subdivision-spec", library}, fast_alone{library};

inline constexpr auto mutant = mutant_of<built_in_subjects>;

/// The reason why a law does not apply, if any: another topic, a missing entry point, a level beyond the subject's.
inline Unfit needing(std::vector<Entry> entries) {
  return unless_of_topic<SubdivisionSubject>(
      lacking<SubdivisionSubject>(std::move(entries), above_its_levels<SubdivisionSubject>));
}

/// A mutant: the corners of one cell are another's.
inline auto draws(Scheme scheme, Level level, std::uint64_t cell, std::uint64_t other) {
  return [=](Functions& f) {
    f.corners = [=, real = f.corners](Scheme s, Level n, std::uint64_t k) {
      return real(s, n, s == scheme && n == level && k == cell ? other : k);
    };
  };
}
/// The laws on whole schemes, and on the orientations of their cells.
std::vector<Law> scheme_laws();
/// The laws on the diagonal that cuts a tetrahedron's octahedron.
std::vector<Law> diagonal_laws();

}  // namespace mmverify::proofs::subdivision
