// The loss of opacity maps in block codecs, against the time that their encoders take.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/vq/maps.hpp"
#include "bench/vq/rivals/rivals.hpp"

namespace mmverify::bench {

struct VqBenchOptions {
  std::uint64_t seed = 1;     ///< of the generated maps, and of the hits
  std::size_t maps = 60;      ///< generated ones
  std::size_t rounds = 3;     ///< of the timing; at least 1
  std::string textures = {};  ///< a folder of alpha textures instead of generated maps
  std::function<void(const std::string&)> progress = {};  ///< receives the name of each step that begins
};

/// The encoders, in this order everywhere.  paper_highest_first and paper_free_c are Algorithms 1 and 2 in
/// the more favourable reading (impl/vq/vq.hpp); proved has a bound.
enum class Vq2Encoder : std::uint8_t { paper, paper_highest_first, optimal };
enum class Vq4Encoder : std::uint8_t { paper, paper_free_c, fast, balanced, thorough, proved };
inline constexpr std::size_t vq2_encoders = 3, vq4_encoders = 6;
const char* to_string(Vq2Encoder encoder);
const char* to_string(Vq4Encoder encoder);

/// The result of an encoder on one map.
struct VqEncoded {
  std::uint32_t substitutions = 0;
  std::uint32_t transforms = 0;      ///< of TR, BL and BR by their numbers in table 1, three bits each
  double ms = 0;                     ///< median over the rounds; proved has one round
  double least_ms = 0, most_ms = 0;  ///< of the fastest and the slowest round
};

/// The figures of one texture's maps.
struct VqRow {
  std::string of;
  std::uint32_t states_16 = 0, states_32 = 0;  ///< regions of O and T in the sources
  std::uint32_t discontinuous = 0;             ///< vectors of either map with O beside T
  std::array<VqEncoded, vq2_encoders> vq2{};
  std::array<VqEncoded, vq4_encoders> vq4{};
  std::uint32_t least = 0;  ///< the fewest substitutions that a block of VQ4 can have
  /// The savings of sources: the share of O and T.  64x2 fits 256 bits without a codec, 16x16 fits 512.
  double savings_64x2 = 0, savings_8 = 0, savings_16 = 0, savings_32 = 0;

  const VqEncoded& by(Vq2Encoder e) const { return vq2[static_cast<std::size_t>(e)]; }
  const VqEncoded& by(Vq4Encoder e) const { return vq4[static_cast<std::size_t>(e)]; }
  double savings(Vq2Encoder e) const { return savings_16 - by(e).substitutions / 256.0; }
  double savings(Vq4Encoder e) const { return savings_32 - by(e).substitutions / 1024.0; }
};

/// The times to decode blocks of the maps above, one thread.
struct VqDecodeTimes {
  double map_ns = 0, map_by_regions_ns = 0;  ///< a whole map at once, and region by region
  double region_ns = 0;                      ///< one of independent random hits over all blocks
};

struct VqFigures {
  std::vector<VqRow> rows;
  std::size_t left_out = 0;  ///< textures with no texel of alpha >= 1/2
  VqDecodeTimes vq2, vq4;
  rivals::Figures rivals;
};

/// The number of maps that chose each combination of transforms, the most frequent first.
std::vector<std::pair<std::uint32_t, std::size_t>> transform_counts(
    const std::vector<VqRow>& rows, const std::function<std::uint32_t(const VqRow&)>& chosen);

/// The figures of every encoder on every map.  Each block is decoded, and must be conservative and lose as
/// many regions as its encoder counts.
/// Throws std::invalid_argument unless maps > 0 and rounds > 0; std::runtime_error if a block is wrong, if no
/// texture has an opaque part, and as alpha_textures does.
VqFigures vq_figures(const VqBenchOptions& options = {});

}  // namespace mmverify::bench
