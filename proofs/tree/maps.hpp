// The maps that the laws range over, and the text that names one on the command line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "proofs/engine/random.hpp"
#include "proofs/tree/subject.hpp"

namespace mmverify::proofs::tree {

/// All 2-state maps and, below level 2, all 4-state maps: 2 + 4, 16 + 256, 65,536.  Domain: n in 0..2.
constexpr std::uint64_t map_count(Level n) {
  const std::uint64_t two_state = std::uint64_t{1} << spec::micromap::micro_triangles(n);
  return n < 2 ? two_state + two_state * two_state : two_state;
}

/// Map k of them.  The 2-state ones come first.  Domain: k < map_count(n).
Map map_number(Level n, std::uint64_t k);

/// 4^16, the 4-state maps of level 2; map k has k's bits.
constexpr std::uint64_t four_state_maps_of_level_2 = std::uint64_t{1} << 32;
Map four_state_map_of_level_2(std::uint64_t k);

/// Maps of the kinds that trees meet: noise, a leaf's outline, uniform blocks of all sizes, neighbours that
/// all differ, and one micro-triangle unlike the others.  Both formats.  Sample k of a seed is the same
/// everywhere.
Map sample_map(Level n, std::uint64_t seed, std::uint64_t k);

/// The map in which neighbours on the curve differ, so that no siblings merge.
Map alternating_map(Level n, Format f);

/// "4-state:0123..." with a digit a micro-triangle up to level 4, above "4-state:sample:SEED:K".
std::string text_of_states(const Map& map);
std::string text_of_sample(const Map& map, std::uint64_t seed, std::uint64_t k);

/// "2-state:..." or "4-state:...": which, and what follows.  Throws BadCase.
std::pair<Format, std::string_view> format_and_rest(std::string_view text);

/// Throws BadCase, saying what is wrong with the text.
Map map_from_text(Level n, const std::string& text);

/// State of micro-triangle k.  Domain: k < 4^n.
inline std::uint8_t state_at(const Map& map, std::uint64_t k) {
  const unsigned b = bits(map.format);
  return static_cast<std::uint8_t>(map.packed[k * b / 8] >> k * b % 8 & (b == 1 ? 1 : 3));
}

}  // namespace mmverify::proofs::tree
