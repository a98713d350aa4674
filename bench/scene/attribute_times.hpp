// Times of lookups at points of a scene's triangles, in its textures and in the maps that replace them.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "bench/picture.hpp"
#include "bench/table.hpp"
#include "scene/attribute/measure.hpp"
#include "scene/attribute/set_maps.hpp"

namespace mmverify::bench {

/// A point of a triangle, by its barycentrics there: u + v <= 1.
struct SurfacePoint {
  std::uint32_t triangle;
  float u, v;
};

/// The order in which points are looked up.
enum class PointOrder : std::uint8_t {
  scattered,  ///< as drawn, each on another triangle, like rays that bounced
  along,      ///< triangle by triangle, along the curve of level 8, like neighbouring pixels
};

/// The value that is read at a point.
enum class LookupWay : std::uint8_t {
  face,              ///< the micro-triangle's value
  vertices_w_minor,  ///< interpolated between its three vertices, which are stored in W-minor order
  vertices_bird,     ///< the same, in the Bird order
};

/// The times of one order of points: one thread, processor time, the median of the rounds.
struct TimesOfOrder {
  double texture_ns = 0;  ///< a point: its texture coordinates between the corners', then TextureSample
  double map_ns = 0;      ///< a point: its micro-triangle, the map's value there
};

struct LookupTimes {
  scene::AttributeSet set = 0;
  unsigned level = 0;
  LookupWay way = LookupWay::face;
  std::uint64_t points = 0;
  std::array<TimesOfOrder, 2> by_order;  ///< by PointOrder
};

struct AttributeTimesOptions {
  std::size_t points = std::size_t{1} << 18, rounds = 5;
  std::uint64_t seed = 1;
};

/// Random points, uniform on each triangle, with as many on a triangle as its area in texels demands.  If no
/// triangle has an area, all triangles are equally likely.  The same points for the same seed and triangles.
/// Domain: a triangle at least, at most 2^32 - 1.
std::vector<SurfacePoint> surface_points(const scene::AttributeScene& scene,
                                         std::span<const scene::MapOfTriangle> triangles, std::size_t count,
                                         std::uint64_t seed);
std::vector<SurfacePoint> along_surfaces(std::vector<SurfacePoint> points);

/// A timer that measures each set of maps as it is baked (AttributeOptions::kept).
/// Both ways of a row take turns, round by round.  The values of maps and textures are RGBA8, without sRGB,
/// mips or blocks.  Source: Color and Attribute Micromaps, 6.2, figure 10, which has frames of a GPU.
class AttributeTimer {
 public:
  /// The scene must outlive the timer.
  AttributeTimer(const scene::AttributeScene& scene, const AttributeTimesOptions& options)
      : scene_(scene), options_(options) {}

  /// Domain: maps that are kept(), of a triangle at least.
  void take(const scene::SetMaps& maps);
  const std::vector<LookupTimes>& times() const { return times_; }

 private:
  void take(const scene::SetMaps& maps, LookupWay way, std::span<const std::uint32_t> values);

  const scene::AttributeScene& scene_;
  AttributeTimesOptions options_;
  std::map<scene::AttributeSet, std::array<std::vector<SurfacePoint>, 2>> points_;  ///< by PointOrder
  std::vector<LookupTimes> times_;
};

Table attribute_times_table(const std::vector<LookupTimes>& times);

/// Error against run time: a panel for each order of points, of the first set of base colours.  A curve is a way of
/// lookups, a point a level; labels name the even ones; the texture is a point without error, at its median over the levels.
/// Empty without such a set, or without times of it.
/// Domain: times of these figures.
std::vector<picture::Panel> error_against_time(const scene::AttributeFigures& figures,
                                               const std::vector<LookupTimes>& times);

}  // namespace mmverify::bench
