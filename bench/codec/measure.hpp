// A codec of somebody else beside ours, on the same maps: size, loss, and times in alternating rounds.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "bench/timing.hpp"

namespace mmverify::bench {

/// The work of one codec in a round, on all maps of a row.  An entry point that the codec lacks is empty.
struct CodecWork {
  std::function<void()> encode = {};
  std::function<void()> decode = {};  ///< what `encode` made
  std::function<void()> look_up = {};
  std::function<double()> bits = {};  ///< all codes of a round, in bits
  /// States that came back otherwise, by decode or, without it, by look_up; or that a codec with loss gave up.
  std::function<std::uint64_t()> changed = {};
  std::function<std::uint64_t()> wrong_lookups =
      {};  ///< answers that are not the state of the code's own map
};

/// The maps of a row, and both codecs' work on them.
struct CodecCase {
  std::string of;                           ///< the kind of maps
  std::optional<std::uint32_t> level = {};  ///< none for blocks of square maps
  std::uint32_t states = 4;
  std::uint64_t maps = 1, micro_triangles = 1, lookups = 1;  ///< of a round; at least 1
  CodecWork theirs = {}, ours = {};
};

struct CodecFigures {
  double bits = 0;  ///< a micro-triangle
  std::uint64_t changed = 0;
  std::optional<std::uint64_t> wrong_lookups = {};
  Spread encode, decode, look_up;  ///< ns of a micro-triangle; of a lookup; all 0 without the entry point
};

struct CodecRow {
  CodecCase of;
  CodecFigures theirs = {}, ours = {};
  double encode_ratio = 0, decode_ratio = 0,
         look_up_ratio = 0;  ///< theirs / ours: the median of the rounds' ratios; 0 if one of them is absent
};

/// Measures a case.  Domain: rounds > 0.
CodecRow measured_codec(const CodecCase& of, std::size_t rounds);

}  // namespace mmverify::bench
