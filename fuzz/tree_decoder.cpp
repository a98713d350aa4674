// The decoders on raw bytes: an error, or a map that is written back to the very same bytes.
//
// Input, read in three ways at once:
//   as a container, and as one whose checksum is corrected first, so that the reader reaches the bytes behind it;
//   as a stream: a byte of level (its remainder by 13), a byte whose lowest bit means four states and whose
//   rest, times 4 and plus 1, is the number of nodes, then the tree's bytes, then the states'.
//
// Covers: impl/tree/bits.hpp impl/tree/container.* impl/tree/decode.hpp impl/tree/stream.*
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <vector>

#include "impl/tree/container.hpp"
#include "impl/tree/stream.hpp"
#include "spec/tree/tree.hpp"

namespace {

namespace tree = mmverify::impl::tree;
namespace spec = mmverify::spec;
using Bytes = std::vector<std::uint8_t>;

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "tree_decoder: %s\n", what);
  std::abort();
}

void container(const Bytes& bytes) {
  const bool taken = tree::try_read(bytes).has_value();
  try {
    const tree::Contents contents = tree::read(bytes);
    require(tree::write(contents.level, contents.format, contents.map) == bytes,
            "a second container of one map");
    require(taken, "try_read refuses what read takes");
  } catch (const tree::BadContainer& bad) {
    require(!taken, "try_read takes what read refuses");
    require(bad.byte() <= bytes.size(), "the place named lies in the input");
  }
}

/// CRC-32C, a bit at a time.
std::uint32_t crc32c(const Bytes& bytes) {
  std::uint32_t crc = ~0u;
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    if (k >= 12 && k < 16) continue;
    crc ^= bytes[k];
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0x82f63b78u : crc >> 1;
  }
  return ~crc;
}

void stream(const std::uint8_t* data, std::size_t size) {
  const tree::Level n = data[0] % 13;
  const std::uint32_t b = 1 + (data[1] & 1);
  const auto bits = static_cast<tree::Format>(b);
  tree::Stream s;
  s.nodes = 4 * std::uint64_t{data[1] / 2u} + 1;
  s.leaves = (3 * s.nodes + 1) / 4;
  data += 2;
  size -= 2;
  const std::size_t split = std::min<std::size_t>(size, (s.nodes + 7) / 8);
  s.tree.assign(data, data + split);
  s.data.assign(data + split, data + size);
  // The map has exactly the announced size: a sanitizer sees any step beyond.
  const std::uint64_t count = std::uint64_t{1} << (2 * n);
  for (const std::uint64_t k : {std::uint64_t{0}, count / 3, count / 2, count - 1})
    require(tree::lookup_stream(n, bits, s, k) < 2 * b, "a state that the format lacks");
  Bytes map((count * b + 7) / 8);
  const bool good = tree::decode_stream(n, bits, s, map);
  if (good) require(tree::encode_stream(n, bits, map) == s, "a second stream of one map");
  if (n > 5) return;

  // The specification accepts the same streams and no others.
  const auto format = b == 1 ? spec::micromap::Format::two_state : spec::micromap::Format::four_state;
  Bytes all = s.tree;
  all.insert(all.end(), s.data.begin(), s.data.end());
  const auto exact = spec::tree::from_bytes(all, format);
  const auto expected = exact ? spec::tree::decode(*exact, n, format) : std::nullopt;
  if (good) require(expected.has_value(), "the specification refuses what decode_stream takes");
  // Sequences that end before the announced nodes are another stream to the specification.
  if (expected && exact->tree.size() == s.nodes)
    require(good, "decode_stream refuses what the specification takes");
  if (!good) return;
  for (std::uint64_t k = 0; k < count; ++k) {
    const std::uint32_t state = map[k * b / 8] >> (k * b % 8) & ((1u << b) - 1);
    require(static_cast<std::uint32_t>((*expected)[k]) == state, "not the specification's map");
    require(tree::lookup_stream(n, bits, s, k) == state, "a lookup that is not the map's state");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, data + size);
  container(bytes);
  if (size >= tree::container_header) {
    const std::uint32_t crc = crc32c(bytes);
    std::memcpy(bytes.data() + 12, &crc, sizeof crc);
    container(bytes);
  }
  if (size >= 2) stream(data, size);
  return 0;
}
