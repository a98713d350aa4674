// A hash table of stored parts.  Internal to impl/dag.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mmverify::impl::dag {

/// A set of numbers of parts stored elsewhere, by 32 bits of the parts' hashes.  Linear probing.
class Table {
 public:
  /// The number of the part that has this hash and is the same, or `none`.
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  template <class Same>
  std::uint32_t find(std::uint32_t hash, const Same& same) const {
    if (slots_.empty()) return none;
    for (std::size_t k = hash & mask();; k = (k + 1) & mask()) {
      const std::uint64_t slot = slots_[k];
      if (slot == empty) return none;
      if (slot >> 32 == hash && same(static_cast<std::uint32_t>(slot)))
        return static_cast<std::uint32_t>(slot);
    }
  }

  /// Domain: number < none; not there yet.
  void insert(std::uint32_t hash, std::uint32_t number) {
    if (2 * (size_ + 1) > slots_.size()) grow();
    order_.push_back(std::uint64_t{hash} << 32 | number);
    place(order_.back());
    ++size_;
  }

  /// Removes the number that was inserted last.  Later ones are gone, so no probe for another passes its slot.
  void pop() {
    const std::uint64_t last = order_.back();
    order_.pop_back();
    std::size_t k = (last >> 32) & mask();
    while (slots_[k] != last) k = (k + 1) & mask();
    slots_[k] = empty;
    --size_;
  }

 private:
  static constexpr std::uint64_t empty = ~std::uint64_t{0};
  std::size_t mask() const { return slots_.size() - 1; }
  void place(std::uint64_t slot) {
    std::size_t k = (slot >> 32) & mask();
    while (slots_[k] != empty) k = (k + 1) & mask();
    slots_[k] = slot;
  }
  /// Inserts all numbers again in their order, which pop() needs.
  void grow() {
    slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), empty);
    for (const std::uint64_t slot : order_) place(slot);
  }

  std::vector<std::uint64_t> slots_, order_;
  std::size_t size_ = 0;
};

/// 32 bits of a hash of words, which never show in stored data.
template <class Word>
std::uint32_t hash_of(std::span<const Word> words) noexcept {
  std::uint64_t h = 0x9e3779b97f4a7c15 ^ words.size();
  for (const Word w : words) {
    h = (h ^ w) * 0xff51afd7ed558ccd;
    h ^= h >> 32;
  }
  h *= 0xc4ceb9fe1a85ec53;
  return static_cast<std::uint32_t>(h >> 32);
}

}  // namespace mmverify::impl::dag
