// Wrong states told apart: wrong on an area, or on an edge alone.
#pragma once

#include "proofs/bake/truth/truth.hpp"

namespace mmverify::proofs::bake {

/// Whether a state O or T is wrong on an area of 0 only: it would be right for open micro-triangles.
bool is_tie(const Case& one, Level n, std::uint32_t index, State got);

/// The approximate share of a micro-triangle's area that contradicts its state O or T in one mip, by 256 evenly
/// spread places.  Domain: mip below the case's.
double wrong_share(const Case& one, Level n, std::uint32_t index, State got, std::uint32_t mip);

}  // namespace mmverify::proofs::bake
