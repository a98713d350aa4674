// Triangles that see the same piece of a texture.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>

#include "impl/scene/texel_triangle.hpp"

namespace mmverify::impl::scene {

/// Vertex k of a triangle is vertex order[k] of the one that it duplicates.
using VertexOrder = std::array<std::uint8_t, 3>;

/// Distinct UV triangles, numbered as they come.  Two are one where their corners are the same floats (-0 is
/// 0), in whatever order: a rotation or mirror image is the same micromap, its micro-triangles permuted.
class UvDuplicates {
 public:
  struct Found {
    std::size_t number;  ///< of the distinct triangle
    VertexOrder order;   ///< from this one's vertices to those of the first that came; where several are
                         ///< right, the first in lexical order
    bool is_new;
  };

  /// `surface` keeps apart what lies on different textures.  Domain: UVs not NaN.
  Found add(std::uint32_t surface, const UvTriangle& uvs);

  std::size_t size() const { return distinct_.size(); }

 private:
  struct Key {
    std::uint32_t surface;
    UvTriangle corners;  ///< sorted
    bool operator==(const Key&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };
  struct First {
    std::size_t number;
    UvTriangle uvs;
  };
  std::unordered_map<Key, First, Hash> distinct_;
};

}  // namespace mmverify::impl::scene
