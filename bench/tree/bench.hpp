// Size against time of the forms of a map: flat, the paper's stream, ours, and the same tree over sdsl.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "impl/tree/stream.hpp"

namespace mmverify::bench {

struct TreeBenchOptions {
  std::uint32_t first = 3, last = 12;  ///< levels, both included; last at most 12
  std::uint64_t seed = 1;              ///< of the maps and of the lookups
  std::size_t rounds = 5;              ///< of the timing; at least 1
  std::uint64_t lookups = 1'000'000;   ///< a round; the paper's algorithm makes fewer if it is slow
  std::string textures = {};           ///< a folder of alpha textures instead of generated maps
  std::function<void(const std::string&)> progress = {};  ///< receives the name of each step that begins
};

/// The forms, in this order everywhere.
enum class TreeForm : std::uint8_t { flat, paper, ours, sdsl };
inline constexpr std::size_t tree_forms = 4;
const char* to_string(TreeForm form);

struct TreeFormFigures {
  double bits = 0;  ///< a micro-triangle, all memory of the form; for paper its two sequences alone
  double ns = 0;    ///< a lookup, over independent random ones on all maps; median over the rounds
  double least_ns = 0, most_ns = 0;  ///< the same of the fastest round and of the slowest
  double chained_ns = 0;             ///< a lookup that waits for the one before
  double lines = 0;  ///< 64-byte lines of the form's arrays that a lookup reads, by a model, mean
};

/// The figures of one level and format.
struct TreeFigures {
  std::uint32_t level = 0;
  std::uint32_t bits = 0;  ///< a state, 1 or 2
  std::size_t maps = 0;
  std::array<TreeFormFigures, tree_forms> forms{};
  double paper_over_ours = 0, sdsl_over_ours = 0, ours_over_flat = 0;  ///< ns; medians of each round's ratio
  double memory_over_paper = 0;                                        ///< ours / paper, in bits
  double nodes = 0;                                                    ///< of the paper's tree, mean
  double bits_read = 0;  ///< bits of the paper's tree that its lookup reads, mean
  // Times of whole maps: mean ns a map, medians over the rounds.
  double obvious_encode = 0, encode_stream = 0, encode_tree = 0;
  double obvious_decode = 0, decode_stream = 0, decode_tree = 0;

  const TreeFormFigures& form(TreeForm f) const { return forms[static_cast<std::size_t>(f)]; }
};

/// The number of generated maps of a level: 1,024 up to level 9, and as many as fill 64 MiB beyond.
std::size_t tree_map_count(std::uint32_t level, impl::tree::Format bits);

/// Measures one set of maps of one level and format; every form's answers are compared on the way.
/// Throws std::runtime_error if two forms disagree.
TreeFigures measure_trees(std::uint32_t level, impl::tree::Format bits,
                          const std::vector<std::vector<std::uint8_t>>& maps,
                          const TreeBenchOptions& options);

/// Measures both formats at each level, on leaf_map's maps or on those of the textures.
/// Throws std::invalid_argument unless first <= last <= 12, rounds > 0 and lookups > 0; std::runtime_error as
/// alpha_textures does.
std::vector<TreeFigures> tree_figures(const TreeBenchOptions& options = {});

}  // namespace mmverify::bench
