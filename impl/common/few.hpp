// A short list without memory of its own on the heap.  Internal to impl.
#pragma once

#include <array>
#include <cstddef>

namespace mmverify::impl {

/// At most `most` items; the caller adds no more.
template <class Item, std::size_t most>
class Few {
 public:
  constexpr void push_back(const Item& item) { items_[size_++] = item; }
  constexpr std::size_t size() const noexcept { return size_; }
  constexpr const Item* data() const noexcept { return items_.data(); }
  constexpr const Item* begin() const noexcept { return items_.data(); }
  constexpr const Item* end() const noexcept { return items_.data() + size_; }
  constexpr const Item& operator[](std::size_t k) const noexcept { return items_[k]; }

 private:
  std::array<Item, most> items_;
  std::size_t size_ = 0;
};

}  // namespace mmverify::impl
