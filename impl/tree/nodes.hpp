// The nodes of the form for random access, with counts between them.  Internal to impl/tree.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#include "impl/tree/bits.hpp"

namespace mmverify::impl::tree::detail {

/// Writes nodes into words that have room for a count above the nodes.
class NodeWriter {
 public:
  NodeWriter(std::uint64_t* words, std::uint32_t per_word)
      : first_(words), word_(words), per_word_(per_word) {}

  /// Domain: count in 1..16, and no bit of flags at or above it.
  void put(std::uint64_t flags, std::uint32_t count) {
    if (used_ == per_word_) {
      ++word_;
      used_ = 0;
    }
    const std::uint32_t here = std::min(count, per_word_ - used_);
    *word_ |= (flags & low_bits(here)) << used_;
    used_ += here;
    if (here < count) {
      *++word_ = flags >> here;
      used_ = count - here;
    }
  }

  /// Writes the counts after the last node: the number of ones before each word.
  void count() {
    std::uint64_t ones = 0;
    for (std::uint64_t* word = first_; word <= word_; ++word) {
      const auto here = static_cast<std::uint64_t>(std::popcount(*word));
      *word |= ones << per_word_;
      ones += here;
    }
  }

 private:
  std::uint64_t *first_, *word_;
  std::uint32_t per_word_, used_ = 0;
};

/// Reads the nodes of a NodeWriter.
class NodeReader {
 public:
  NodeReader(const std::uint8_t* bytes, std::uint32_t per_word) : bytes_(bytes), per_word_(per_word) {}

  /// Takes the next `count` nodes.  Domain: count in 1..16, no more than there are.
  std::uint64_t take(std::uint32_t count) {
    if (left_ == 0) load();
    const std::uint32_t here = std::min(count, left_);
    std::uint64_t flags = word_ & low_bits(here);
    drop(here);
    if (here < count) {
      load();
      flags |= (word_ & low_bits(count - here)) << here;
      drop(count - here);
    }
    return flags;
  }

 private:
  void load() {
    std::memcpy(&word_, bytes_, sizeof word_);
    bytes_ += sizeof word_;
    left_ = per_word_;
  }
  void drop(std::uint32_t count) {
    word_ >>= count;
    left_ -= count;
  }

  const std::uint8_t* bytes_;
  std::uint64_t word_ = 0;
  std::uint32_t per_word_, left_ = 0;
};

}  // namespace mmverify::impl::tree::detail
