// A case's texels in fewer columns, rows and mips, or stored in another way.
#pragma once

#include <cstdint>
#include <optional>

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

/// The number that is stored as `bits`, in another type: of what it cannot hold the nearest that it can.
std::uint32_t converted(Texel from, Texel to, std::uint32_t bits);

/// The case with the first columns and rows of each mip alone, its texels and its border converted.
/// None where it has fewer columns, rows or mips.
std::optional<Case> resized(Case one, std::uint32_t width, std::uint32_t height, std::uint32_t mips,
                            Texel texel);

}  // namespace mmverify::proofs::bake
