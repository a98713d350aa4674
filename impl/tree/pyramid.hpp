// Algorithm 1, word by word: the internal nodes of the perfect tree, and the first state of each node.  Internal to
// impl/tree.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "impl/tree/bits.hpp"
#include "impl/tree/stream.hpp"

namespace mmverify::impl::tree::detail {

/// Throws std::invalid_argument unless the level is at most max_level and the map has its size.
void require_map(Level n, Format b, std::size_t map_bytes);

/// The perfect tree of a map: for every depth d in 0..n-1 (0 alone if n = 0) one bit a node, internal or not, and its
/// first state.  Domain: level and size as for require_map().  Reads the map once; padding bits are ignored.
class Pyramid {
 public:
  Pyramid(Level n, Format b, std::span<const std::uint8_t> map);

  /// The flags of depth d, bit k for node k, 64 a word; bits beyond 4^d are zero.
  std::span<const std::uint64_t> mixed(Level d) const noexcept {
    return {words_.data() + mixed_at_[d], mixed_at_[d + 1] - mixed_at_[d]};
  }
  /// The flags of the four children of node k of depth d-1.
  std::uint32_t children(Level d, std::uint64_t k) const noexcept {
    return static_cast<std::uint32_t>(words_[mixed_at_[d] + k / 16] >> (4 * (k % 16))) & 15;
  }
  /// The first states of the four children of node k of depth d-1.
  std::uint32_t first_states(Level d, std::uint64_t k) const noexcept {
    const std::uint64_t bit = k * 4 * b_;
    return static_cast<std::uint32_t>(words_[states_at_[d] + bit / 64] >> (bit % 64)) & (b_ == 1 ? 15 : 255);
  }
  /// The first state of node k of depth d.
  std::uint32_t first_state(Level d, std::uint64_t k) const noexcept {
    const std::uint64_t bit = k * b_;
    return static_cast<std::uint32_t>(words_[states_at_[d] + bit / 64] >> (bit % 64)) & (b_ == 1 ? 1 : 3);
  }
  /// The number of internal nodes of depth d; 0 at depth n.
  std::uint64_t internal(Level d) const noexcept { return internal_[d]; }
  std::uint64_t internal() const noexcept {
    std::uint64_t sum = 0;
    for (const std::uint64_t at_depth : internal_) sum += at_depth;
    return sum;
  }

 private:
  std::uint32_t b_;
  std::array<std::size_t, max_level + 2> mixed_at_{}, states_at_{};
  std::array<std::uint64_t, max_level + 1> internal_{};
  std::vector<std::uint64_t> words_;
};

}  // namespace mmverify::impl::tree::detail
