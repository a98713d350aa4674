// VQ2 and VQ4 beside the schemes that Compressed Opacity Maps, 3 and 6.1, only names, in the same bits; and
// the errors of maps of three states that are read as two (6).
//
// They are measured here and nowhere else: no library offers them and no law covers them, since the paper
// defines none of them far enough for a law.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/vq/maps.hpp"
#include "bench/vq/rivals/two_states.hpp"

namespace mmverify::bench::rivals {

/// The figures of one codec on all maps of 16x16 regions in 256 bits, or 32x32 in 512.
struct CodecFigures {
  std::uint32_t side = 0;
  const char* codec = "";
  std::uint32_t bits = 0;                ///< of a block, all that is stored
  std::uint64_t substitutions = 0;       ///< O and T that became C, of all maps
  std::uint64_t states = 0;              ///< O and T of the sources
  double savings = 0;                    ///< mean over the maps
  std::uint32_t whole = 0;               ///< maps that lost nothing
  std::vector<std::uint32_t> lost = {};  ///< substitutions, map by map
  std::optional<double> lossless_bits =
      {};                            ///< mean bits that a map needs to lose nothing; none if not known
  double encode_ms = 0;              ///< median over the maps
  double map_ns = 0, region_ns = 0;  ///< decoding a map, and one of random regions
};

/// The figures of one reading of maps as two states, over the hits of all maps.
struct ReadingFigures {
  Reading reading = {};
  double wrong = 0;  ///< share of hits with another state than the texture's
  double shade = 0;  ///< mean over the maps of | share read as opaque - share that is opaque |
};

/// The maps of one codec, read as two states.
struct ReadMaps {
  std::uint32_t side = 0;
  const char* map = "";
  std::uint64_t lost_t = 0, lost_o = 0;  ///< T and O that became C
  double checked = 0;                    ///< share of hits on C
  std::array<ReadingFigures, all_readings.size()> by{};
};

struct Figures {
  std::vector<CodecFigures> codecs;  ///< for each side VQ first
  std::vector<ReadMaps> read;
};

/// The figures of every codec on every map.  Each map comes back with its states or C, the same whole and
/// region by region.
/// Domain: not empty; rounds > 0.  Errors: std::runtime_error if a codec is wrong.
Figures figures(const std::vector<OpacityMaps>& maps, std::uint64_t seed, std::size_t rounds,
                const std::function<void(const std::string&)>& begins);

}  // namespace mmverify::bench::rivals
