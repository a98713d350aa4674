// Triangles that see the same piece of a texture.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>

#include "scene/plan/texel_triangle.hpp"

namespace mmverify::scene {

/// Vertex k of a triangle is vertex order[k] of the one that it duplicates.
using VertexOrder = std::array<std::uint8_t, 3>;

/// By what whole numbers a texture repeats along u and v: 1 repeat, 2 mirrored repeat, 0 not at all.
using Periods = std::array<int, 2>;
Periods periods(const Sampler& sampler);

/// Distinct UV triangles, numbered as they come.  Two are one where their corners are the same numbers, in
/// whatever order: a rotation or mirror image is the same micromap, its micro-triangles permuted.  So they
/// are where they are the same after a shift by periods of the texture, if float32 holds the shifted corners
/// exactly; a corner that would have to be rounded is of another triangle.
class UvDuplicates {
 public:
  struct Found {
    std::size_t number;  ///< of the distinct triangle
    VertexOrder order;   ///< from this one's vertices to those of the first that came; where several are
                         ///< right, the first in lexical order
    bool is_new;
  };

  /// `surface` keeps apart what lies on different textures, `periods` are of its sampler.  Domain: UVs not
  /// NaN.
  Found add(std::uint32_t surface, const UvTriangle& uvs, const Periods& periods = {0, 0});

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
    UvTriangle uvs;  ///< shifted
  };
  std::unordered_map<Key, First, Hash> distinct_;
};

}  // namespace mmverify::scene
