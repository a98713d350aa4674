// The table of a codec of somebody else beside ours.
#pragma once

#include <string>
#include <vector>

#include "bench/codec/measure.hpp"
#include "bench/result.hpp"

namespace mmverify::bench {

/// The two codecs of a table.
struct CodecBench {
  std::string library, ours;  ///< ours: the name of our codec
  std::size_t rounds = 0;
};

Result codec_tables(const std::vector<CodecRow>& rows, const CodecBench& bench);

}  // namespace mmverify::bench
