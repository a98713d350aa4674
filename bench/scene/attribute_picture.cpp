#include <algorithm>

#include "bench/scene/attribute_tables.hpp"

namespace mmverify::bench {
namespace {

using scene::AttributeFigures;
using scene::AttributeSetFigures;
using scene::MapKind;
using scene::MapsAtLevel;

/// The part of maps that a curve shows: faces; vertices, interpolated or the nearest.
enum class Shown { faces, interpolated, nearest };

picture::Series series_of(Shown shown) {
  using namespace picture;
  switch (shown) {
    case Shown::faces: return {.name = "faces", .colour = vermilion, .shape = Shape::square};
    case Shown::interpolated: return {.name = "vertices", .colour = blue, .shape = Shape::disc};
    case Shown::nearest: break;
  }
  return {.name = "vertices, the nearest", .colour = blue, .shape = Shape::circle};
}

/// A curve of an attribute set, a point a level; empty if no texel is shown.
template <class Coordinate>
picture::Series curve(const AttributeSetFigures& set, Shown shown, Coordinate coordinate) {
  picture::Series series = series_of(shown);
  for (const MapsAtLevel& at : set.levels) {
    const scene::MapError& error = shown == Shown::nearest ? *at.nearest : at.error;
    if ((at.kind == MapKind::faces) == (shown == Shown::faces) && error.rmse)
      series.points.push_back(coordinate(at, error));
  }
  return series;
}

/// Adds a curve of the set's textures in a format, a point a block size, if textures were compressed.
template <class Error>
void add_compressed(picture::Panel& panel, const AttributeSetFigures& set, const std::string& format,
                    Error error) {
  if (set.compressed.empty() || set.shown == 0) return;
  picture::Series series{
      .name = "texture in " + format, .colour = picture::green, .shape = picture::Shape::diamond};
  for (const scene::CompressedTextures& one : set.compressed)
    series.points.push_back(
        {static_cast<double>(one.bytes) / static_cast<double>(set.texture_bytes), error(one.error)});
  panel.series.push_back(series);
}

}  // namespace

picture::Picture scene_attribute_picture(const AttributeFigures& figures, const std::string& format) {
  using namespace picture;
  Picture drawn{.width = 1100, .height = 900};
  Panel bytes{.title = "All attributes",
              .x = {.title = "level of every triangle", .whole = true},
              .y = {.title = "bytes", .logarithmic = true},
              .key = Key::top_left,
              .thresholds = {{static_cast<double>(figures.texture_bytes), "textures"}}};
  for (const MapKind kind : scene::map_kinds) {
    Series series = series_of(kind == MapKind::faces ? Shown::faces : Shown::interpolated);
    for (const MapsAtLevel& at : figures.sets.front().levels)
      if (at.kind == kind)
        series.points.push_back(
            {static_cast<double>(at.level), static_cast<double>(figures.bytes(at.level, kind))});
    bytes.series.push_back(series);
  }
  const auto has_colours = [](const AttributeSetFigures& set) {
    return has(set.set, scene::Attribute::base_color);
  };
  // The panel beside it has the key; here it would lie on the textures' label.
  if (std::any_of(figures.sets.begin(), figures.sets.end(), has_colours)) bytes.key = Key::none;
  drawn.rows.push_back({bytes});
  for (const AttributeSetFigures& set : figures.sets) {
    if (!has_colours(set)) continue;
    Panel by_level{.title = "Base colour: FLIP in texture space",
                   .x = {.title = "level of every triangle", .whole = true},
                   .y = {.title = "mean FLIP", .least = 0},
                   .key = Key::top_right};
    Panel by_bytes{.title = "FLIP against memory",
                   .x = {.title = "bytes, of its textures", .logarithmic = true},
                   .y = {.title = "mean FLIP", .least = 0}};
    Panel squares{.title = "Root of the mean square against memory",
                  .x = {.title = "bytes, of its textures", .logarithmic = true},
                  .y = {.title = "RMSE, codes of 8 bits", .least = 0}};
    const auto share = [&set](const MapsAtLevel& at) {
      return static_cast<double>(at.bytes()) / static_cast<double>(set.texture_bytes);
    };
    for (const Shown shown : {Shown::faces, Shown::interpolated, Shown::nearest}) {
      by_level.series.push_back(curve(set, shown, [](const MapsAtLevel& at, const scene::MapError& error) {
        return Point{static_cast<double>(at.level), error.flip.value_or(0)};
      }));
      by_bytes.series.push_back(curve(set, shown, [&](const MapsAtLevel& at, const scene::MapError& error) {
        return Point{share(at), error.flip.value_or(0)};
      }));
      squares.series.push_back(curve(set, shown, [&](const MapsAtLevel& at, const scene::MapError& error) {
        return Point{share(at), *error.rmse};
      }));
    }
    add_compressed(by_bytes, set, format,
                   [](const scene::MapError& error) { return error.flip.value_or(0); });
    add_compressed(squares, set, format, [](const scene::MapError& error) { return *error.rmse; });
    drawn.rows.front().push_back(by_level);
    drawn.rows.push_back({by_bytes, squares});
    break;
  }
  return drawn;
}

}  // namespace mmverify::bench
