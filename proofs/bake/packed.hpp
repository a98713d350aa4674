// Baked maps as bytes: states from the least significant bit of each byte on, as subjects/sdk/mmverify_subject.h has them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "proofs/bake/subject.hpp"

namespace mmverify::proofs::bake {

/// ceil(4^n b / 8).
std::size_t packed_bytes(Level n, Format format);

std::vector<std::uint8_t> packed(const std::vector<State>& states, Format format);

/// Domain: packed_bytes(n, format) bytes.
Baked unpacked(std::span<const std::uint8_t> bytes, Level n, Format format);

}  // namespace mmverify::proofs::bake
