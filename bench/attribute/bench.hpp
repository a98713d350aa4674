// Attribute micromaps: the costs of lookups, remaps, bakes, mips and levels of detail, beside the costs and
// errors of the obvious ways.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/attribute/bake.hpp"
#include "bench/growth.hpp"

namespace mmverify::bench {

struct AttributeBenchOptions {
  std::uint32_t first = 1, last = 16;  ///< levels; maps end at level 12, bases of mips at 10, bakes at 6
  std::uint64_t samples = 1'000'000;   ///< points a level on which remaps and levels of detail are judged
  std::uint64_t seed = 1;              ///< of points, maps and textures
  std::size_t rounds = 11;             ///< of the timing; bakes have fewer
  std::size_t triangles = 256;         ///< triangles that are baked
  std::function<void(const std::string&)> progress = {};  ///< receives the name of each step that begins
};

/// Times below are of one thread, in ns an element; a ratio is the median of the rounds' ratios.

/// The times of an order of vertices, called one by one or in batches.
struct AttributeOrderTimes {
  std::string order;
  double index_ns = 0;          ///< from a vertex to its index
  double vertex_ns = 0;         ///< from an index to its vertex
  double triplet_ns = 0;        ///< from (u, v) to three indices
  double figure_4_to_ours = 0;  ///< the ratio for triplets
  /// The time from (u, v) to an RGBA8 value of a map of this order, if maps of the level are small enough.
  std::optional<double> lookup_ns, lookup_to_bilinear;
};

struct AttributeLookupLevel {
  std::uint32_t level = 0;
  double figure_4_ns = 0;                               ///< (u, v) to three indices, figure 4 in binary32
  std::optional<double> bilinear_ns, bilinear_simd_ns;  ///< a texture of 2^level texels a side
  std::vector<AttributeOrderTimes> orders;
};

/// The ways from barycentrics of the triangle to those of the micro-triangle, in binary32.
enum class Remap : std::uint8_t { cramer, two_equations, pattern, ours };
inline constexpr std::size_t remaps = 4;
inline constexpr std::array all_remaps{Remap::cramer, Remap::two_equations, Remap::pattern, Remap::ours};
const char* to_string(Remap remap);

/// The least weight whose error is counted in ulps.  A lesser weight is a difference of numbers near 1, so
/// its ulps do not measure the way.
inline constexpr double least_in_ulps = 0x1p-12;

struct RemapFigure {
  double ns = 0, least_ns = 0, most_ns = 0;  ///< a point: median, fastest and slowest round
  double worst = 0;  ///< the greatest error of a weight, which is an error in heights of the micro-triangle
  double worst_ulp = 0;  ///< the same in ulps of the right weight, of weights from `least_in_ulps` on
  std::optional<double> condition =
      {};  ///< in the 1-norm, of the system that the way solves, for the worst micro-triangle
  std::uint64_t no_number = 0;  ///< points with a weight that is not finite
};

struct RemapLevel {
  std::uint32_t level = 0;
  std::uint64_t samples = 0;
  std::array<RemapFigure, remaps> by{};

  const RemapFigure& of(Remap r) const { return by[static_cast<std::size_t>(r)]; }
};

struct MipTime {
  std::string way;
  double ns = 0;                ///< a value of the base
  double ratio_to_obvious = 0;  ///< the ratio of a mip in plain bytes to this, level by level
};
struct MipLevel {
  std::uint32_t level = 0;  ///< of the base
  std::vector<MipTime> ways;
};

struct LodFigure {
  std::string way;
  double ns = 0;
  std::uint64_t samples = 0, wrong = 0;  ///< pairs of areas near a change of level
};

struct AttributeFigures {
  std::vector<AttributeLookupLevel> lookups;
  std::vector<RemapLevel> remaps;
  std::array<Growth, bench::remaps> growth{};  ///< growth of a remap's worst error
  std::vector<AttributeBakeLevel> bakes;
  std::vector<MipLevel> mips;
  std::vector<LodFigure> lods;
};

/// The figures of all parts.  Throws std::invalid_argument unless samples, rounds and triangles are positive
/// and first <= last <= 16.
AttributeFigures attribute_figures(const AttributeBenchOptions& options = {});

// The figures of one part each, for a range of levels as above.
std::vector<AttributeLookupLevel> attribute_lookups(const AttributeBenchOptions& options);
std::vector<RemapLevel> attribute_remaps(const AttributeBenchOptions& options);
std::vector<MipLevel> attribute_mips(const AttributeBenchOptions& options);
std::vector<LodFigure> attribute_lods(const AttributeBenchOptions& options);

}  // namespace mmverify::bench
