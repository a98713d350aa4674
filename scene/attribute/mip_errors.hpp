// A texture's mips beside the mips of its maps, and the errors of bleeding across the borders of charts.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "scene/attribute/measure.hpp"

namespace mmverify::scene {

/// The difference of a mip and its texture, over the texels that a triangle shows.  RMSE in codes of 8 bits.
struct MipError {
  MapError all;
  std::optional<double> border, interior;  ///< RMSE of each part alone; none without texels
};

/// A level of maps, made from the highest level.
struct MipOfMaps {
  unsigned level = 0;
  double values_per_texel = 0;  ///< values of all triangles' maps over the shown texels
  MipError error;
};

/// Mip m of all textures of a set, and for each kind the level with most nearly as many values, which has the
/// least |log(values / 4^-m)|.
struct MipStep {
  AttributeSet set = 0;
  unsigned mip = 0;
  double border_share = 0;  ///< border texels over shown texels
  MipError texture;
  MipOfMaps faces, vertices;
};

/// One way to show an image: rows of RGB, and its FLIP, a value a texel.
struct ShownMip {
  std::vector<std::uint8_t> rgb;
  std::vector<float> errors;
};

/// A mip of an sRGB image beside the levels of its maps.  The levels are nearest by the image's own counts,
/// which are the set's if the set has one image.
struct MipPicture {
  const ColourImage& image;
  AttributeSet set;
  unsigned mip;
  std::span<const std::uint8_t> bands;  ///< bands_of()
  const ShownMip &texture, &faces, &vertices;
};

/// The errors of mips, added up atlas by atlas (AttributeOptions::atlas of the same options).
///   texture, mip m  each texel is the mean of 2^m x 2^m texels of the whole image, of any chart, in light (as in
///                   reduced()); shown by a bilinear sampler; m = 0 is the texture
///   faces           the map of level `last`; at a level below, each value is the mean of four children, rounded
///   vertices        the values of the map of level `last` at the vertices of the level, without rounding
/// Border: texels of a chart within 2^m texels of a texel of another chart or of none (charts.hpp).  A
/// bilinear sample of mip m reaches 3/2 2^m - 1 texels, so a little of the bleeding is counted as interior.
/// Source: Color and Attribute Micromaps, 4.4 and 4.4.1, figure 7.
class MipErrors {
 public:
  /// Levels are options.first..options.last, mips 0..last - first.  The options must outlive the object.
  /// `picture` receives each mip of each sRGB image.
  explicit MipErrors(const AttributeOptions& options, std::function<void(const MipPicture&)> picture = {})
      : options_(options), picture_(std::move(picture)), steps_(options.last - options.first + 1) {}

  void take(const AttributeAtlas& atlas);
  /// The steps by set, then by mip; sets without a shown texel are left out.
  std::vector<MipStep> steps() const;

 private:
  /// Sums over the texels of a band.
  struct BandSums {
    double squares = 0, flip = 0;
  };
  using Bands = std::vector<BandSums>;  ///< as bands_of() numbers them
  /// The sums over all images of a set.
  struct SetSums {
    std::uint64_t triangles = 0;
    std::vector<std::uint64_t> texels;           ///< by band
    std::vector<Bands> texture;                  ///< by mip
    std::array<std::vector<Bands>, 2> by_level;  ///< by MapKind; from the lowest level
  };

  std::vector<ShownMip> mips_of(const AttributeAtlas& atlas) const;
  /// The shown maps, from the lowest level.
  std::vector<ShownMip> maps_of(const AttributeAtlas& atlas, const SetMaps& maps) const;
  /// Adds the errors to `sums`; fills in `shown.errors` if there is FLIP.
  void add(const AttributeAtlas& atlas, std::span<const std::uint8_t> bands, ShownMip& shown,
           Bands& sums) const;
  unsigned nearest_level(std::uint64_t triangles, std::uint64_t texels, MapKind kind, unsigned mip) const;
  MipError error_of(AttributeSet set, const SetSums& sums, const Bands& bands, unsigned mip) const;
  MipOfMaps maps_beside(AttributeSet set, const SetSums& sums, MapKind kind, unsigned mip) const;

  const AttributeOptions& options_;
  std::function<void(const MipPicture&)> picture_;
  unsigned steps_;
  std::map<AttributeSet, SetSums> sums_;
};

/// The map of a level at or below `of`, laid out as MapBaker's.
/// Domain: level <= of <= 12, as many values as the map of level `of` has.
std::vector<MapValue> mip_of_map(std::span<const MapValue> map, MapKind kind, unsigned of, unsigned level,
                                 const CodeMeaning& meaning);

}  // namespace mmverify::scene
