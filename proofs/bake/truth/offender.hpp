// The micro-triangle that contradicts its state most, and where.
#pragma once

#include <optional>
#include <vector>

#include "proofs/bake/truth/truth.hpp"

namespace mmverify::proofs::bake {

struct Offender {
  std::uint32_t index;
  State said, is;
  Extremes alpha;
};

/// Among the micro-triangles `at`, whose true states are `truth`: of those that are wrongly O or T the one
/// with alpha farthest on the other side of its threshold; without such the first that is wrongly unknown, or
/// unknown on the wrong side; none if all are right.
std::optional<Offender> worst(const Case& one, Level n, const std::vector<State>& got,
                              const std::vector<std::uint32_t>& at, const std::vector<State>& truth);

/// The point that contradicts the state: where alpha is least for O, greatest for T; for an unknown one
/// where it is least.
const Extreme& contradiction(const Offender& offender);

/// "1/3", of long ones the nearest decimal.
std::string text_of(const Rational& q);

}  // namespace mmverify::proofs::bake
