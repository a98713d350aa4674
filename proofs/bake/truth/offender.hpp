// The micro-triangle that contradicts its state most, and where.
#pragma once

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

/// Whether a state O or T is wrong on an area of 0 only: it would be right for open micro-triangles.
bool is_tie(const Case& one, Level n, std::uint32_t index, State got);

/// The approximate share of a micro-triangle's area that contradicts its state O or T in one mip, by 256 evenly
/// spread places.  Domain: mip below the case's.
double wrong_share(const Case& one, Level n, std::uint32_t index, State got, std::uint32_t mip);

}  // namespace mmverify::proofs::bake
