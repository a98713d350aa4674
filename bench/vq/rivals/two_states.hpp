// Maps of three states read as two, so that no hit reads the texture.
//
// Compressed Opacity Maps, 6: the map may be read so "by using the 2x2 vectors to determine hit/miss probabilities
// in combination with a hash of the hit's barycentric coordinate LSBs".  The paper gives neither the probability nor
// the hash; ours:
//   p(x, y) = (2 #O + #C) / 8    over the region's 2x2 regions from an even (x, y) on: C counts half
//   hash(u, v) in [0, 1)         of the 12 lowest bits of either binary32
//   opaque                       O; C if hash < p
#pragma once

#include <array>
#include <cstdint>

#include "bench/vq/rivals/prune.hpp"

namespace mmverify::bench::rivals {

/// The state that C is read as.  T and O are always read as they are.
enum class Reading : std::uint8_t {
  transparent,  ///< T
  opaque,       ///< O
  nearer,       ///< O where p > 1/2, else T
  even_hash,    ///< O where hash < 1/2
  vector_hash,  ///< O where hash < p
};
inline constexpr std::array all_readings{Reading::transparent, Reading::opaque, Reading::nearer,
                                         Reading::even_hash, Reading::vector_hash};
const char* to_string(Reading reading);

/// 8 p(x, y).  Domain: side even, x and y below it.
std::uint32_t opaque_eighths(States map, std::uint32_t side, std::uint32_t x, std::uint32_t y);

/// 2^32 hash(u, v).
std::uint32_t hit_hash(float u, float v);

/// Whether the hit at (u, v) of the map's square, in its region, is opaque.  Domain: u and v in [0, 1).
bool opaque(States map, std::uint32_t side, float u, float v, Reading reading);

}  // namespace mmverify::bench::rivals
