// The parts of topic vq's foreign subjects, each with its rows; and the blocks that they share.
#pragma once

#include <cstdint>

#include "proofs/vq/subject.hpp"
#include "tests/foreign/inside/inside.hpp"

namespace mmverify::tests::foreign {

// Vectors, transforms and codes.
InsideRows faults_of_vectors();
InsideRows right_vectors();
// The bits of blocks.
InsideRows faults_of_blocks();
InsideRows right_blocks();
// Encoders of maps.
InsideRows faults_of_encoders();
InsideRows right_encoders();

/// The bits of a block, one number after the other, each from its least bit on.
template <class Bytes>
class BitWriter {
 public:
  explicit BitWriter(Bytes& bytes) : bytes_(bytes) { bytes_.fill(0); }
  /// Domain: at most 20 bits.
  void put(std::uint32_t value, std::uint32_t bits) {
    const std::uint32_t shifted = value << at_ % 8;
    for (std::uint32_t k = 0; k < 4 && at_ / 8 + k < bytes_.size(); ++k)
      bytes_[at_ / 8 + k] = static_cast<std::uint8_t>(bytes_[at_ / 8 + k] | shifted >> 8 * k);
    at_ += bits;
  }

 private:
  Bytes& bytes_;
  std::uint32_t at_ = 0;
};

template <class Bytes>
class BitReader {
 public:
  explicit BitReader(const Bytes& bytes) : bytes_(bytes) {}
  /// Domain: at most 20 bits.
  std::uint32_t take(std::uint32_t bits) {
    std::uint32_t word = 0;
    for (std::uint32_t k = 0; k < 4 && at_ / 8 + k < bytes_.size(); ++k)
      word |= static_cast<std::uint32_t>(bytes_[at_ / 8 + k]) << 8 * k;
    const std::uint32_t value = word >> at_ % 8 & ((1u << bits) - 1);
    at_ += bits;
    return value;
  }

 private:
  const Bytes& bytes_;
  std::uint32_t at_ = 0;
};

/// The O and the T of a vector, a bit a region.
struct Masks {
  std::uint32_t o = 0, t = 0;
};

/// A row's result in table 1: a matrix on coordinates from the middle, y upwards.
struct Matrix {
  int a, b, c, d;
  bool operator==(const Matrix&) const = default;
};
inline constexpr Matrix results[] = {{1, 0, 0, 1},  {0, -1, 1, 0}, {1, 0, 0, -1},  {0, -1, -1, 0},
                                     {-1, 0, 0, 1}, {0, 1, 1, 0},  {-1, 0, 0, -1}, {0, 1, -1, 0}};

/// The region to which a matrix moves region k of side x side.
constexpr std::uint32_t taken(const Matrix& m, int side, std::uint32_t k) {
  const int last = side - 1, x = 2 * (static_cast<int>(k) % side) - last,
            y = 2 * (static_cast<int>(k) / side) - last;
  return static_cast<std::uint32_t>((m.a * x + m.b * y + last) / 2 + side * ((m.c * x + m.d * y + last) / 2));
}

/// The bits of VQ4's entries 3 to 15, by table 2.
inline constexpr std::uint32_t entry_bits[] = {17, 17, 17, 18, 18, 20, 20, 20, 20, 20, 20, 20, 20};

proofs::vq::BlockBytes<proofs::vq::Vq2> written(const proofs::vq::Vq2& block);
proofs::vq::BlockBytes<proofs::vq::Vq4> written(const proofs::vq::Vq4& block);

}  // namespace mmverify::tests::foreign
