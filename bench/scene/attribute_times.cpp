#include "bench/scene/attribute_times.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "bench/scene/attribute_tables.hpp"
#include "bench/scene/texture_sample.hpp"
#include "bench/timing.hpp"
#include "impl/attribute/lookup.hpp"

namespace mmverify::bench {
namespace {

using impl::attribute::VertexOrder;
using scene::AttributeScene;
using scene::MapKind;
using scene::MapOfTriangle;
using scene::SetMaps;

constexpr PointOrder orders[] = {PointOrder::scattered, PointOrder::along};

double area_in_texels(const AttributeScene& scene, const MapOfTriangle& triangle) {
  const scene::ColourImage& image = scene.images[scene.textures[triangle.texture].image];
  const auto [a, b, c] = scene::in_texels(triangle.uvs, image.width, image.height);
  return std::fabs((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2;
}

/// The sum of the values read, which keeps a compiler from omitting the reads.
template <class Read>
std::uint32_t sum_of(std::span<const SurfacePoint> points, const Read& read) {
  std::uint32_t sum = 0;
  for (const SurfacePoint& p : points) sum += read(p);
  return sum;
}

const char* name_of(LookupWay way) {
  switch (way) {
    case LookupWay::face: return "faces";
    case LookupWay::vertices_w_minor: return "vertices, W-minor";
    default: return "vertices, Bird";
  }
}

/// The values of all maps as RGBA8 words, map by map.
std::vector<std::uint32_t> words_of(const SetMaps& maps) {
  std::vector<std::uint32_t> words;
  words.reserve(maps.maps.values().size());
  for (const scene::MapValue& value : maps.maps.values())
    words.push_back(std::uint32_t{value[0]} | std::uint32_t{value[1]} << 8 | std::uint32_t{value[2]} << 16 |
                    std::uint32_t{value[3]} << 24);
  return words;
}

/// The words of maps of vertices, moved from rows into the Bird order.
std::vector<std::uint32_t> in_bird_order(const SetMaps& maps, std::span<const std::uint32_t> words) {
  const auto size = static_cast<std::size_t>(scene::values_of_map(maps.kind, maps.level));
  std::vector<std::uint32_t> row(size), values(words.size());
  std::iota(row.begin(), row.end(), 0u);
  impl::attribute::convert(VertexOrder::bird, VertexOrder::w_minor, row, maps.level, row);
  for (std::size_t map = 0; map < values.size(); map += size)
    for (std::size_t x = 0; x < size; ++x) values[map + x] = words[map + row[x]];
  return values;
}

}  // namespace

std::vector<SurfacePoint> surface_points(const AttributeScene& scene,
                                         std::span<const MapOfTriangle> triangles, std::size_t count,
                                         std::uint64_t seed) {
  std::vector<double> areas;
  for (const MapOfTriangle& triangle : triangles) areas.push_back(area_in_texels(scene, triangle));
  if (std::all_of(areas.begin(), areas.end(), [](double area) { return area == 0; }))
    areas.assign(areas.size(), 1);
  std::mt19937_64 engine(seed);
  std::discrete_distribution<std::uint32_t> any(areas.begin(), areas.end());
  constexpr std::uint32_t one = std::uint32_t{1} << 24;
  std::vector<SurfacePoint> points;
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint32_t triangle = any(engine);
    // Multiples of 2^-24, so that the fold is exact.
    auto u = static_cast<std::uint32_t>(engine() >> 40), v = static_cast<std::uint32_t>(engine() >> 40);
    if (u + v > one) u = one - u, v = one - v;
    points.push_back({triangle, static_cast<float>(u) * 0x1p-24f, static_cast<float>(v) * 0x1p-24f});
  }
  return points;
}

std::vector<SurfacePoint> along_surfaces(std::vector<SurfacePoint> points) {
  const auto place = [](const SurfacePoint& p) {
    return std::pair(p.triangle, impl::index::from_barycentrics(p.u, p.v, 8));
  };
  std::stable_sort(points.begin(), points.end(),
                   [&](const SurfacePoint& a, const SurfacePoint& b) { return place(a) < place(b); });
  return points;
}

void AttributeTimer::take(const SetMaps& maps) {
  const scene::SetTriangles& triangles = maps.triangles;
  if (!points_.contains(triangles.set())) {
    auto& [scattered, along] = points_[triangles.set()];
    scattered = surface_points(scene_, triangles.all(), options_.points, options_.seed);
    along = along_surfaces(scattered);
  }
  const std::vector<std::uint32_t> words = words_of(maps);
  if (maps.kind == MapKind::faces) {
    take(maps, LookupWay::face, words);
    return;
  }
  take(maps, LookupWay::vertices_w_minor, words);
  take(maps, LookupWay::vertices_bird, in_bird_order(maps, words));
}

void AttributeTimer::take(const SetMaps& maps, LookupWay way, std::span<const std::uint32_t> values) {
  const auto size = static_cast<std::size_t>(scene::values_of_map(maps.kind, maps.level));
  std::vector<std::size_t> first;  // by triangle: its map begins at values[first]
  for (const std::uint32_t number : maps.number) first.push_back(number * size);
  std::vector<TextureSample> samples;
  for (const scene::AttributeTexture& texture : scene_.textures)
    samples.emplace_back(scene_.images[texture.image], texture.sampler);
  const auto in_texture = [&](const SurfacePoint& p) {
    const MapOfTriangle& triangle = maps.triangles.all()[p.triangle];
    const auto& [a, b, c] = triangle.uvs;
    const float w = 1 - p.u - p.v;
    return samples[triangle.texture].at(w * a[0] + p.u * b[0] + p.v * c[0],
                                        w * a[1] + p.u * b[1] + p.v * c[1]);
  };
  const auto face = [&](const SurfacePoint& p) {
    return values[first[p.triangle] + impl::index::from_barycentrics(p.u, p.v, maps.level)];
  };
  const auto between = [&](VertexOrder order) {
    return [&, order](const SurfacePoint& p) {
      return impl::attribute::interpolated_rgba8(order, values.subspan(first[p.triangle], size), p.u, p.v,
                                                 maps.level);
    };
  };
  LookupTimes times{maps.triangles.set(), maps.level, way, options_.points, {}};
  for (std::size_t order = 0; order < times.by_order.size(); ++order) {
    const std::vector<SurfacePoint>& points = points_.at(maps.triangles.set())[order];
    std::vector<double> texture, map;
    const auto round = [&](const auto& read) {
      return once_ns([&] { benchmark::DoNotOptimize(sum_of(points, read)); });
    };
    const auto rounds = [&](const auto& read) {
      for (std::size_t k = 0; k < options_.rounds; ++k) {
        texture.push_back(round(in_texture));
        map.push_back(round(read));
      }
    };
    if (way == LookupWay::face)
      rounds(face);
    else if (way == LookupWay::vertices_w_minor)
      rounds(between(VertexOrder::w_minor));
    else
      rounds(between(VertexOrder::bird));
    const auto count = static_cast<double>(points.size());
    times.by_order[order] = {median(texture) / count, median(map) / count};
  }
  times_.push_back(times);
}

Table attribute_times_table(const std::vector<LookupTimes>& times) {
  using L = LookupTimes;
  Fields<L> fields{
      {{.key = set_key(), .heading = "attributes", .leads = true},
       [](const L& l) { return scene::name(l.set); }},
      {{.key = level(10), .heading = "level", .leads = true},
       [](const L& l) { return std::uint64_t{l.level}; }},
      {{.key = one_of("maps", no_rule, {"faces", "vertices, W-minor", "vertices, Bird"},
                      "faces: the value of the point's micro-triangle; vertices: interpolated between three, "
                      "stored in that order"),
        .heading = "maps of",
        .leads = true},
       [](const L& l) -> Value { return std::string(name_of(l.way)); }},
      {{positive("points", no_rule, "drawn on the triangles by their areas in texels"), "points"},
       [](const L& l) { return l.points; }},
  };
  for (const PointOrder order : orders) {
    const std::string group = order == PointOrder::scattered ? "scattered" : "along", in = group + ".";
    const auto of = [order](const L& l) { return l.by_order[static_cast<std::size_t>(order)]; };
    fields.push_back(
        note<L>(object(group, no_rule,
                       order == PointOrder::scattered ? "points as drawn, each on another triangle"
                                                      : "the same triangle by triangle, along the curve")));
    fields.push_back(
        {{number(in + "texture_ns", no_rule,
                 "of a point: its texture coordinates between the corners', four texels, bilinear"),
          "texture", "ns", plain, group},
         [of](const L& l) { return of(l).texture_ns; }});
    fields.push_back(
        {{number(in + "map_ns", no_rule, "of a point: its micro-triangle, and the map's value there"), "map",
          "ns", plain, group},
         [of](const L& l) { return of(l).map_ns; }});
    fields.push_back(
        {{number(in + "map_to_texture", no_rule, "map_ns / texture_ns"), "map to texture", "", plain, group},
         [of](const L& l) { return of(l).map_ns / of(l).texture_ns; }});
  }
  return table_of<L>({.key = list("times",
                                  "a lookup at a point of the set's triangles, in the texture and in its "
                                  "map, one thread; not there without --time, nor of maps of over 1 GiB",
                                  {2}, left_out)
                                 .if_any(),
                      .caption = "a lookup at a point, in the texture and in its map"},
                     fields, times);
}

namespace {

picture::Series series_of(LookupWay way) {
  using namespace picture;
  switch (way) {
    case LookupWay::face: return {.name = name_of(way), .colour = vermilion, .shape = Shape::square};
    case LookupWay::vertices_w_minor: return {.name = name_of(way), .colour = blue, .shape = Shape::disc};
    case LookupWay::vertices_bird: break;
  }
  return {.name = name_of(way), .colour = purple, .shape = Shape::triangle};
}

}  // namespace

std::vector<picture::Panel> error_against_time(const scene::AttributeFigures& figures,
                                               const std::vector<LookupTimes>& times) {
  using namespace picture;
  const auto set = std::find_if(figures.sets.begin(), figures.sets.end(), [](const auto& one) {
    return has(one.set, scene::Attribute::base_color) && one.shown != 0;
  });
  if (set == figures.sets.end()) return {};
  const auto error_of = [&](const LookupTimes& of) {
    const auto kind = of.way == LookupWay::face ? scene::MapKind::faces : scene::MapKind::vertices;
    return std::find_if(set->levels.begin(), set->levels.end(),
                        [&](const scene::MapsAtLevel& at) { return at.level == of.level && at.kind == kind; })
        ->error.rmse.value_or(0);
  };
  std::vector<Panel> panels;
  for (const PointOrder order : orders) {
    Panel panel{.title = order == PointOrder::scattered
                             ? "Base colour: error against run time, scattered points"
                             : "Base colour: error against run time, points along",
                .x = {.title = "ns a lookup", .least = 0},
                .y = {.title = "RMSE, codes of 8 bits", .logarithmic = true},
                .key = Key::top_right};
    std::vector<double> of_texture;
    for (const LookupWay way : {LookupWay::face, LookupWay::vertices_w_minor, LookupWay::vertices_bird}) {
      Series series = series_of(way);
      for (const LookupTimes& of : times) {
        if (of.set != set->set || of.way != way) continue;
        const TimesOfOrder& its = of.by_order[static_cast<std::size_t>(order)];
        of_texture.push_back(its.texture_ns);
        // Low levels take the same time, and level 0 has no order, so not every label has room.
        const bool named = of.level % 2 == 0 && (of.level != 0 || way != LookupWay::vertices_bird);
        series.points.push_back({its.map_ns, error_of(of), named ? std::to_string(of.level) : std::string()});
      }
      panel.series.push_back(std::move(series));
    }
    if (of_texture.empty()) return {};
    panel.series.push_back(
        {.name = "texture", .colour = green, .shape = Shape::diamond, .points = {{median(of_texture), 0}}});
    panels.push_back(std::move(panel));
  }
  return panels;
}

}  // namespace mmverify::bench
