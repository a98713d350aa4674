#include "bench/tree/obvious.hpp"

#include <algorithm>

namespace mmverify::bench {
namespace {

using impl::tree::Format;
using impl::tree::Level;
using impl::tree::Stream;

std::uint32_t get(std::span<const std::uint8_t> bytes, std::uint64_t k, std::uint32_t b) {
  const std::uint64_t bit = k * b;
  return bytes[bit / 8] >> (bit % 8) & ((1u << b) - 1);
}

void set(std::span<std::uint8_t> bytes, std::uint64_t k, std::uint32_t b, std::uint32_t state) {
  const std::uint64_t bit = k * b;
  const auto mask = static_cast<std::uint8_t>(((1u << b) - 1) << (bit % 8));
  bytes[bit / 8] = static_cast<std::uint8_t>((bytes[bit / 8] & ~mask) | state << (bit % 8));
}

void append(std::vector<std::uint8_t>& bytes, std::uint64_t k, std::uint32_t b, std::uint32_t state) {
  const std::uint64_t bit = k * b;
  if (bit % 8 == 0) bytes.push_back(0);
  bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] | state << (bit % 8));
}

struct Encoder {
  std::span<const std::uint8_t> map;
  std::uint32_t b;
  Stream s{};

  void node(std::uint64_t first, std::uint64_t count) {
    const std::uint32_t state = get(map, first, b);
    std::uint64_t k = 1;
    while (k < count && get(map, first + k, b) == state) ++k;
    if (k == count) {
      append(s.tree, s.nodes++, 1, 0);
      append(s.data, s.leaves++, b, state);
      return;
    }
    append(s.tree, s.nodes++, 1, 1);
    for (std::uint64_t child = 0; child < 4; ++child) node(first + child * count / 4, count / 4);
  }
};

struct Decoder {
  const Stream& s;
  std::span<std::uint8_t> map;
  std::uint32_t b;
  std::uint64_t t = 0, d = 0;

  void node(std::uint64_t first, std::uint64_t count) {
    if (get(s.tree, t++, 1) == 0) {
      const std::uint32_t state = get(s.data, d++, b);
      for (std::uint64_t k = 0; k < count; ++k) set(map, first + k, b, state);
      return;
    }
    for (std::uint64_t child = 0; child < 4; ++child) node(first + child * count / 4, count / 4);
  }
};

}  // namespace

Stream obvious_encode(Level n, Format b, std::span<const std::uint8_t> map) {
  Encoder encoder{map, static_cast<std::uint32_t>(b)};
  encoder.node(0, std::uint64_t{1} << (2 * n));
  return std::move(encoder.s);
}

void obvious_decode(Level n, Format b, const Stream& s, std::span<std::uint8_t> map) {
  // A map shorter than a byte has padding bits.
  std::fill(map.begin(), map.begin() + 1, std::uint8_t{0});
  Decoder{s, map, static_cast<std::uint32_t>(b)}.node(0, std::uint64_t{1} << (2 * n));
}

}  // namespace mmverify::bench
