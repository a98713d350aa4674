// bench tree|dag|vq|array|attribute --subject: a library's codec beside ours.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/codec/measure.hpp"
#include "bench/result.hpp"
#include "cli/bench/topics.hpp"
#include "subjects/dock/trusted.hpp"

namespace mmverify::cli {

/// Measures the library's codec of a topic, which is loaded into this process.
/// UsageError if the topic has no such bench, EnvironmentError if the library is no subject or lacks the entry points.
bench::Result codec_result(const std::string& topic, const BenchOptions& options);

namespace codec {

/// A request for the cases of a topic.
struct Asked {
  const mmverify_subject_t& subject;
  const BenchOptions& options;
  proofs::Levels levels;
  /// Receives each case when it is made, which is measured at once and then forgotten.
  std::function<void(const bench::CodecCase&)> take;
};

// Each throws std::runtime_error, naming the entry points, if the subject has none of them.
namespace of_tree {
void cases(const Asked& asked);
}
namespace of_dag {
void cases(const Asked& asked);
}
namespace of_vq {
void cases(const Asked& asked);
}
namespace of_array {
void cases(const Asked& asked);
}
namespace of_attribute {
void cases(const Asked& asked);
}

/// Random numbers below `end`, the same each time for a seed.
std::vector<std::uint32_t> random_below(std::uint32_t end, std::size_t count, std::uint64_t seed);

/// A code of at most `code.size()` bytes, or of more after it has grown.  Domain: encode(data, capacity) returns the
/// size that the code has or would have, as tree_encode of the header.
template <class Encode>
std::size_t encoded(std::vector<std::uint8_t>& code, Encode encode) {
  std::size_t size = encode(code.data(), code.size());
  if (size > code.size()) {
    code.resize(size);
    size = encode(code.data(), code.size());
  }
  return size;
}

/// The states of packed maps that differ.  Domain: spans of one length; `bits` a state.
std::uint64_t differing(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b,
                        unsigned bits);

}  // namespace codec
}  // namespace mmverify::cli
