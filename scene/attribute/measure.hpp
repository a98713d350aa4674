// Attribute micromaps of a scene, level by level: how many, how large, how far from their textures.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "impl/attribute/container.hpp"
#include "scene/attribute/baker.hpp"
#include "scene/attribute/laid_maps.hpp"
#include "scene/attribute/packed_maps.hpp"
#include "scene/attribute/shared_maps.hpp"
#include "scene/attribute/texel_errors.hpp"
#include "scene/attribute/texture_coder.hpp"

namespace mmverify::scene {

/// All maps of an attribute set at a level, of one kind.
struct MapsAtLevel {
  unsigned level = 0;
  MapKind kind = MapKind::faces;
  SharedMaps maps;
  MapError error;                     ///< interpolated between micro-vertices
  std::optional<MapError> nearest;    ///< of vertices: the nearest micro-vertex instead
  std::optional<double> unseen;       ///< of faces: the share of micro-triangles without a texel's centre
  std::optional<PackedBytes> packed;  ///< where it was asked for, and no more than 2^31 codes

  std::uint64_t bytes() const { return bytes_of_maps(maps.distinct, kind, level); }
};

/// The most by which textures are reduced before they are compressed.
inline constexpr std::uint32_t most_reduced = 32;

/// All textures of a set, compressed in blocks of one size, without mips.
struct CompressedTextures {
  BlockSize block;
  std::uint32_t reduced = 1;  ///< sides are so many times shorter first, and sampled bilinearly in the end
  std::uint64_t bytes = 0;
  std::uint64_t shown_bytes = 0;  ///< of the blocks of which a triangle shows a texel
  MapError error;                 ///< over the same texels as that of maps
};

struct AttributeSetFigures {
  AttributeSet set = 0;
  std::uint64_t triangles = 0, images = 0;
  std::uint64_t texture_bytes = 0;  ///< 4 a texel, without mips
  std::uint64_t texels = 0, shown = 0;
  std::vector<MapsAtLevel> levels;             ///< by level, faces before vertices
  std::vector<CompressedTextures> compressed;  ///< at full resolution, 1/2, 1/4 ...; empty without a coder
};

struct AttributeFigures {
  std::string file;
  std::uint64_t triangles = 0;      ///< of the file
  std::uint64_t images = 0;         ///< in use, each once
  std::uint64_t texture_bytes = 0;  ///< of these
  std::vector<AttributeSetFigures> sets;
  std::uint64_t far = 0;  ///< triangles left out: not within_reach()

  /// Of all sets.  Domain: a level that was measured.
  std::uint64_t bytes(unsigned level, MapKind kind) const;
  /// The first level of which all maps take more than the textures; beyond the last that was measured, with as many maps
  /// as there.
  unsigned level_beyond_textures(MapKind kind) const;
};

/// What a level makes of an image: rows of RGB.
struct AttributePicture {
  const ColourImage& image;
  AttributeSet set;
  unsigned level;
  std::vector<std::uint8_t> original, faces, vertices;
  std::vector<float> face_errors, vertex_errors;  ///< FLIP, a texel each
};

/// An image that a set reads, and which triangle shows each of its texels.
struct AttributeAtlas {
  AttributeSet set;
  const ColourImage& image;
  const std::vector<std::uint8_t>& original;  ///< rows of RGB: what maps are held against
  std::span<const MapOfTriangle> maps;        ///< of the image
  std::span<const TexelTriangle> triangles;   ///< the same in texels
  std::span<const std::uint32_t> first;       ///< by texel, as first_triangles() numbers them
};

/// All maps of a set at a level, and which one each triangle has.
struct StoredAttributes {
  AttributeSet set;
  impl::attribute::AttributeMaps maps;
};

struct AttributeOptions {
  unsigned first = 0, last = 5;
  Averaging averaging = Averaging::meaning;
  unsigned threads = 0;
  bool packed = false;                                    ///< pack the maps as well
  std::uint8_t packed_error = 0;                          ///< the most that a code may be off in them, 0..127
  PeerCoder peer = {};                                    ///< that packs them beside
  TextureCoder texture_coder = {};                        ///< that compresses the textures beside
  std::function<void(const std::string&)> progress = {};  ///< told what begins
  std::function<void()> stop = {};  ///< asked before each triangle, from any thread; may throw
  std::function<void(const StoredAttributes&)> stored = {};  ///< given each set, level and kind, packed
  std::function<void(const LaidMaps&)> laid =
      {};  ///< given each set, level and kind, where they are not too many
  std::function<void(const AttributeAtlas&)> atlas = {};  ///< told of each image of each set, before its maps
  std::function<void(const AttributePicture&)> picture = {};  ///< told of each level of each sRGB image
};

/// Each triangle has a map of its own in each of its sets, all of one level.  Equal maps of a set are counted once.
/// A texel that several triangles show is the first one's; what no triangle shows stays the texture's, and is not counted.
/// Domain: a scene of load_attributes(); first <= last <= finest_attribute_level, else std::invalid_argument.
/// Source: Color and Attribute Micromaps, 5.1 and 5.2, table 2, figures 9 and 11, in texture space.
AttributeFigures measure(const AttributeScene& scene, const AttributeOptions& options);

}  // namespace mmverify::scene
