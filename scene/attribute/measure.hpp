// Attribute micromaps of a scene, level by level: their number, their size, their distance from the textures.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "impl/attribute/container.hpp"
#include "scene/attribute/compressed_textures.hpp"
#include "scene/attribute/packed_maps.hpp"

namespace mmverify::scene {

/// All maps of an attribute set at a level, of one kind.
struct MapsAtLevel {
  unsigned level = 0;
  MapKind kind = MapKind::faces;
  std::uint64_t distinct = 0;         ///< maps, each once
  std::uint64_t constant = 0;         ///< distinct maps of one value, for which a special index would do
  MapError error;                     ///< values interpolated between micro-vertices
  std::optional<MapError> nearest;    ///< for vertices: with the nearest micro-vertex instead
  std::optional<double> unseen;       ///< for faces: the share of micro-triangles without a texel's centre
  std::optional<PackedBytes> packed;  ///< if requested, and no more than 2^31 codes

  std::uint64_t bytes() const { return bytes_of_maps(distinct, kind, level); }
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
  std::uint64_t texture_bytes = 0;  ///< of these images
  std::vector<AttributeSetFigures> sets;
  std::uint64_t far = 0;  ///< triangles left out: not within_reach()

  /// The bytes of all sets.  Domain: a measured level.
  std::uint64_t bytes(unsigned level, MapKind kind) const;
  /// The first level at which all maps take more than the textures.  Levels beyond the last measured one are
  /// assumed to have as many maps as that one.
  unsigned level_beyond_textures(MapKind kind) const;
};

/// The pictures that a level makes of an image: rows of RGB.
struct AttributePicture {
  const ColourImage& image;
  AttributeSet set;
  unsigned level;
  std::vector<std::uint8_t> original, faces, vertices;
  std::vector<float> face_errors, vertex_errors;  ///< FLIP, a value a texel
};

/// An image that a set reads, and the maps of the last level.
struct AttributeAtlas {
  const ColourImage& image;
  const ComparedImage& compared;
  const SetMaps &faces, &vertices;  ///< with the numbers of the image's triangles
};

/// All maps of a set at a level, and the map of each triangle.
struct StoredAttributes {
  AttributeSet set;
  impl::attribute::AttributeMaps maps;
  std::vector<std::uint8_t> packed;  ///< pack() of the maps; empty beyond 2^31 codes
};

struct AttributeOptions {
  unsigned first = 0, last = 5;
  Averaging averaging = Averaging::meaning;
  unsigned threads = 0;
  bool packed = false;              ///< pack the maps as well
  std::uint8_t packed_error = 0;    ///< the most that a code may be off in packed maps, 0..127
  PeerCoder peer = {};              ///< another packer of the same codes
  TextureCoder texture_coder = {};  ///< compresses the textures for comparison
  std::function<void(const std::string&)> progress = {};  ///< receives the name of each step that begins
  std::function<void()> stop = {};  ///< called before each triangle, from any thread; may throw
  std::function<void(const StoredAttributes&)> stored = {};  ///< receives each set, level and kind, packed
  /// Receives each set, level and kind whose distinct maps have at most most_kept_values.
  std::function<void(const SetMaps&)> kept = {};
  std::function<void(const AttributeAtlas&)> atlas = {};      ///< receives each image of each set
  std::function<void(const AttributePicture&)> picture = {};  ///< receives each level of each sRGB image
  /// Receives the figures of the sets that are measured, and the number of those that are not yet, after each set.
  std::function<void(const AttributeFigures&, std::size_t left)> so_far = {};
};

/// Measures a map of its own for each triangle in each of its sets, all of one level.  Equal maps of a set
/// are counted once.
/// A texel that several triangles show belongs to the first of them.  A texel that no triangle shows stays
/// the texture's, and is not counted.
/// Domain: a scene of load_attributes(); first <= last <= finest_attribute_level, else std::invalid_argument.
/// Source: Color and Attribute Micromaps, 5.1 and 5.2, table 2, figures 9 and 11, in texture space.
AttributeFigures measure(const AttributeScene& scene, const AttributeOptions& options);

}  // namespace mmverify::scene
