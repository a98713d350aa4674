#include "scene/attribute/planned_maps.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <map>
#include <set>
#include <stdexcept>

#include "impl/attribute/error.hpp"
#include "impl/attribute/plan.hpp"
#include "scene/attribute/image_triangles.hpp"
#include "scene/attribute/map_reading.hpp"
#include "scene/attribute/reduced_texture.hpp"

namespace mmverify::scene {
namespace {

using impl::attribute::Neighbours;
using impl::attribute::no_neighbour;
using impl::attribute::TrianglePlan;
using MapValues = std::vector<MapValue>;

/// Sums of squares over the texels whose centre a triangle shows: for its single value, and for its maps by
/// level.
struct TriangleErrors {
  const std::vector<std::uint8_t>* original = nullptr;  ///< the texels of its image
  std::uint64_t texels = 0;
  double of_value = 0;
  std::vector<double> of_level;                                       ///< from the first level on
  std::map<std::pair<std::uint32_t, std::uint8_t>, double> of_edges;  ///< by level and decimated edges
};

/// The planner of one attribute set of a scene, with maps of one kind.
class SetPlanner {
 public:
  SetPlanner(const AttributeScene& scene, AttributeSet set, MapKind kind, const AttributeOptions& options)
      : scene_(scene),
        options_(options),
        triangles_(scene, set, options.averaging, options.stop),
        kind_(kind) {
    add_neighbours();
    for (const std::size_t image : triangles_.images())
      images_.push_back(compared_image(triangles_, image, options.averaging, options.stop));
    if (options.progress)
      options.progress(name(set) + (kind == MapKind::faces ? ", plans of faces" : ", plans of vertices"));
    measure_triangles();
  }

  PlannedMaps planned(double wanted) {
    PlannedMaps figures;
    figures.set = set();
    figures.kind = kind_;
    figures.wanted = wanted;
    figures.triangles = triangles_.all().size();
    for (unsigned level = options_.first; level <= options_.last; ++level)
      figures.levels.push_back({.level = level});
    const std::vector<TrianglePlan> plan = impl::attribute::plan(
        {neighbours_, options_.last, [&](std::size_t t) { return keeps(t, errors_of(t).of_value, wanted); },
         [&](std::size_t t, std::uint32_t level, std::uint8_t edges) {
           return level >= options_.first && keeps(t, squares(t, level, edges), wanted);
         }});
    count(plan, figures);
    share(plan, figures);
    ErrorSums sums;
    std::uint64_t shown = 0;
    for (const ComparedImage& image : images_) {
      add_image_errors(plan, image, sums);
      shown += image.triangles.texels_shown();
    }
    figures.error = error_of(sums, set(), shown);
    return figures;
  }

 private:
  AttributeSet set() const { return triangles_.set(); }
  const TriangleErrors& errors_of(std::size_t t) const { return errors_[triangles_.same(t)]; }

  /// Neighbours share vertices of a primitive; faces have no neighbours.
  void add_neighbours() {
    for (const std::vector<Triangle>& primitive : triangles_.primitives()) {
      const auto begin = static_cast<std::int32_t>(neighbours_.size());
      if (kind_ == MapKind::faces) {
        neighbours_.resize(neighbours_.size() + primitive.size(), {no_neighbour, no_neighbour, no_neighbour});
        continue;
      }
      for (Neighbours neighbours : impl::attribute::neighbours_of(primitive)) {
        for (std::int32_t& n : neighbours)
          if (n != no_neighbour) n += begin;
        neighbours_.push_back(neighbours);
      }
    }
  }

  /// Computes each triangle's errors at each level, with no edge decimated.
  void measure_triangles() {
    errors_.resize(triangles_.all().size());
    for (const ComparedImage& image : images_)
      oneapi::tbb::parallel_for(std::size_t{0}, image.triangles.maps.size(), [&](std::size_t k) {
        const std::size_t t = image.triangles.maps[k];
        if (triangles_.same(t) != t) return;
        TriangleErrors& errors = errors_[t];
        errors.original = &image.original;
        const MapValue value = value_of(t);
        errors.of_value = squares_of(t, [&](double, double) {
          ++errors.texels;
          return value;
        });
        for (unsigned level = options_.first; level <= options_.last; ++level)
          errors.of_level.push_back(squares_of_map(t, level, 0));
      });
  }

  /// The sum over the texels whose centre the triangle shows; shows(u, v) is the value that is seen there.
  template <class Shows>
  double squares_of(std::size_t t, Shows shows) const {
    const ColourImage& image = triangles_.image_of(t);
    const std::vector<std::uint8_t>& original = *errors_of(t).original;
    double sum = 0;
    for_each_texel(image, triangles_.sampler_of(t),
                   in_texels(triangles_.all()[t].uvs, image.width, image.height),
                   [&](std::size_t texel, double u, double v) {
                     const MapValue seen = shows(u, v);
                     for (std::size_t c = 0; c < 3; ++c) {
                       const double difference =
                           (triangles_.channels() >> c & 1) != 0 ? seen[c] - original[3 * texel + c] : 0;
                       sum += difference * difference;
                     }
                   });
    return sum;
  }

  double squares_of_map(std::size_t t, unsigned level, std::uint8_t edges) const {
    const MapValues values = map_of(t, level, edges);
    return squares_of(t, [&](double u, double v) { return shown_at(values, level, u, v); });
  }

  MapValue shown_at(const MapValues& values, unsigned level, double u, double v) const {
    if (kind_ == MapKind::faces) return values[face_index(level, u, v)];
    return vertex_value(values, level, u, v, MapReading::interpolated, triangles_.meaning());
  }

  MapValues map_of(std::size_t t, unsigned level, std::uint8_t edges) const {
    MapValues values;
    triangles_.bake(t, kind_, level, values);
    if (edges != 0)
      impl::attribute::decimate_edges(level, edges, meaning_of(set(), options_.averaging), values);
    return values;
  }

  /// The single value of a triangle: the mean of the texels under it.
  MapValue value_of(std::size_t t) const {
    MapValues values;
    triangles_.bake(t, MapKind::faces, 0, values);
    return values.front();
  }

  double squares(std::size_t t, std::uint32_t level, std::uint8_t edges) {
    TriangleErrors& errors = errors_[triangles_.same(t)];
    if (edges == 0) return errors.of_level[level - options_.first];
    const auto [at, fresh] = errors.of_edges.try_emplace({level, edges}, 0);
    if (fresh) at->second = squares_of_map(t, level, edges);
    return at->second;
  }

  bool keeps(std::size_t t, double squares, double wanted) const {
    return squares <=
           wanted * wanted * static_cast<double>(errors_of(t).texels) * std::popcount(triangles_.channels());
  }

  void count(const std::vector<TrianglePlan>& plan, PlannedMaps& figures) {
    std::set<MapValue> palette;
    for (std::size_t t = 0; t < plan.size(); ++t) {
      if (plan[t].special) {
        ++figures.special;
        palette.insert(value_of(t));
        continue;
      }
      unsigned lowest = options_.first;
      while (lowest < options_.last && !keeps(t, squares(t, lowest, 0), figures.wanted)) ++lowest;
      ++figures.levels[lowest - options_.first].lowest;
      PlannedLevel& at = figures.levels[plan[t].level - options_.first];
      ++at.planned;
      at.decimated += plan[t].decimated != 0;
      figures.not_kept += !plan[t].kept;
    }
    figures.palette = palette.size();
  }

  /// Counts the distinct maps of each level.
  void share(const std::vector<TrianglePlan>& plan, PlannedMaps& figures) const {
    for (PlannedLevel& at : figures.levels) {
      std::vector<std::size_t> triangles;
      std::set<std::pair<std::size_t, std::uint8_t>> known;
      for (std::size_t t = 0; t < plan.size(); ++t)
        if (!plan[t].special && plan[t].level == at.level &&
            known.emplace(triangles_.same(t), plan[t].decimated).second)
          triangles.push_back(t);
      DistinctMaps maps(values_of_map(kind_, at.level), most_kept_values,
                        [&](std::size_t t, MapValues& map) { map = map_of(t, at.level, plan[t].decimated); });
      maps.add(triangles);
      at.distinct = maps.count();
    }
  }

  /// Adds the errors of the triangles on an image; a texel that several show belongs to the first of them.
  void add_image_errors(const std::vector<TrianglePlan>& plan, const ComparedImage& image,
                        ErrorSums& sums) const {
    const ImageTriangles& triangles = image.triangles;
    const ColourImage& texels = scene_.images[triangles.image];
    std::vector<std::uint8_t> rgb = image.original;
    oneapi::tbb::parallel_for(std::size_t{0}, triangles.maps.size(), [&](std::size_t k) {
      if (triangles.begin[k] == triangles.begin[k + 1]) return;
      const std::size_t t = triangles.maps[k];
      const TrianglePlan& p = plan[t];
      const MapValues values = p.special ? MapValues{value_of(t)} : map_of(t, p.level, p.decimated);
      for_each_own_texel(triangles, k, [&](std::size_t texel, double u, double v) {
        paint(rgb, texel, p.special ? values.front() : shown_at(values, p.level, u, v),
              triangles_.channels());
      });
    });
    add_errors(sums, texels, set(), image.original, rgb, triangles.shown, options_.threads);
  }

  const AttributeScene& scene_;
  const AttributeOptions& options_;
  SetTriangles triangles_;
  MapKind kind_;
  std::vector<Neighbours> neighbours_;  ///< by triangle
  std::vector<TriangleErrors> errors_;  ///< by triangle, filled in for the first one of each place
  std::vector<ComparedImage> images_;
};

}  // namespace

std::uint64_t PlannedMaps::maps() const { return triangles - special; }

std::uint64_t PlannedMaps::distinct() const {
  std::uint64_t sum = 0;
  for (const PlannedLevel& at : levels) sum += at.distinct;
  return sum;
}

std::uint64_t PlannedMaps::value_bytes() const {
  std::uint64_t sum = bytes_of_value * palette;
  for (const PlannedLevel& at : levels) sum += bytes_of_maps(at.distinct, kind, at.level);
  return sum;
}

std::vector<PlannedMaps> planned_maps(const AttributeScene& scene, const AttributeOptions& options,
                                      std::span<const double> wanted) {
  if (options.first > options.last || options.last > finest_attribute_level)
    throw std::invalid_argument("attributes: levels up to " + std::to_string(finest_attribute_level));
  if (!std::all_of(wanted.begin(), wanted.end(), [](double error) { return error >= 0; }))
    throw std::invalid_argument("attributes: a plan keeps an error of 0 or more");
  std::set<AttributeSet> sets;
  for (const AttributeTexture& texture : scene.textures) sets.insert(texture.set);
  std::vector<PlannedMaps> all;
  oneapi::tbb::task_arena arena(options.threads == 0 ? oneapi::tbb::task_arena::automatic
                                                     : static_cast<int>(options.threads));
  arena.execute([&] {
    for (const AttributeSet set : sets)
      for (const MapKind kind : map_kinds) {
        SetPlanner planner(scene, set, kind, options);
        for (const double error : wanted) all.push_back(planner.planned(error));
      }
  });
  return all;
}

}  // namespace mmverify::scene
