// The bytes of a packed map, which several triangles may share.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "impl/micromap/micromap.hpp"

namespace mmverify::scene {

/// Bytes that never change; a copy shares them.
class MapBytes {
 public:
  MapBytes() = default;
  /// Owns its bytes.
  MapBytes(impl::micromap::Bytes bytes)
      : owner_(std::make_shared<const impl::micromap::Bytes>(std::move(bytes))),
        bytes_(*static_cast<const impl::micromap::Bytes*>(owner_.get())) {}
  /// Domain: bytes that live as long as `owner`.
  MapBytes(std::shared_ptr<const void> owner, std::span<const std::uint8_t> bytes)
      : owner_(std::move(owner)), bytes_(bytes) {}

  std::uint8_t operator[](std::size_t k) const { return bytes_[k]; }
  std::size_t size() const { return bytes_.size(); }
  auto begin() const { return bytes_.begin(); }
  auto end() const { return bytes_.end(); }
  const std::uint8_t* data() const { return bytes_.data(); }
  bool operator==(const MapBytes& other) const {
    return std::equal(begin(), end(), other.begin(), other.end());
  }

 private:
  std::shared_ptr<const void> owner_;
  std::span<const std::uint8_t> bytes_;
};

}  // namespace mmverify::scene
