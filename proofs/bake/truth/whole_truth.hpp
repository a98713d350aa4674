// The states of a case in whole numbers, as the laws on scenes judge them: compared with the rationals' by tests.
#pragma once

#include <optional>
#include <vector>

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

/// The width that states are found in: the narrowest of all, or one alone.
enum class WholeWidth : std::uint16_t { narrowest = 0, bits128 = 128, bits256 = 256, bits512 = 512 };

/// The states of some micro-triangles in whole numbers, by spec/bake/whole/state.hpp; none where these find none, and
/// for open micro-triangles.  The slack of a case's rules does not count.
std::vector<std::optional<spec::micromap::State>> whole_states(const Case& one, Level n,
                                                               const std::vector<std::uint32_t>& at,
                                                               WholeWidth width = WholeWidth::narrowest);

}  // namespace mmverify::proofs::bake
