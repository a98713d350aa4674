#include "scene/attribute/measure.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "scene/attribute/image_triangles.hpp"
#include "scene/attribute/map_reading.hpp"
#include "scene/attribute/reduced_texture.hpp"
#include "scene/attribute/same_uvs.hpp"

namespace mmverify::scene {
namespace {

using MapValues = std::vector<MapValue>;

/// The measurement of one attribute set of a scene: its maps, image by image.
class SetMeasurement {
 public:
  SetMeasurement(const AttributeScene& scene, AttributeSet set, const AttributeOptions& options)
      : scene_(scene), options_(options), set_(set), channels_(channels_of(set)) {
    figures_.set = set;
    for (std::size_t k = 0; k < scene.textures.size(); ++k)
      if (scene.textures[k].set == set)
        bakers_.emplace(
            k, MapBaker(scene.images[scene.textures[k].image], scene.textures[k], options.averaging));
    for (const AttributePrimitive& primitive : scene.primitives)
      for (const AttributeUse& use : primitive.uses)
        if (bakers_.contains(use.texture))
          for (const Triangle& t : primitive.triangles)
            add({use.texture, {use.uvs[t[0]], use.uvs[t[1]], use.uvs[t[2]]}});
    figures_.triangles = all_.size();
    same_ = first_of_same_uvs(all_);
    const unsigned levels = options.last - options.first + 1;
    keys_.assign(levels * std::size(map_kinds), std::vector<MapKey>(all_.size()));
    sums_.assign(keys_.size(), {});
    nearest_sums_ = sums_;
    seen_faces_.assign(levels, 0);
  }

  AttributeSetFigures measured() {
    std::set<std::size_t> images;
    for (const auto& [number, baker] : bakers_) images.insert(scene_.textures[number].image);
    for (const std::size_t image : images) measure_image(image);
    for (std::size_t k = 0; k < compressed_sums_.size(); ++k)
      figures_.compressed[k].error = error_of(compressed_sums_[k]);
    for (unsigned level = options_.first; level <= options_.last; ++level)
      for (const MapKind kind : map_kinds) figures_.levels.push_back(at_level(level, kind));
    return figures_;
  }

  std::uint64_t far() const { return far_; }

 private:
  const ColourImage& image_of(const MapOfTriangle& map) const {
    return scene_.images[scene_.textures[map.texture].image];
  }

  void add(const MapOfTriangle& map) {
    if (within_reach(map.uvs, image_of(map)))
      all_.push_back(map);
    else
      ++far_;
  }

  std::size_t place_of(unsigned level, MapKind kind) const {
    return std::size_t{level - options_.first} * std::size(map_kinds) + static_cast<std::size_t>(kind);
  }

  void bake(const MapOfTriangle& map, MapKind kind, unsigned level, MapValues& values) const {
    if (options_.stop) options_.stop();
    values.resize(values_of_map(kind, level));
    bakers_.at(map.texture).bake(map.uvs, kind, level, values);
  }

  void measure_image(std::size_t number) {
    const ColourImage& image = scene_.images[number];
    if (options_.progress) options_.progress(name(set_) + ", " + (image.name.empty() ? "image" : image.name));
    ++figures_.images;
    figures_.texels += std::uint64_t{image.width} * image.height;
    figures_.texture_bytes += bytes_of_value * image.width * image.height;
    const ImageTriangles of_image = image_triangles(scene_, number, all_, options_.stop);
    const std::vector<std::size_t>& maps = of_image.maps;
    const std::vector<std::uint8_t>& shown = of_image.shown;
    figures_.shown += of_image.texels_shown();
    const std::vector<std::uint8_t> original = compared_texels(image, set_, options_.averaging);
    tell_atlas(image, original, maps, of_image.corners, of_image.first);
    for (unsigned level = options_.first; level <= options_.last; ++level) {
      AttributePicture picture{image, set_, level, original, original, original, {}, {}};
      std::vector<std::uint8_t> nearest = original;
      for (const MapKind kind : map_kinds) {
        std::vector<std::uint8_t>& rgb = kind == MapKind::faces ? picture.faces : picture.vertices;
        std::vector<MapKey>& keys = keys_[place_of(level, kind)];
        std::vector<std::uint64_t> seen(all_.size());
        oneapi::tbb::parallel_for(std::size_t{0}, maps.size(), [&](std::size_t k) {
          if (same_[maps[k]] != maps[k]) return;
          thread_local MapValues values;
          bake(all_[maps[k]], kind, level, values);
          keys[maps[k]] = key_of(values);
          show(of_image, k, kind, level, values, rgb, nearest);
          if (kind == MapKind::faces) seen[maps[k]] = faces_with_centre(of_image.corners[k], level);
        });
        for (const std::size_t map : maps) {
          keys[map] = keys[same_[map]];
          if (kind == MapKind::faces) seen_faces_[level - options_.first] += seen[same_[map]];
        }
        const auto add = [&](ErrorSums& sums, const std::vector<std::uint8_t>& shows) {
          return add_errors(sums, image, set_, original, shows, shown, options_.threads);
        };
        (kind == MapKind::faces ? picture.face_errors : picture.vertex_errors) =
            add(sums_[place_of(level, kind)], rgb);
        if (kind == MapKind::vertices) add(nearest_sums_[place_of(level, kind)], nearest);
      }
      if (options_.picture && is_srgb(set_)) options_.picture(picture);
    }
    if (options_.texture_coder.compress) compress(image, original, shown);
  }

  void tell_atlas(const ColourImage& image, const std::vector<std::uint8_t>& original,
                  const std::vector<std::size_t>& maps, std::span<const TexelTriangle> triangles,
                  std::span<const std::uint32_t> first) const {
    if (!options_.atlas) return;
    std::vector<MapOfTriangle> of_image;
    for (const std::size_t k : maps) of_image.push_back(all_[k]);
    options_.atlas({set_, image, original, of_image, triangles, first});
  }

  /// Compresses an image at each size, and adds the results to those of the set's other images.
  void compress(const ColourImage& image, const std::vector<std::uint8_t>& original,
                const std::vector<std::uint8_t>& shown) {
    const TextureCoder& coder = options_.texture_coder;
    const CodeMeaning meaning(set_, options_.averaging);
    RgbTexels used{image.width, image.height, original};
    for (std::size_t k = 0; k < used.rgb.size(); ++k)
      if ((channels_ >> k % 3 & 1) == 0) used.rgb[k] = 0;
    std::size_t size = 0;
    for (std::uint32_t factor = 1; factor <= most_reduced; factor *= 2) {
      const std::vector<BlockSize>& blocks = factor == 1 ? coder.blocks : coder.reduced_blocks;
      if (blocks.empty()) continue;
      const RgbTexels small = factor == 1 ? used : reduced(used, factor, meaning);
      std::size_t block = 0;
      coder.compress(pixels_of(small), blocks, [&](const DecodedTexture& decoded) {
        if (options_.stop) options_.stop();
        if (block == blocks.size() || decoded.block != blocks[block] ||
            decoded.rgb.size() != small.rgb.size())
          throw std::invalid_argument(
              "attributes: a texture coder tells of the block sizes that it was given");
        measure_decoded(image, original, shown, size++, decoded, factor,
                        factor == 1 ? decoded.rgb
                                    : enlarged({small.width, small.height, decoded.rgb}, factor, image.width,
                                               image.height, meaning));
        ++block;
      });
      if (block != blocks.size())
        throw std::invalid_argument("attributes: a texture coder tells of all block sizes that it was given");
    }
  }

  TexturePixels pixels_of(const RgbTexels& texels) const {
    using impl::attribute::Meaning;
    TexturePixels pixels{texels.width, texels.height, texels.rgb, Meaning::linear};
    if (is_srgb(set_)) pixels.meaning = Meaning::srgb;
    if (meaning_of(set_, options_.averaging) == Meaning::normal) pixels.meaning = Meaning::normal;
    return pixels;
  }

  /// Adds an image at one size; `codes` are the decoded texels at full resolution.
  void measure_decoded(const ColourImage& image, const std::vector<std::uint8_t>& original,
                       const std::vector<std::uint8_t>& shown, std::size_t size,
                       const DecodedTexture& decoded, std::uint32_t factor,
                       const std::vector<std::uint8_t>& codes) {
    if (size == figures_.compressed.size()) {
      figures_.compressed.push_back({decoded.block, factor, 0, 0, {}});
      compressed_sums_.emplace_back();
    }
    std::vector<std::uint8_t> rgb = original;
    for (std::size_t k = 0; k < rgb.size(); ++k)
      if ((channels_ >> k % 3 & 1) != 0) rgb[k] = codes[k];
    make_unit(rgb, set_, options_.averaging);
    add_errors(compressed_sums_[size], image, set_, original, rgb, shown, options_.threads);
    const BlockSize covers{factor * decoded.block.width, factor * decoded.block.height};
    CompressedTextures& all = figures_.compressed[size];
    all.bytes += decoded.bytes;
    all.shown_bytes +=
        decoded.bytes / covers.blocks_of(image.width, image.height) * blocks_shown(image, covers, shown);
  }

  static std::uint64_t blocks_shown(const ColourImage& image, BlockSize block,
                                    const std::vector<std::uint8_t>& shown) {
    const std::uint64_t across = block.blocks_of(image.width, 1);
    std::vector<bool> seen(block.blocks_of(image.width, image.height));
    for (std::size_t texel = 0; texel < shown.size(); ++texel)
      if (shown[texel] != 0)
        seen[texel % image.width / block.width + texel / image.width / block.height * across] = true;
    return static_cast<std::uint64_t>(std::count(seen.begin(), seen.end(), true));
  }

  /// Paints the texels that triangle k of the image is the first to show.
  void show(const ImageTriangles& triangles, std::size_t k, MapKind kind, unsigned level,
            const MapValues& values, std::vector<std::uint8_t>& rgb,
            std::vector<std::uint8_t>& nearest) const {
    const CodeMeaning& meaning = bakers_.at(all_[triangles.maps[k]].texture).meaning();
    for_each_own_texel(triangles, k, [&](std::size_t texel, double u, double v) {
      if (kind == MapKind::faces) {
        paint(rgb, texel, values[face_index(level, u, v)], channels_);
        return;
      }
      const auto read = [&](MapReading reading) {
        return vertex_value(values, level, u, v, reading, meaning);
      };
      paint(rgb, texel, read(MapReading::interpolated), channels_);
      paint(nearest, texel, read(MapReading::nearest), channels_);
    });
  }

  /// The number of micro-triangles that contain a texel's centre.  The search ends once all do.
  static std::uint64_t faces_with_centre(const TexelTriangle& corners, unsigned level) {
    const std::uint64_t faces = values_of_map(MapKind::faces, level);
    std::vector<bool> has_centre(faces);
    std::uint64_t seen = 0;
    for_each_centre(corners, [&](std::int64_t, std::int64_t, double u, double v) {
      const std::size_t face = face_index(level, u, v);
      if (!has_centre[face]) ++seen;
      has_centre[face] = true;
      return seen < faces;
    });
    return seen;
  }

  MapError error_of(const ErrorSums& sums) const { return scene::error_of(sums, set_, figures_.shown); }

  MapsAtLevel at_level(unsigned level, MapKind kind) const {
    const std::size_t place = place_of(level, kind);
    MapsAtLevel at;
    at.level = level;
    at.kind = kind;
    std::vector<std::size_t> first;
    std::vector<MapKey> keys;
    for (std::size_t k = 0; k < all_.size(); ++k) {
      if (same_[k] != k) continue;
      first.push_back(k);
      keys.push_back(keys_[place][k]);
    }
    at.maps = shared(keys, [&](std::size_t k) {
      MapValues values;
      bake(all_[first[k]], kind, level, values);
      return values;
    });
    if (options_.packed || options_.stored) at.packed = packed(kind, level);
    if (options_.laid) tell_laid(kind, level);
    at.error = error_of(sums_[place]);
    if (kind == MapKind::vertices) {
      at.nearest = error_of(nearest_sums_[place]);
    } else {
      const double faces = static_cast<double>(all_.size()) * static_cast<double>(values_of_map(kind, level));
      if (faces != 0) at.unseen = 1 - static_cast<double>(seen_faces_[level - options_.first]) / faces;
    }
    return at;
  }

  void tell_laid(MapKind kind, unsigned level) const {
    LaidMaps laid{set_, level, kind, all_, {}, {}};
    lay(laid, keys_[place_of(level, kind)],
        [&](std::size_t k, MapValues& values) { bake(all_[k], kind, level, values); });
    if (!laid.values.empty()) options_.laid(laid);
  }

  std::optional<PackedBytes> packed(MapKind kind, unsigned level) const {
    MapPacker packer(kind, level, channels_, options_.packed_error);
    MapValues values;
    StoredAttributes stored{set_, {}};
    for (std::size_t k = 0; k < all_.size(); ++k) {
      if (same_[k] != k) {
        stored.maps.triangles.push_back(stored.maps.triangles[same_[k]]);
        continue;
      }
      bake(all_[k], kind, level, values);
      stored.maps.triangles.push_back({packer.add(values), 0});
    }
    if (options_.stored) {
      describe(kind, level, packer, stored.maps);
      options_.stored(stored);
    }
    return options_.packed ? packer.packed(options_.peer) : std::nullopt;
  }

  void describe(MapKind kind, unsigned level, const MapPacker& packer,
                impl::attribute::AttributeMaps& maps) const {
    using namespace impl::attribute;
    maps.at = kind == MapKind::faces ? MapAt::faces : MapAt::vertices;
    maps.tie = kind == MapKind::faces ? TieRule::vulkan : TieRule::none;
    maps.level = level;
    maps.components = channels_;
    maps.meaning = is_srgb(set_)                  ? Meaning::srgb
                   : has(set_, Attribute::normal) ? Meaning::normal
                                                  : Meaning::linear;
    maps.payload = Payload::packed;
    for (std::size_t c = 0; c < channels_of(maps); ++c) maps.error[c] = options_.packed_error;
    maps.maps = packer.maps();
    maps.codes = packer.codes();
  }

  const AttributeScene& scene_;
  const AttributeOptions& options_;
  AttributeSet set_;
  std::uint8_t channels_;
  AttributeSetFigures figures_;
  std::map<std::size_t, MapBaker> bakers_;  ///< by number of a texture of the scene
  std::vector<MapOfTriangle> all_;
  std::vector<std::size_t> same_;  ///< by triangle of all_: first_of_same_uvs()
  std::uint64_t far_ = 0;
  // Both are by place_of(): the keys of the maps, and the sums.
  std::vector<std::vector<MapKey>> keys_;
  std::vector<ErrorSums> sums_, nearest_sums_;
  std::vector<ErrorSums> compressed_sums_;  ///< by figures_.compressed
  std::vector<std::uint64_t> seen_faces_;
};

}  // namespace

std::uint64_t AttributeFigures::bytes(unsigned level, MapKind kind) const {
  std::uint64_t sum = 0;
  for (const AttributeSetFigures& set : sets)
    for (const MapsAtLevel& at : set.levels)
      if (at.level == level && at.kind == kind) sum += at.bytes();
  return sum;
}

unsigned AttributeFigures::level_beyond_textures(MapKind kind) const {
  if (sets.empty()) return no_level;
  const unsigned first = sets.front().levels.front().level, last = sets.front().levels.back().level;
  for (unsigned level = first; level <= last; ++level)
    if (bytes(level, kind) > texture_bytes) return level;
  const std::uint64_t maps = bytes(last, kind) / bytes_of_maps(1, kind, last);
  return std::max(last + 1, level_beyond(maps, kind, texture_bytes));
}

AttributeFigures measure(const AttributeScene& scene, const AttributeOptions& options) {
  if (options.first > options.last || options.last > finest_attribute_level)
    throw std::invalid_argument("attributes: levels up to " + std::to_string(finest_attribute_level));
  AttributeFigures figures;
  figures.file = scene.file;
  figures.triangles = scene.triangles;
  std::set<AttributeSet> sets;
  std::set<std::size_t> images;
  for (const AttributeTexture& texture : scene.textures) {
    sets.insert(texture.set);
    images.insert(texture.image);
  }
  figures.images = images.size();
  for (const std::size_t k : images)
    figures.texture_bytes += bytes_of_value * scene.images[k].width * scene.images[k].height;
  oneapi::tbb::task_arena arena(options.threads == 0 ? oneapi::tbb::task_arena::automatic
                                                     : static_cast<int>(options.threads));
  arena.execute([&] {
    for (const AttributeSet set : sets) {
      SetMeasurement measurement(scene, set, options);
      figures.sets.push_back(measurement.measured());
      figures.far += measurement.far();
    }
  });
  return figures;
}

}  // namespace mmverify::scene
