// Outputs in the middle of memory: a page's end stops no stray write there, so the bytes around an output are
// looked at.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

#include "subjects/dock/desk/places.hpp"
#include "subjects/dock/layout.hpp"

namespace mmverify::dock {

/// Whether `size` bytes all have the value.
inline bool all(const std::byte* bytes, std::size_t size, unsigned char value) {
  return size == 0 || (*bytes == std::byte{value} && std::memcmp(bytes, bytes + 1, size - 1) == 0);
}

/// An output between two margins.
class Fenced {
 public:
  static constexpr std::size_t margin = 256, wide_margin = 4096;

  /// An output of `bytes` bytes of `filling` that begins `behind` bytes behind a line.
  Fenced(std::size_t bytes, unsigned char filling, std::size_t behind = 0, std::size_t least = margin);
  Fenced(Fenced&&) = default;
  Fenced& operator=(Fenced&&) = default;

  std::byte* data() { return room_.data() + at_; }
  const std::byte* data() const { return room_.data() + at_; }
  std::size_t size() const { return bytes_; }

  bool is_whole_before() const { return all(room_.data(), at_, canary); }
  bool is_whole_behind() const { return all(data() + bytes_, room_.size() - at_ - bytes_, canary); }
  /// Whether the next bytes from `end` on are still as they were filled. Domain: end <= size().
  bool is_blank_from(std::size_t end) const {
    constexpr std::size_t looked_at = 8;
    return all(data() + end, std::min(looked_at, bytes_ - end), filling_);
  }

 private:
  std::size_t bytes_;
  unsigned char filling_;
  std::vector<std::byte> room_;
  std::size_t at_ = 0;
};

}  // namespace mmverify::dock
