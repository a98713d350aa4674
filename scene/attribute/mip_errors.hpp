// A texture's mips beside those of its maps, and what bleeds across the borders of charts.
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

/// How far a mip is from the texture, over the texels that a triangle shows.  RMSE in codes of 8 bits.
struct MipError {
  MapError all;
  std::optional<double> border, interior;  ///< RMSE of either alone; nothing where no texel is there
};

/// A level of maps, made out of the highest one.
struct MipOfMaps {
  unsigned level = 0;
  double values_per_texel = 0;  ///< of all triangles' maps, a texel shown
  MipError error;
};

/// Mip m of all textures of a set, and beside it of each kind the level with most nearly as many values: that with the
/// least |log(values / 4^-m)|.
struct MipStep {
  AttributeSet set = 0;
  unsigned mip = 0;
  double border_share = 0;  ///< of the texels shown
  MipError texture;
  MipOfMaps faces, vertices;
};

/// One way to show an image: rows of RGB, and its FLIP, a texel each.
struct ShownMip {
  std::vector<std::uint8_t> rgb;
  std::vector<float> errors;
};

/// A mip of an image of sRGB beside the levels of its maps.  The levels are nearest by the image's own numbers, which are
/// the set's where it has one image.
struct MipPicture {
  const ColourImage& image;
  AttributeSet set;
  unsigned mip;
  std::span<const std::uint8_t> bands;  ///< bands_of()
  const ShownMip &texture, &faces, &vertices;
};

/// Takes errors of mips as atlases come by (AttributeOptions::atlas).
///   texture, mip m  each texel the mean of 2^m x 2^m of the whole image, whichever charts they are of, in light (as
///                   reduced() has it); shown by a bilinear sampler; m = 0 is the texture
///   faces           the map of level `last`; of a level below, each value the mean of four children's, rounded
///   vertices        of the map of level `last` the values at the vertices of the level, which no rounding touches
/// Border: texels of a chart within 2^m texels of one of another chart or of none (charts.hpp).  A bilinear sample of mip
/// m reaches 3/2 2^m - 1 texels, so a little of what bleeds is the interior's.
/// Source: Color and Attribute Micromaps, 4.4 and 4.4.1, figure 7.
class MipErrors {
 public:
  /// Levels options.first..options.last; mips 0..last - first.  Both must outlive it.  `picture` is told of each mip of
  /// each image of sRGB.
  MipErrors(const AttributeScene& scene, const AttributeOptions& options,
            std::function<void(const MipPicture&)> picture = {})
      : scene_(scene),
        options_(options),
        picture_(std::move(picture)),
        steps_(options.last - options.first + 1) {}

  void take(const AttributeAtlas& atlas);
  /// Set by set, mip by mip; of sets of which a texel is shown.
  std::vector<MipStep> steps() const;

 private:
  /// Sums over the texels of a band.
  struct BandSums {
    double squares = 0, flip = 0;
  };
  using Bands = std::vector<BandSums>;  ///< as bands_of() numbers them
  /// Of all images of a set.
  struct SetSums {
    std::uint64_t triangles = 0;
    std::vector<std::uint64_t> texels;           ///< by band
    std::vector<Bands> texture;                  ///< by mip
    std::array<std::vector<Bands>, 2> by_level;  ///< by MapKind; from the lowest level
  };

  std::vector<ShownMip> mips_of(const AttributeAtlas& atlas) const;
  /// From the lowest level.
  std::vector<ShownMip> maps_of(const AttributeAtlas& atlas, MapKind kind) const;
  /// Fills in the errors, where there is FLIP.
  void add(const AttributeAtlas& atlas, std::span<const std::uint8_t> bands, ShownMip& shown,
           Bands& sums) const;
  unsigned nearest_level(std::uint64_t triangles, std::uint64_t texels, MapKind kind, unsigned mip) const;
  MipError error_of(AttributeSet set, const SetSums& sums, const Bands& bands, unsigned mip) const;
  MipOfMaps maps_beside(AttributeSet set, const SetSums& sums, MapKind kind, unsigned mip) const;

  const AttributeScene& scene_;
  const AttributeOptions& options_;
  std::function<void(const MipPicture&)> picture_;
  unsigned steps_;
  std::map<AttributeSet, SetSums> sums_;
};

/// The map of a level below, as MapBaker lays maps out.
/// Domain: level <= of <= 12, as many values as the map of level `of` has.
std::vector<MapValue> mip_of_map(std::span<const MapValue> map, MapKind kind, unsigned of, unsigned level,
                                 const CodeMeaning& meaning);

}  // namespace mmverify::scene
