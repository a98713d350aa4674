#include "display/render/scene/path.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "display/render/vectors.hpp"

namespace mmverify::render {
namespace {

/// A sequence of pseudo-random numbers.
class Shares {
 public:
  explicit Shares(std::uint64_t seed) : state_(seed) {}
  float next() {
    state_ = mixed(state_);
    return static_cast<float>(state_ >> 40) * 0x1p-24f;
  }
  std::uint64_t below(std::uint64_t bound) {
    state_ = mixed(state_);
    return state_ % bound;
  }

 private:
  std::uint64_t state_;
};

bool gets_micromaps(const Geometry& geometry) { return geometry.surface.has_value() && geometry.planned; }

/// The number of triangles of an instance that get micromaps.
std::uint64_t count_of(const World& world, const Instance& instance) {
  std::uint64_t count = 0;
  for (const std::uint32_t g : world.meshes[instance.mesh])
    if (gets_micromaps(world.geometries[g])) count += world.geometries[g].triangles.size();
  return count;
}

/// The placed corners of triangle k, which counts the world's triangles that get micromaps.
std::array<Point, 3> placed_triangle(const World& world, std::uint64_t k) {
  for (const Instance& instance : world.instances) {
    const std::uint64_t count = count_of(world, instance);
    if (k >= count) {
      k -= count;
      continue;
    }
    for (const std::uint32_t g : world.meshes[instance.mesh]) {
      const Geometry& geometry = world.geometries[g];
      if (!gets_micromaps(geometry)) continue;
      if (k >= geometry.triangles.size()) {
        k -= geometry.triangles.size();
        continue;
      }
      const auto& t = geometry.triangles[k];
      return {placed(instance, geometry.positions[t[0]]), placed(instance, geometry.positions[t[1]]),
              placed(instance, geometry.positions[t[2]])};
    }
  }
  throw std::invalid_argument("seen_on_path: no such triangle");
}

Camera aimed(const World& world, std::uint64_t triangles, const Box& box, Shares shares, float aspect) {
  constexpr float turn = 6.2831853f, nearest = 5, least_half_angle = 0.35f, more = 0.4f;
  const std::array<Point, 3> corner = placed_triangle(world, shares.below(triangles));
  // The point is even over the triangle: the square's upper half is turned onto the lower.
  float u = shares.next(), v = shares.next();
  if (u + v > 1) u = 1 - u, v = 1 - v;
  const Point at =
      plus(corner[0], plus(times(minus(corner[1], corner[0]), u), times(minus(corner[2], corner[0]), v)));
  const Point extent = minus(box.high, box.low);
  const float distance = std::sqrt(dot(extent, extent)) * std::exp2(-1 - nearest * shares.next());
  const float z = 2 * shares.next() - 1, around = turn * shares.next(),
              r = std::sqrt(std::max(0.0f, 1 - z * z));
  const Point direction{r * std::cos(around), z, r * std::sin(around)};
  return looking(plus(at, times(direction, distance)), at, least_half_angle + more * shares.next(), aspect);
}

}  // namespace

CameraView seen_on_path(const World& world, const Tracer& tracer, const TraceOptions& trace,
                        std::uint64_t seed, std::uint64_t number) {
  std::uint64_t triangles = 0;
  for (const Instance& instance : world.instances) triangles += count_of(world, instance);
  if (triangles == 0) throw std::invalid_argument("seen_on_path: no triangle gets a micromap");
  const Box box = box_of(world, true);
  const float aspect = static_cast<float>(trace.width) / static_cast<float>(trace.height);
  CameraView seen;
  seen.number = number;
  for (unsigned k = 1; k <= most_tries; ++k) {
    seen.tries = k;
    seen.camera =
        aimed(world, triangles, box, Shares(mixed(seed) ^ mixed(number * (most_tries + 1) + k)), aspect);
    seen.frame = tracer.frame(seen.camera, nullptr, trace);
    if (seen.frame.counts.met != 0) break;
  }
  return seen;
}

Spread spread_of(std::span<const double> values) {
  if (values.empty()) return {};
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, *least, *most, std::sqrt(squares / count)};
}

PathRow held_against(const std::vector<CameraView>& path, const Tracer& tracer, const TraceOptions& trace,
                     const Opacity& opacity) {
  PathRow row;
  for (const CameraView& seen : path) {
    const Frame frame = tracer.frame(seen.camera, &opacity, trace);
    ++row.frames;
    row.pixels += frame.pixels.size();
    row.counts += frame.counts;
    row.calls_a_ray.push_back(calls_a_ray(frame.counts));
    row.times_texture.push_back(seen.frame.cpu_seconds > 0 ? frame.cpu_seconds / seen.frame.cpu_seconds : 0);
    const std::uint64_t here = differing(seen.frame, frame);
    row.differing += here;
    if (here == 0 || row.first) continue;
    for (std::uint32_t k = 0; k < frame.pixels.size() && !row.first; ++k)
      if (!same(seen.frame.pixels[k], frame.pixels[k]))
        row.first = PixelOf{seen.number, k % frame.width, k / frame.width};
  }
  return row;
}

Path along_path(const scene::Scene& scene, const scene::Plan& plan, const SceneWorld& world,
                const Tracer& tracer, const FormsOptions& forms, const TraceOptions& options,
                std::uint64_t seed, std::uint64_t cameras) {
  TraceOptions trace = options;
  trace.done = forms.done;
  const std::uint64_t pixels = std::uint64_t{trace.width} * trace.height * cameras;
  const auto begins = [&forms](const std::string& what, std::uint64_t of) {
    if (forms.begins) forms.begins(what, of);
  };
  TraceOptions untold = trace;
  if (forms.done) untold.done = [&forms](std::uint64_t) { forms.done(0); };
  Path path;
  begins("texture", pixels);
  for (std::uint64_t number = 1; number <= cameras; ++number)
    path.cameras.push_back(seen_on_path(world.world, tracer, trace, seed, number));
  path.left_out = each_forms(scene, plan, world, forms, [&](const FormsOfMaps& maps) {
    // The other load of the machine changes, so the texture is timed again beside each level.
    for (CameraView& seen : path.cameras)
      seen.frame.cpu_seconds = tracer.frame(seen.camera, nullptr, untold).cpu_seconds;
    for (const Form& form : maps.forms) {
      begins(std::string(name_of(form.method)) + (form.level ? " level " + std::to_string(*form.level) : ""),
             pixels);
      PathRow row = held_against(path.cameras, tracer, trace, *form.opacity);
      row.method = form.method;
      row.level = form.level;
      path.rows.push_back(row);
    }
  });
  return path;
}

}  // namespace mmverify::render
