// A baker of one triangle's map from one texture.
#pragma once

#include <cstdint>
#include <span>

#include "scene/attribute/code_meaning.hpp"
#include "scene/attribute/footprint.hpp"
#include "scene/plan/texel_triangle.hpp"

namespace mmverify::scene {

/// A texture prepared for any number of triangles and threads.
class MapBaker {
 public:
  /// The image must outlive the baker.
  MapBaker(const ColourImage& image, const AttributeTexture& texture, Averaging averaging);

  /// faces: out[k] is micro-triangle k of the curve (impl/index): the mean of the texels under it, each by
  /// its share of the area.  vertices: out[r(r+1)/2 + j] is micro-vertex (i, j), r = i+j: the sampler's value
  /// there.
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
