#include "scene/attribute/measure.hpp"

#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "scene/attribute/map_reading.hpp"
#include "scene/attribute/reduced_texture.hpp"

namespace mmverify::scene {
namespace {

/// The most values of maps of a kind and level that are kept if no receiver asks for them, 256 MiB.
constexpr std::uint64_t most_values_to_compare = std::uint64_t{1} << 26;

/// The number of micro-triangles that contain a texel's centre.  The search ends once all do.
std::uint64_t faces_with_centre(const TexelTriangle& corners, unsigned level) {
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

/// The maps of a kind and level, and the sums of their errors.
struct MeasuredMaps {
  SetMaps maps;
  ErrorSums sums, nearest_sums;
  std::uint64_t seen_faces = 0;  ///< micro-triangles with a texel's centre
};

/// The measurement of one attribute set of a scene: its maps, image by image.
class SetMeasurement {
 public:
  SetMeasurement(const AttributeScene& scene, AttributeSet set, const AttributeOptions& options)
      : scene_(scene),
        options_(options),
        triangles_(scene, set, options.averaging, options.stop),
        compression_(set, options.averaging, options.texture_coder, options.threads, options.stop) {
    const std::uint64_t most = options.kept ? most_kept_values : most_values_to_compare;
    for (unsigned level = options.first; level <= options.last; ++level)
      for (const MapKind kind : map_kinds) measured_.push_back({{triangles_, kind, level, most}, {}, {}});
    figures_.set = set;
    figures_.triangles = triangles_.all().size();
  }

  AttributeSetFigures measured() {
    for (const std::size_t image : triangles_.images()) measure_image(image);
    figures_.compressed = compression_.all(figures_.shown);
    for (const MeasuredMaps& maps : measured_) figures_.levels.push_back(figures_of(maps));
    return figures_;
  }

  std::uint64_t left_out() const { return triangles_.left_out(); }

 private:
  AttributeSet set() const { return triangles_.set(); }

  void measure_image(std::size_t number) {
    const ColourImage& image = scene_.images[number];
    if (options_.progress)
      options_.progress(name(set()) + ", " + (image.name.empty() ? "image" : image.name));
    ++figures_.images;
    figures_.texels += std::uint64_t{image.width} * image.height;
    figures_.texture_bytes += bytes_of_value * image.width * image.height;
    const ComparedImage compared = compared_image(triangles_, number, options_.averaging, options_.stop);
    figures_.shown += compared.triangles.texels_shown();
    for (std::size_t k = 0; k < measured_.size(); k += std::size(map_kinds))
      measure_level(image, compared, measured_[k], measured_[k + 1]);
    if (options_.atlas)
      options_.atlas({image, compared, measured_[measured_.size() - 2].maps, measured_.back().maps});
    if (options_.texture_coder.compress) compression_.add(image, compared);
  }

  /// Bakes an image's maps of a level, and compares their texels with the texture's.
  void measure_level(const ColourImage& image, const ComparedImage& compared, MeasuredMaps& faces,
                     MeasuredMaps& vertices) {
    const std::vector<std::uint8_t>& original = compared.original;
    AttributePicture picture{image, set(), faces.maps.level, original, original, original, {}, {}};
    std::vector<std::uint8_t> nearest = original;
    bake(compared.triangles, faces, picture.faces, nearest);
    bake(compared.triangles, vertices, picture.vertices, nearest);
    const auto add = [&](ErrorSums& sums, const std::vector<std::uint8_t>& shows) {
      return add_errors(sums, image, set(), original, shows, compared.triangles.shown, options_.threads);
    };
    picture.face_errors = add(faces.sums, picture.faces);
    picture.vertex_errors = add(vertices.sums, picture.vertices);
    add(vertices.nearest_sums, nearest);
    if (options_.picture && is_srgb(set())) options_.picture(picture);
  }

  /// Bakes the maps of an image's triangles, each place in the texture once, and paints the texels that they show.
  void bake(const ImageTriangles& of_image, MeasuredMaps& measured, std::vector<std::uint8_t>& rgb,
            std::vector<std::uint8_t>& nearest) {
    SetMaps& maps = measured.maps;
    std::vector<std::size_t> places, owners;  // numbers in the image, and in the set
    for (std::size_t k = 0; k < of_image.maps.size(); ++k)
      if (triangles_.same(of_image.maps[k]) == of_image.maps[k]) {
        places.push_back(k);
        owners.push_back(of_image.maps[k]);
      }
    std::vector<std::uint64_t> seen(triangles_.all().size());
    const std::vector<std::uint32_t> numbers =
        maps.maps.add(owners, [&](std::size_t k, std::span<const MapValue> map) {
          show(of_image, places[k], maps, map, rgb, nearest);
          if (maps.kind == MapKind::faces)
            seen[owners[k]] = faces_with_centre(of_image.corners[places[k]], maps.level);
        });
    for (std::size_t k = 0; k < owners.size(); ++k) maps.number[owners[k]] = numbers[k];
    for (const std::size_t triangle : of_image.maps) {
      maps.number[triangle] = maps.number[triangles_.same(triangle)];
      measured.seen_faces += seen[triangles_.same(triangle)];
    }
  }

  /// Paints the texels that triangle k of the image is the first to show.
  void show(const ImageTriangles& triangles, std::size_t k, const SetMaps& maps,
            std::span<const MapValue> map, std::vector<std::uint8_t>& rgb,
            std::vector<std::uint8_t>& nearest) const {
    for_each_own_texel(triangles, k, [&](std::size_t texel, double u, double v) {
      if (maps.kind == MapKind::faces) {
        paint(rgb, texel, map[face_index(maps.level, u, v)], triangles_.channels());
        return;
      }
      const auto read = [&](MapReading reading) {
        return vertex_value(map, maps.level, u, v, reading, triangles_.meaning());
      };
      paint(rgb, texel, read(MapReading::interpolated), triangles_.channels());
      paint(nearest, texel, read(MapReading::nearest), triangles_.channels());
    });
  }

  MapsAtLevel figures_of(const MeasuredMaps& measured) const {
    const SetMaps& maps = measured.maps;
    MapsAtLevel at;
    at.level = maps.level;
    at.kind = maps.kind;
    at.distinct = maps.maps.count();
    at.constant = maps.maps.constant();
    at.error = error_of(measured.sums, set(), figures_.shown);
    if (maps.kind == MapKind::vertices) {
      at.nearest = error_of(measured.nearest_sums, set(), figures_.shown);
    } else {
      const double faces =
          static_cast<double>(maps.number.size()) * static_cast<double>(values_of_map(maps.kind, maps.level));
      if (faces != 0) at.unseen = 1 - static_cast<double>(measured.seen_faces) / faces;
    }
    if (options_.packed || options_.stored) at.packed = packed(maps);
    if (options_.kept && maps.maps.kept() && maps.maps.count() != 0) options_.kept(maps);
    return at;
  }

  std::optional<PackedBytes> packed(const SetMaps& maps) const {
    StoredAttributes stored{set(), coded(maps, options_.packed_error), {}};
    const bool few = stored.maps.codes.size() >> 31 == 0;
    if (few) stored.packed = impl::attribute::pack(impl::attribute::shape_of(stored.maps), stored.maps.codes);
    if (options_.stored) options_.stored(stored);
    if (!options_.packed || !few) return std::nullopt;
    return packed_bytes(stored.maps, stored.packed, options_.peer);
  }

  const AttributeScene& scene_;
  const AttributeOptions& options_;
  SetTriangles triangles_;
  TextureCompression compression_;
  std::vector<MeasuredMaps> measured_;  ///< by level, faces before vertices
  AttributeSetFigures figures_;
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
      figures.far += measurement.left_out();
      if (options.so_far) options.so_far(figures, sets.size() - figures.sets.size());
    }
  });
  return figures;
}

}  // namespace mmverify::scene
