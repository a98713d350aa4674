// The maps that the laws range over, and the text that names one on the command line.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "proofs/engine/random.hpp"
#include "spec/tree/tree.hpp"

namespace mmverify::proofs::micromap {

using spec::micromap::bits;
using spec::micromap::Bytes;
using spec::micromap::Format;

/// A map, packed: 4^n states of the format.
struct Map {
  Level level = 0;
  Format format = Format::two_state;
  Bytes packed;
};

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

/// A map of one state but for one node of the curve: the 4^(n-depth) micro-triangles below node `node` of
/// that depth have the state `odd`.  Where both states are the same, the map is uniform.
struct OneApart {
  Format format = Format::two_state;
  std::uint8_t common = 0, odd = 0;
  Level depth = 0;
  std::uint64_t node = 0;
};

/// How many there are at a level: 6 uniform ones, and one for each ordered pair of states, 2 and 12, and each
/// node but the root.  6 + 14 (4^(n+1) - 4) / 3
constexpr std::uint64_t one_apart_count(Level n) {
  return 6 + 14 * ((spec::micromap::micro_triangles(n + 1) - 4) / 3);
}
/// Number k of them, the uniform ones first.  Domain: k < one_apart_count(n).
OneApart one_apart_number(Level n, std::uint64_t k);

/// Some of them, for levels with too many: up to level 7 each pair of states at the places where words of 16,
/// 32 and 64 states end, and the uniform ones; at level 8 each pair at one such place; above, eight maps.
std::uint64_t chosen_apart_count(Level n);
OneApart chosen_apart(Level n, std::uint64_t k);

Map map_of(Level n, const OneApart& apart);

/// Its code in the paper's form: an internal node for each of the `depth` nodes above, a leaf for each of
/// their other children, and one for the node.  The level does not show in it.
/// Domain: depth 0 for a uniform map.
Bytes code_of(const OneApart& apart);

/// "4-state:0+2@3:17": all 0, but 2 below node 17 of depth 3.  No text where it is something else; throws
/// BadCase where level n has no such node or the format no such state.
std::string text_of(const OneApart& apart);
std::optional<OneApart> apart_from_text(Level n, const std::string& text);

/// The map in which neighbours on the curve differ, so that no siblings merge.
Map alternating_map(Level n, Format f);

/// "4-state:0123..." with a digit a micro-triangle up to level 4, above "sample:SEED:K".
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

}  // namespace mmverify::proofs::micromap
