// The bytes behind a document: buffers and views of them, each inside the other.
#pragma once

#include <span>
#include <vector>

#include "impl/scene/document.hpp"

namespace mmverify::impl::scene {

/// All buffers of a document, read when made.
/// Errors: BadScene where one is missing or has fewer bytes than its byteLength.
class Buffers {
 public:
  explicit Buffers(const Document& document);

  /// The bytes of bufferViews[view].  Errors: BadScene where they lie outside their buffer.
  std::span<const unsigned char> view(std::size_t view) const;

 private:
  const Document* document_;
  std::vector<Bytes> buffers_;
};

/// What a base64 data URI holds.  Errors: BadScene where it is none.
Bytes from_data_uri(const std::string& uri, const std::string& file, const std::string& place);

}  // namespace mmverify::impl::scene
