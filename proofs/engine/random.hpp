// Samples that are the same on every machine: a seed, a stream, a number.
#pragma once

#include <cstdint>

namespace mmverify::proofs {

/// SplitMix64 (Steele, Lea, Flood 2014): small, seekable, and good enough to scatter test points.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream, std::uint64_t sample)
      : state_(mixed(mixed(seed) ^ mixed(stream + 0x632BE59BD9B4E019u)) ^ mixed(sample)) {}

  std::uint64_t next() { return mixed(state_ += 0x9E3779B97F4A7C15u); }

  /// In [0, limit).  The bias is below limit / 2^64.  Domain: limit in 1..2^32.
  std::uint64_t below(std::uint64_t limit) { return (next() >> 32) * limit >> 32; }

  /// In [first, last].
  std::int64_t between(std::int64_t first, std::int64_t last) {
    return first + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(last - first) + 1));
  }

 private:
  static constexpr std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
    x = (x ^ x >> 27) * 0x94D049BB133111EBu;
    return x ^ x >> 31;
  }
  std::uint64_t state_;
};

}  // namespace mmverify::proofs
