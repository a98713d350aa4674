// A finder of triangles that see the same piece of a texture.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>

#include "scene/plan/texel_triangle.hpp"

namespace mmverify::scene {

/// Vertex k of a triangle is vertex order[k] of the triangle that it duplicates.
using VertexOrder = std::array<std::uint8_t, 3>;

/// The periods of a texture along u and v: 1 repeat, 2 mirrored repeat, 0 none.
using Periods = std::array<int, 2>;
Periods periods(const Sampler& sampler);

/// A factor of alpha at each corner of a triangle.
using CornerAlphas = std::array<float, 3>;
inline constexpr CornerAlphas one_alpha{1, 1, 1};

/// Distinct UV triangles, numbered in order of appearance.  Two triangles are equal if their corners are the
/// same numbers in any order: a rotation or mirror image has the same micromap with its micro-triangles
/// permuted.  They are also equal after a shift by periods of the texture, if float32 represents the shifted
/// corners exactly.  A shift that would round a corner gives another triangle.  Corners of other alphas are others.
class UvDuplicates {
 public:
  struct Match {
    std::size_t number;  ///< of the distinct triangle
    VertexOrder order;   ///< from its vertices to those of the first equal triangle; of several that fit,
                         ///< the first in lexical order
    bool is_new;
  };

  /// `surface` separates triangles on different textures, and `periods` are those of its sampler.  Domain:
  /// UVs not NaN.
  Match add(std::uint32_t surface, const UvTriangle& uvs, const Periods& periods = {0, 0},
            const CornerAlphas& alphas = one_alpha);

  std::size_t size() const { return distinct_.size(); }

 private:
  using Corner = std::array<float, 3>;  ///< UV and alpha
  using Corners = std::array<Corner, 3>;
  struct Key {
    std::uint32_t surface;
    Corners corners;  ///< sorted
    bool operator==(const Key&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };
  struct First {
    std::size_t number;
    Corners corners;  ///< shifted
  };
  std::unordered_map<Key, First, Hash> distinct_;
};

}  // namespace mmverify::scene
