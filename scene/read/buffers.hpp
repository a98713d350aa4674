// The bytes behind a document: buffers and views of them, each inside the other.
#pragma once

#include <span>
#include <vector>

#include "scene/read/document.hpp"

namespace mmverify::scene {

/// All buffers of a document; the constructor reads them.
/// Errors: BadScene if one is missing or has fewer bytes than its byteLength.
class Buffers {
 public:
  explicit Buffers(const Document& document);

  /// The bytes of bufferViews[view].  Errors: BadScene if they lie outside their buffer.
  std::span<const unsigned char> view(std::size_t view) const;

  /// Whole buffers, each with byteLength bytes.
  const std::vector<Bytes>& all() const { return buffers_; }

 private:
  const Document* document_;
  std::vector<Bytes> buffers_;
};

}  // namespace mmverify::scene
