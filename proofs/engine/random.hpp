// Random numbers that are the same on every machine: by seed, stream and number.
#pragma once

#include <cstdint>

namespace mmverify::proofs {

/// SplitMix64 (Steele, Lea, Flood 2014): small, seekable, and good enough to scatter test points.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream, std::uint64_t sample)
      : state_(mixed(mixed(seed) ^ mixed(stream + 0x632BE59BD9B4E019u)) ^ mixed(sample)) {}

  std::uint64_t next() { return mixed(state_ += 0x9E3779B97F4A7C15u); }

  /// A number in [0, limit).  The bias is below limit / 2^64.  Domain: limit in 1..2^32.
  std::uint64_t below(std::uint64_t limit) { return (next() >> 32) * limit >> 32; }

  /// A number in [first, last].
  std::int64_t between(std::int64_t first, std::int64_t last) {
    return first + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(last - first) + 1));
  }

  /// A code of 8 bits; every other one is a corner value: 0, 1, 127, 128, 254 or 255.
  std::uint32_t code() {
    constexpr std::uint8_t corners[] = {0, 1, 127, 128, 254, 255};
    const std::uint64_t any = below(512);
    return any < 256 ? static_cast<std::uint32_t>(any) : corners[any % 6];
  }
  /// Four codes in a word, each drawn on its own.
  std::uint32_t four_codes() {
    std::uint32_t word = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) word |= code() << shift;
    return word;
  }

 private:
  static constexpr std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
    x = (x ^ x >> 27) * 0x94D049BB133111EBu;
    return x ^ x >> 31;
  }
  std::uint64_t state_;
};

/// A permutation of the numbers of `bits` bits, another one for each key.  Laws use different keys for the channels
/// of a word: each channel meets every number, and no channel determines another.
/// Each step can be undone: x ^ x >> h, and x times an odd number plus another, modulo 2^bits.
/// Domain: bits in 2..32; x below 2^bits.
constexpr std::uint32_t shuffled(std::uint32_t x, unsigned bits, std::uint32_t key) {
  const auto mask = static_cast<std::uint32_t>((std::uint64_t{1} << bits) - 1);
  for (std::uint32_t round = 1; round <= 2; ++round)
    x = ((x ^ x >> bits / 2) * 0x9E3779B1u + (key + round) * 0x85EBCA6Bu) & mask;
  return x ^ x >> bits / 2;
}

}  // namespace mmverify::proofs
