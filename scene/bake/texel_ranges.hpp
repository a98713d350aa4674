// The least and the greatest texel of rectangles of a picture.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "scene/scene.hpp"

namespace mmverify::scene {

/// The least and the greatest stored number of some texels.
struct TexelRange {
  float least, greatest;
  void take(const TexelRange& other) {
    least = std::min(least, other.least);
    greatest = std::max(greatest, other.greatest);
  }
};

/// The indices first to last, both included.
struct IndexRange {
  std::int64_t first, last;
};

class TexelRanges {
 public:
  /// The image outlives this.  Domain: a decoded image.
  explicit TexelRanges(const Image& image);

  /// A range of the texels [columns] x [rows], wrapped: exact for few, and no narrower than theirs for many.
  TexelRange of(const IndexRange& columns, const IndexRange& rows, const Sampler& sampler) const;

  float texel(std::int64_t x, std::int64_t y) const;

 private:
  /// Ranges of squares of 4^k texels a side.
  struct Squares {
    std::int64_t across = 0;
    std::vector<TexelRange> all;
  };
  TexelRange within(IndexRange columns, IndexRange rows) const;

  const Image& image_;
  std::vector<Squares> squares_;  ///< k = 1, 2, ...
};

/// The indices below `size` that some indices mean: one range or two.
/// Source: Vulkan, "Wrapping Operation".
std::vector<IndexRange> wrapped_ranges(Wrap wrap, const IndexRange& indices, std::int64_t size);

}  // namespace mmverify::scene
