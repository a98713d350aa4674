// The errors of bakers, against the time that they take.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/bake/updates.hpp"
#include "bench/textures/alpha_textures.hpp"
#include "bench/timing.hpp"

namespace mmverify::bench {

struct BakeBenchOptions {
  std::uint32_t first = 3, last = 9;                      ///< levels
  std::uint64_t seed = 1;                                 ///< of the generated textures
  std::size_t maps = 6;                                   ///< generated textures
  std::size_t rounds = 3;                                 ///< of the timing of ours; at least 1
  int largest = 1024;                                     ///< the last of the sizes from 64 on
  std::string textures = {};                              ///< a folder of alpha textures instead
  std::function<void(const std::string&)> progress = {};  ///< receives the name of each step that begins
};

/// The bakers, in this order everywhere.
enum class Baker : std::uint8_t { centre, corners, sixteen_samples, rasterised, ours, rational };
inline constexpr std::size_t bakers = 6;
const char* to_string(Baker baker);

/// The figures of one baker on all triangles of one level, compared with the exact states.
struct BakeFigure {
  std::uint64_t micro_triangles = 0;  ///< micro-triangles judged: all, for `rational` a sample
  std::uint64_t wrong = 0;            ///< O or T, but not on the whole micro-triangle
  std::uint64_t needless = 0;         ///< unknown, but one state on the whole micro-triangle
  double ns = 0;                      ///< a micro-triangle, without the preparation of the texture
  /// The same of the fastest and the slowest round of each triangle; of bakers that run once, ns.
  double least_ns = 0, most_ns = 0;

  void add(const Spread& of_a_triangle) {
    ns += of_a_triangle.median;
    least_ns += of_a_triangle.least;
    most_ns += of_a_triangle.most;
  }
  double wrong_per_million() const;
  double needless_per_million() const;
};

struct BakeLevel {
  std::uint32_t level = 0;
  std::array<BakeFigure, bakers> by{};
  double unknown = 0;   ///< unknown micro-triangles over all, exactly
  double exact = 0;     ///< the share of our leaves that took whole numbers
  double whole_ns = 0;  ///< a micro-triangle by spec/bake/whole, of those that the rationals judge

  double rational_over_whole() const { return of(Baker::rational).ns / whole_ns; }
  const BakeFigure& of(Baker b) const { return by[static_cast<std::size_t>(b)]; }
};

/// The times of our baker at one level over textures of one size.
struct BakeSize {
  int size = 0;
  double ns = 0, ready_ms = 0;  ///< a micro-triangle, and the preparation of a texture
  double ns_rasterised = 0;
};

/// The figures of our baker at one level with a margin.
struct BakeMargin {
  float texels = 0;
  double unknown = 0, ns = 0;
};

struct BakeFigures {
  std::vector<std::string> textures;
  std::vector<BakeLevel> levels;
  std::vector<BakeSize> sizes;      ///< at level 6, of generated textures
  std::vector<BakeMargin> margins;  ///< at level 6
  std::vector<BakeUpdate> updates;
  std::uint64_t compared = 0;  ///< our states that were compared with the specification's, all equal
};

/// The figures over both halves of each texture's unit square, repeated, bilinear, cutoff 1/2.
/// Throws std::invalid_argument unless maps > 0, rounds > 0 and 0 <= first <= last <= 12; std::runtime_error
/// if a state of ours, or one in whole numbers, differs from the specification's, and as alpha_textures does.
BakeFigures bake_figures(const BakeBenchOptions& options = {});

}  // namespace mmverify::bench
