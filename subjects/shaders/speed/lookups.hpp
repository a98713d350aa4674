// The lookups whose speed is measured, each with the library's own answer.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace mmverify::shaders {

/// The inputs of a hit, numbered as kernels/inputs.glsl does.
enum class Inputs : std::uint32_t {
  points,         ///< u, v
  points_of_map,  ///< 0, u, v
  indices,        ///< a number on the curve, at the lookup's level
  square,         ///< x, y of a square of side 2^level
};

struct Lookup {
  std::string name;
  std::optional<std::uint32_t> level = {};  ///< none of blocks
  std::string file, entry_point;            ///< in shaders/
  Inputs inputs = Inputs::points;
  std::uint32_t side = 0;   ///< of a square: its level
  std::uint32_t first = 0;  ///< the push constant: bits of a state, or an order
  std::uint32_t words_in = 2, words_out = 1;
  std::vector<std::uint8_t> code = {};    ///< bytes that the kernel reads; may be empty
  std::uint32_t code_bytes = 0;           ///< without padding, where the kernel asks
  std::uint64_t random_states_bytes = 0;  ///< of a flat map, made on the device
  std::uint64_t most_hits = ~std::uint64_t{0};
  /// The library's answer, words_out words, for a hit's words_in words.
  std::function<void(const std::uint32_t* in, std::uint32_t* out)> right = {};
};

/// Word k of the device's random states, as kernels/inputs.glsl has it.
std::uint32_t random_states(std::uint32_t k);

/// The lookups at these levels: two indices, a flat map, a tree and a graph of a disc, attributes. Once each: blocks, the
/// paper's tree at level 8 at most, and, unless `is_processor`, a flat map of 256 MiB, more than a GPU's cache.
/// Domain: levels in 0..12, one at least.
std::vector<Lookup> lookups(const std::vector<std::uint32_t>& levels, bool is_processor);

/// The copy kernel of so many words a hit, in and out, as if it were a lookup at level 16, the hits' own.
/// Domain: 1 and 1, 2 and 1, 3 and 1, 2 and 3.
Lookup copy_of(std::uint32_t words_in, std::uint32_t words_out);

}  // namespace mmverify::shaders
