// Rows of texels to bits, by SIMD.  Internal to impl/bake.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mmverify::impl::bake::detail {

/// The bytes beyond those of a row that at_least() may write.
inline constexpr std::size_t bits_slack = 8;

/// Sets bit x of `bytes` if row[x] >= least; bits from width up to a whole byte are 0.
/// Texel: std::uint8_t or std::uint16_t.  Domain: ceil(width / 8) + bits_slack bytes can be written.
template <class Texel>
void at_least(const Texel* row, std::size_t width, std::int32_t least, std::uint8_t* bytes);

}  // namespace mmverify::impl::bake::detail
