// The map of one triangle out of one texture.
#pragma once

#include <cstdint>
#include <span>

#include "scene/attribute/code_meaning.hpp"
#include "scene/attribute/footprint.hpp"
#include "scene/plan/texel_triangle.hpp"

namespace mmverify::scene {

/// A texture made ready for any number of triangles and threads.
class MapBaker {
 public:
  /// The image must outlive it.
  MapBaker(const ColourImage& image, const AttributeTexture& texture, Averaging averaging);

  /// faces: micro-triangle k of the curve (impl/index) at out[k], the mean of the texels under it, each by its share of
  /// the area.  vertices: micro-vertex (i, j) at out[r(r+1)/2 + j], r = i+j, what the sampler gives there.
  /// Exact, rounded half up (impl/attribute/bake.hpp).
  /// Domain: out.size() = values_of_map(kind, level); UVs below 2^20 in size, a box of 2^24 texels and 2^15 along an axis
  /// at most; else std::invalid_argument.
  /// Source: Color and Attribute Micromaps, 5.1.
  void bake(const UvTriangle& uvs, MapKind kind, unsigned level, std::span<MapValue> out) const;

  const CodeMeaning& meaning() const { return meaning_; }

 private:
  CodeMeaning meaning_;
  std::uint8_t channels_;
  impl::attribute::AttributeBaker baker_;
};

}  // namespace mmverify::scene
