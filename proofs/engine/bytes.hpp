// Bytes in cases and digests: their hash, and their text.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mmverify::proofs {

/// A hash for digests that depends on the order, the same on every machine.
/// Source: FNV-1a, 64 bits.
class Hash {
 public:
  void byte(std::uint8_t x) { value_ = (value_ ^ x) * 0x100000001B3u; }
  /// The bytes of x, low ones first.
  template <class Number>
  void number(Number x) {
    for (const std::uint8_t each : std::bit_cast<std::array<std::uint8_t, sizeof(Number)>>(x)) byte(each);
  }
  template <class Numbers>
  void numbers(const Numbers& all) {
    for (const auto x : all) number(x);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325u;
};

/// The hash of bytes, characters or states.
template <class Bytes>
std::uint64_t hash_of(const Bytes& bytes) {
  Hash hash;
  for (const auto each : bytes) hash.byte(static_cast<std::uint8_t>(each));
  return hash.value();
}

/// The bytes in hexadecimal, two digits each.
std::string hex(std::span<const std::uint8_t> bytes, std::string_view between = "");
/// The bytes of hexadecimal text; nothing unless it is pairs of the digits 0 to 9 and a to f.
std::optional<std::vector<std::uint8_t>> bytes_from_hex(std::string_view digits);

}  // namespace mmverify::proofs
