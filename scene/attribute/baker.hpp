// The map of one triangle out of one texture.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "scene/attribute/footprint.hpp"
#include "scene/plan/texel_triangle.hpp"
#include "scene/read/attributes.hpp"

namespace mmverify::scene {

/// A value: red, green, blue, 0.  A channel that no attribute of the texture's reads is 0.
using MapValue = std::array<std::uint8_t, 4>;

/// What is averaged, faces and bilinear samples alike.
enum class Averaging : std::uint8_t {
  meaning,  ///< light of sRGB codes; directions of normals, made one unit long again; else codes
  codes,    ///< codes of all, as the paper's "average of the pixels"
};

/// Values of colours and directions between codes, and back: half up.
class CodeMeaning {
 public:
  CodeMeaning(AttributeSet set, Averaging averaging);
  using Mean = std::array<double, 3>;
  Mean mean_of(const MapValue& value) const;  ///< one value's
  MapValue code_of(Mean mean) const;

 private:
  bool light_, directions_;
  std::uint8_t channels_;
  std::array<double, 256> table_;
  std::array<double, 256> thresholds_;  ///< light from which on the code is k+1
};

/// A texture made ready for any number of triangles and threads.
class MapBaker {
 public:
  /// The image must outlive it.
  MapBaker(const ColourImage& image, const AttributeTexture& texture, Averaging averaging);

  /// faces: micro-triangle k of the curve (impl/index) at out[k], the mean of the texels under it, each by its share of
  /// the area.  vertices: micro-vertex (i, j) at out[r(r+1)/2 + j], r = i+j, what the sampler gives there.
  /// Domain: out.size() = values_of_map(kind, level); UVs below 2^20 in size; else std::invalid_argument.
  /// Source: Color and Attribute Micromaps, 5.1.
  void bake(const UvTriangle& uvs, MapKind kind, unsigned level, std::span<MapValue> out) const;

  const CodeMeaning& meaning() const { return meaning_; }

 private:
  CodeMeaning::Mean texel(std::int64_t x, std::int64_t y) const;
  CodeMeaning::Mean face(const TexelTriangle& corners) const;
  CodeMeaning::Mean sample(double x, double y) const;

  const ColourImage* image_;
  AttributeTexture texture_;
  CodeMeaning meaning_;
};

/// The texel that (x, y) is, wrapped.  Domain: |x|, |y| < 2^40.
std::size_t wrapped_texel(const ColourImage& image, const Sampler& sampler, std::int64_t x, std::int64_t y);

}  // namespace mmverify::scene
