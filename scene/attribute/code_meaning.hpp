// The meaning of the codes of a map's values, and so the quantities that are averaged.
#pragma once

#include <array>
#include <cstdint>

#include "impl/attribute/bake.hpp"
#include "scene/read/attributes.hpp"

namespace mmverify::scene {

/// A value: red, green, blue, 0.  A channel that no attribute of the texture's reads is 0.
using MapValue = impl::attribute::Rgba;

/// The quantity that faces and bilinear samples average.
enum class Averaging : std::uint8_t {
  meaning,  ///< light of sRGB codes; directions of normals, made one unit long again; else codes
  codes,    ///< codes always, as the paper's "average of the pixels"
};

/// The meaning for impl/attribute.
impl::attribute::Meaning meaning_of(AttributeSet set, Averaging averaging);

/// A conversion from values to averaged quantities, and back in binary64, rounded half up.
class CodeMeaning {
 public:
  CodeMeaning(AttributeSet set, Averaging averaging);
  using Mean = std::array<double, 3>;
  Mean mean_of(const MapValue& value) const;  ///< of a single value
  /// The mean of opposite normals has no direction; it becomes the surface's own normal.
  MapValue code_of(Mean mean) const;

 private:
  impl::attribute::Meaning meaning_;
  std::uint8_t channels_;
  std::array<double, 256> table_;
  std::array<double, 256> thresholds_;  ///< entry k: the light from which on the code is k+1
};

}  // namespace mmverify::scene
