// What a wrong state amounts to: an area, or an edge alone.
#pragma once

#include "proofs/bake/truth/truth.hpp"

namespace mmverify::proofs::bake {

/// Whether a state that is O or T is wrong on an area of 0 alone: right where micro-triangles are open.
bool is_tie(const Case& one, Level n, std::uint32_t index, State got);

/// About which share of a micro-triangle's area contradicts a state that is O or T, in one mip: of 256 places spread
/// evenly.  Domain: mip below the case's.
double wrong_share(const Case& one, Level n, std::uint32_t index, State got, std::uint32_t mip);

}  // namespace mmverify::proofs::bake
