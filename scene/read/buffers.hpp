// The bytes behind a document: buffers and views of them, each inside the other.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "scene/read/document.hpp"

namespace mmverify::scene {

/// All buffers of a document; the constructor reads them.
/// Errors: BadScene if one is missing or has fewer bytes than its byteLength.  The fallback of compressed
/// views (EXT_meshopt_compression) may be missing.
class Buffers {
 public:
  explicit Buffers(const Document& document);

  /// The bytes of bufferViews[view], decoded where they are compressed.  A view is decoded once, when it is
  /// first asked for; two threads must not ask at a time.
  /// Errors: BadScene if they lie outside their buffer, and as of decode_meshopt(); UnreadExtension if the
  /// file requires an extension of the view that is not read here.
  std::span<const unsigned char> view(std::size_t view) const;

  /// Errors: BadScene if the stored bytes of a view, compressed or not, lie outside their buffer.
  void check_view(std::size_t view) const;

  /// Whether buffers[buffer] has no bytes, since all that it stands for is stored compressed.
  bool is_placeholder(std::size_t buffer) const;

  /// Whole buffers, each with byteLength bytes; a placeholder has none.
  const std::vector<Bytes>& all() const { return buffers_; }

 private:
  std::span<const unsigned char> stored(std::size_t view, std::size_t buffer, std::size_t offset,
                                        std::size_t length) const;

  const Document* document_;
  std::vector<Bytes> buffers_;
  mutable std::map<std::size_t, Bytes> decoded_;
};

}  // namespace mmverify::scene
