#include "display/render/tracer.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "display/render/embree.hpp"
#include "display/render/vectors.hpp"
#include "impl/traverse/decision.hpp"

namespace mmverify::render {
namespace {

/// The geometry that a filter function is called for.
struct Filtered {
  const Geometry* geometry;
  const Surface* surface;
  std::uint32_t number;
};

/// A ray's hits that blend, and the rules of blending.
struct Gathering {
  const Blending& blending;
  std::vector<impl::traverse::Hit> hits = {};
  std::vector<Met> met = {};  ///< the same hits, to find one that is reported twice
};

/// The state of one ray.  Embree passes the first member to filter functions.
struct Context {
  RTCIntersectContext embree;
  const Opacity* opacity;
  std::uint64_t ray;
  Counts counts;
  ShaderCalls asked;
  bool passes = false;             ///< the ray passes through every candidate
  Gathering* gathering = nullptr;  ///< null if hits do not blend
};

/// The masks of geometries with a surface and without one.
constexpr unsigned with_surface = 1, without_surface = 2;

/// The chance of BLEND, in 2^-25 .. 1 - 2^-25, a function of ray and triangle alone.
float chance_of(std::uint64_t ray, std::uint32_t instance, std::uint32_t geometry, std::uint32_t triangle) {
  const std::uint64_t hash =
      mixed(mixed(ray) ^ (std::uint64_t{instance} << 40) ^ (std::uint64_t{geometry} << 24) ^ triangle);
  return static_cast<float>(hash >> 41) * 0x1p-23f + 0x1p-25f;
}

/// Adds a hit that blends, once, however often it is reported.
void gather(Gathering& gathering, const Filtered& its, const Met& hit, const Barycentrics& b) {
  if (std::find(gathering.met.begin(), gathering.met.end(), hit) != gathering.met.end()) return;
  const ColourMaps* const colours = gathering.blending.colours;
  const std::uint32_t colour = colours != nullptr && colours->has(its.number)
                                   ? colours->at(its.number, hit.triangle, b)
                                   : grey_of(its.geometry->colour);
  gathering.met.push_back(hit);
  gathering.hits.push_back({hit.t, false, colour});
}

void filter(const RTCFilterFunctionNArguments* arguments) {
  const auto& its = *static_cast<const Filtered*>(arguments->geometryUserPtr);
  auto& context = *reinterpret_cast<Context*>(arguments->context);
  int& valid = arguments->valid[0];
  if (valid != -1) return;
  const std::uint32_t triangle = RTCHitN_primID(arguments->hit, arguments->N, 0),
                      instance = RTCHitN_instID(arguments->hit, arguments->N, 0, 0);
  const Barycentrics b =
      in_triangle(RTCHitN_u(arguments->hit, arguments->N, 0), RTCHitN_v(arguments->hit, arguments->N, 0));
  ++context.counts.candidates;
  context.counts.planned += its.geometry->planned;
  ++context.asked.candidates;
  std::uint32_t candidate = 0;
  if (context.opacity != nullptr)
    if (const auto state = context.opacity->at(its.number, triangle, b))
      candidate = static_cast<std::uint32_t>(*state) | impl::traverse::candidate_has_micromap;
  Gathering* const gathering = context.gathering;
  // An any-hit shader cannot blend a hit that traversal takes for opaque.
  const bool blends_in_shader = gathering != nullptr && gathering->blending.by == BlendedBy::shader;
  const std::uint32_t flags = blends_in_shader ? impl::traverse::instance_force_no_opaque : 0u;
  const auto blend = [&] {
    valid = 0;
    gather(*gathering, its, {RTCRayN_tfar(arguments->ray, arguments->N, 0), instance, its.number, triangle},
           b);
  };
  switch (impl::traverse::decide(candidate, flags, 0)) {
    case impl::traverse::Outcome::ignored:
      ++context.counts.ignored;
      valid = 0;
      return;
    case impl::traverse::Outcome::opaque:
      ++context.counts.opaque;
      if (context.passes) valid = 0;
      if (gathering != nullptr) blend();
      return;
    case impl::traverse::Outcome::non_opaque: break;
  }
  ++context.counts.shader;
  ++context.asked.shader;
  if (context.passes) {
    valid = 0;
    return;
  }
  context.counts.fetches += its.surface->fetches();
  if (!its.surface->opaque(its.geometry->uv_of(triangle), b,
                           chance_of(context.ray, instance, its.number, triangle)))
    valid = 0;
  else if (gathering != nullptr)
    blend();
}

[[noreturn]] void fail(RTCDevice device) {
  throw std::runtime_error("Embree: error " + std::to_string(static_cast<int>(rtcGetDeviceError(device))));
}

Context context_of(const Opacity* opacity, std::uint64_t ray) {
  Context context{};
  rtcInitIntersectContext(&context.embree);
  context.opacity = opacity;
  context.ray = ray;
  return context;
}

RTCRay embree_ray(const Ray& ray, float near, float far) {
  RTCRay r{};
  r.org_x = ray.from[0];
  r.org_y = ray.from[1];
  r.org_z = ray.from[2];
  r.dir_x = ray.direction[0];
  r.dir_y = ray.direction[1];
  r.dir_z = ray.direction[2];
  r.tnear = near;
  r.tfar = far;
  r.mask = 0xffffffff;
  return r;
}

/// The CPU time of this thread.
double cpu_seconds() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

}  // namespace

bool has_embree() { return why_no_embree().empty(); }
std::string embree_text() { return has_embree() ? "Embree " RTC_VERSION_STRING : why_no_embree(); }

struct Tracer::EmbreeScene {
  const World& world;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<Filtered> filtered;  ///< by geometry
  std::vector<RTCScene> meshes;
  float scale = 1;  ///< the scene's longest side, for the offset of shadow rays
  float reach = 0;  ///< the greatest magnitude of a placed coordinate

  explicit EmbreeScene(const World& w) : world(w) {
    if (!has_embree()) throw std::runtime_error(why_no_embree());
    // Embree's "threads=1" would bind the whole process.
    device = rtcNewDevice(nullptr);
    if (device == nullptr) fail(nullptr);
    filtered.resize(world.geometries.size());
    const Box box = box_of(world, false);
    if (!box.empty)
      for (std::size_t k = 0; k < 3; ++k) {
        scale = std::max(k == 0 ? 0 : scale, box.high[k] - box.low[k]);
        reach = std::max({reach, std::fabs(box.low[k]), std::fabs(box.high[k])});
      }
    // One thread commits, so that each run has the same volumes and the same candidates.
    oneapi::tbb::task_arena(1).execute([this] { build(); });
    if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
      throw std::runtime_error("Embree: error " + std::to_string(static_cast<int>(error)));
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene() {
    for (const RTCScene mesh : meshes) rtcReleaseScene(mesh);
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }

  template <class T>
  static void copy(RTCGeometry geometry, RTCBufferType type, RTCFormat format, const std::vector<T>& from) {
    if (from.empty()) return;
    void* const to = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), from.size());
    if (to == nullptr) throw std::runtime_error("Embree: no memory for a geometry");
    std::memcpy(to, from.data(), sizeof(T) * from.size());
  }

  /// Builds a mesh in its own space, or, if there is an instance, where the instance places it.
  RTCScene build_mesh(const std::vector<std::uint32_t>& mesh, const Instance* instance) {
    const RTCScene its = rtcNewScene(device);
    meshes.push_back(its);
    rtcSetSceneFlags(its, RTC_SCENE_FLAG_ROBUST);
    for (std::uint32_t k = 0; k < mesh.size(); ++k) {
      const Geometry& geometry = world.geometries[mesh[k]];
      const RTCGeometry triangles = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
      if (instance == nullptr) {
        copy(triangles, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, geometry.positions);
      } else {
        std::vector<Point> positions;
        for (const Point& p : geometry.positions) positions.push_back(placed(*instance, p));
        copy(triangles, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, positions);
      }
      copy(triangles, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, geometry.triangles);
      rtcSetGeometryMask(triangles, geometry.surface ? with_surface : without_surface);
      rtcSetGeometryUserData(triangles, &filtered[mesh[k]]);
      if (geometry.surface) {
        rtcSetGeometryIntersectFilterFunction(triangles, filter);
        rtcSetGeometryOccludedFilterFunction(triangles, filter);
      }
      rtcCommitGeometry(triangles);
      rtcAttachGeometryByID(its, triangles, k);
      rtcReleaseGeometry(triangles);
    }
    rtcJoinCommitScene(its);
    return its;
  }

  void build() {
    for (std::uint32_t g = 0; g < world.geometries.size(); ++g) {
      const Geometry& geometry = world.geometries[g];
      filtered[g] = {&geometry, geometry.surface ? &world.surfaces[*geometry.surface] : nullptr, g};
    }
    for (const auto& mesh : world.meshes) build_mesh(mesh, nullptr);
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    for (std::uint32_t k = 0; k < world.instances.size(); ++k) {
      const RTCGeometry instance_geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
      rtcSetGeometryMask(instance_geometry, with_surface | without_surface);
      const Instance& instance = world.instances[k];
      // Rays cannot be taken into a space that is flat or out of all proportion.  Such an instance gets a
      // copy of its mesh, already placed.
      const bool own_space = has_inverse(instance, reach);
      const Instance here{};
      rtcSetGeometryInstancedScene(
          instance_geometry,
          own_space ? meshes[instance.mesh] : build_mesh(world.meshes[instance.mesh], &instance));
      rtcSetGeometryTransform(instance_geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                              (own_space ? instance : here).transform.data());
      rtcCommitGeometry(instance_geometry);
      rtcAttachGeometryByID(scene, instance_geometry, k);
      rtcReleaseGeometry(instance_geometry);
    }
    rtcJoinCommitScene(scene);
  }

  Met met(const RTCRayHit& found) const {
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    const std::uint32_t instance = found.hit.instID[0];
    return {found.ray.tfar, instance, world.meshes[world.instances[instance].mesh][found.hit.geomID],
            found.hit.primID};
  }

  struct Closest {
    Met met;
    Barycentrics at{0, 0};
  };
  Closest closest(const Ray& ray, Context& context) const {
    RTCRayHit found{};
    found.ray = embree_ray(ray, 0, std::numeric_limits<float>::infinity());
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context.embree, &found);
    return {met(found), in_triangle(found.hit.u, found.hit.v)};
  }

  void pass(const Ray& ray, Context& context) const {
    context.passes = true;
    RTCRay line = embree_ray(ray, 0, std::numeric_limits<float>::infinity());
    line.mask = with_surface;
    rtcOccluded1(scene, &context.embree, &line);
  }

  Pixel pixel(const Camera& camera, const Opacity* opacity, const TraceOptions& options, std::uint32_t x,
              std::uint32_t y, Counts& counts) const {
    const std::uint64_t number = 2 * (std::uint64_t{y} * options.width + x);
    const Ray ray = ray_of(camera, x, y, options.width, options.height);
    Context primary = context_of(opacity, number);
    Pixel pixel;
    const Closest found = closest(ray, primary);
    pixel.primary = found.met;
    pixel.at = found.at;
    pixel.by_primary = primary.asked;
    primary.counts.met = primary.counts.planned != 0;
    counts += primary.counts;
    ++counts.rays;
    if (!pixel.primary.hit()) return pixel;
    const Point light = unit(options.light);
    Point normal = normal_of(pixel.primary);
    if (dot(normal, ray.direction) > 0) normal = times(normal, -1);  // the side that is seen
    pixel.shade = dot(normal, light);
    pixel.lit = true;
    Point at{};
    const float offset = 1e-4f * scale;
    for (std::size_t k = 0; k < 3; ++k)
      at[k] = ray.from[k] + pixel.primary.t * ray.direction[k] + offset * normal[k];
    if (options.shadows) {
      Context shadow = context_of(opacity, number + 1);
      pixel.lit = open(at, light, offset, shadow, counts);
      pixel.by_shadow = shadow.asked;
      ++counts.shadow_rays;
    }
    for (unsigned k = 0; k < options.ambient; ++k) {
      const std::uint64_t own = mixed(mixed(options.seed) ^ (number * most_ambient + k));
      Context ambient = context_of(opacity, own);
      pixel.open |= std::uint64_t{open(at, about_normal(normal, own), offset, ambient, counts)} << k;
      pixel.by_ambient.candidates += ambient.asked.candidates;
      pixel.by_ambient.shader += ambient.asked.shader;
      ++counts.ambient_rays;
    }
    return pixel;
  }

  /// Whether a ray meets nothing.
  bool open(const Point& from, const Point& direction, float near, Context& context, Counts& counts) const {
    RTCRay ray = embree_ray({from, direction}, near, std::numeric_limits<float>::infinity());
    rtcOccluded1(scene, &context.embree, &ray);
    context.counts.met = context.counts.planned != 0;
    counts += context.counts;
    return !(ray.tfar < 0);
  }

  BlendHits blend_hits(const Ray& ray, const Opacity* opacity, const Blending& blending, std::uint64_t number,
                       Counts& counts) const {
    Gathering gathering{blending};
    Context context = context_of(opacity, number);
    context.gathering = &gathering;
    BlendHits found;
    const Closest closest_one = closest(ray, context);
    found.accepted = closest_one.met;
    found.at = closest_one.at;
    found.hits = std::move(gathering.hits);
    if (found.accepted.hit()) found.hits.push_back({found.accepted.t, true, 0});
    found.asked = context.asked;
    counts += context.counts;
    ++counts.rays;
    return found;
  }

  BlendPixel blend_pixel(const Camera& camera, const Opacity* opacity, const Blending& blending,
                         const TraceOptions& options, std::uint32_t x, std::uint32_t y,
                         Counts& counts) const {
    const Ray ray = ray_of(camera, x, y, options.width, options.height);
    const BlendHits found =
        blend_hits(ray, opacity, blending, 2 * (std::uint64_t{y} * options.width + x), counts);
    BlendPixel pixel;
    pixel.accepted = found.accepted;
    pixel.at = found.at;
    pixel.asked = found.asked;
    pixel.payload = impl::traverse::blended(blending.operation, neutral(blending.operation), found.hits);
    pixel.as_met = neutral(blending.operation);
    for (const impl::traverse::Hit& hit : found.hits)
      if (!hit.accepted) pixel.as_met = impl::traverse::blend(blending.operation, pixel.as_met, hit.value);
    if (!found.accepted.hit()) return pixel;
    Point normal = normal_of(found.accepted);
    if (dot(normal, ray.direction) > 0) normal = times(normal, -1);
    pixel.shade = dot(normal, unit(options.light));
    return pixel;
  }

  Point normal_of(const Met& hit) const {
    const Geometry& geometry = world.geometries[hit.geometry];
    const auto& t = geometry.triangles[hit.triangle];
    const Instance& instance = world.instances[hit.instance];
    const Point a = placed(instance, geometry.positions[t[0]]),
                b = placed(instance, geometry.positions[t[1]]),
                c = placed(instance, geometry.positions[t[2]]);
    return unit(cross(minus(b, a), minus(c, a)));
  }
};

Tracer::Tracer(const World& world) : built_(std::make_unique<EmbreeScene>(world)) {}
Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

Pixel Tracer::pixel(const Camera& camera, const Opacity* opacity, const TraceOptions& options,
                    std::uint32_t x, std::uint32_t y) const {
  Counts counts;
  return built_->pixel(camera, opacity, options, x, y, counts);
}

Counts Tracer::even_rays(const Opacity& opacity, std::uint64_t rays, std::uint64_t seed,
                         unsigned threads) const {
  const Box box = box_of(built_->world, true);
  if (box.empty) return {};
  const Point middle = times(plus(box.low, box.high), 0.5f);
  const float radius = 0.5f * std::sqrt(dot(minus(box.high, box.low), minus(box.high, box.low)));
  constexpr std::uint64_t chunk = 4096;
  std::vector<Counts> counts((rays + chunk - 1) / chunk);
  oneapi::tbb::task_arena arena(threads == 0 ? oneapi::tbb::task_arena::automatic
                                             : static_cast<int>(threads));
  arena.execute([&] {
    oneapi::tbb::parallel_for(std::size_t{0}, counts.size(), [&](std::size_t c) {
      for (std::uint64_t k = c * chunk; k < std::min(rays, (c + 1) * chunk); ++k) {
        Context context = context_of(&opacity, k);
        built_->pass(line_through_ball(middle, radius, mixed(seed) ^ mixed(k)), context);
        counts[c] += context.counts;
        ++counts[c].rays;
      }
    });
  });
  Counts sum;
  for (const Counts& one : counts) sum += one;
  return sum;
}

Met Tracer::first_hit(const Ray& ray, const Opacity* opacity, std::uint64_t number, Counts& counts) const {
  Context context = context_of(opacity, number);
  const Met met = built_->closest(ray, context).met;
  counts += context.counts;
  ++counts.rays;
  return met;
}

namespace {

/// Fills a frame's pixels, counts and times; of_pixel(x, y, counts) traces one pixel.
template <class Frame, class OfPixel>
Frame filled(const TraceOptions& options, OfPixel of_pixel) {
  if (options.width == 0 || options.height == 0 || options.width > 16384 || options.height > 16384)
    throw std::invalid_argument("Tracer: a side of 0 or above 16384");
  Frame frame;
  frame.width = options.width;
  frame.height = options.height;
  frame.pixels.resize(std::size_t{options.width} * options.height);
  std::vector<Counts> of_rows(options.height);
  std::vector<double> cpu_of_rows(options.height);
  const auto start = std::chrono::steady_clock::now();
  oneapi::tbb::task_arena arena(options.threads == 0 ? oneapi::tbb::task_arena::automatic
                                                     : static_cast<int>(options.threads));
  arena.execute([&] {
    oneapi::tbb::parallel_for(std::uint32_t{0}, options.height, [&](std::uint32_t y) {
      const double cpu = cpu_seconds();
      for (std::uint32_t x = 0; x < options.width; ++x)
        frame.pixels[std::size_t{y} * options.width + x] = of_pixel(x, y, of_rows[y]);
      cpu_of_rows[y] = cpu_seconds() - cpu;
      if (options.done) options.done(options.width);
    });
  });
  frame.cpu_seconds = std::accumulate(cpu_of_rows.begin(), cpu_of_rows.end(), 0.0);
  frame.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  for (const Counts& row : of_rows) frame.counts += row;
  return frame;
}

}  // namespace

Frame Tracer::frame(const Camera& camera, const Opacity* opacity, const TraceOptions& options) const {
  if (options.ambient > most_ambient)
    throw std::invalid_argument("Tracer: too many rays of ambient occlusion");
  Frame frame = filled<Frame>(options, [&](std::uint32_t x, std::uint32_t y, Counts& counts) {
    return built_->pixel(camera, opacity, options, x, y, counts);
  });
  frame.ambient = options.ambient;
  return frame;
}

BlendFrame Tracer::blend_frame(const Camera& camera, const Opacity* opacity, const Blending& blending,
                               const TraceOptions& options) const {
  return filled<BlendFrame>(options, [&](std::uint32_t x, std::uint32_t y, Counts& counts) {
    return built_->blend_pixel(camera, opacity, blending, options, x, y, counts);
  });
}

BlendHits Tracer::blend_hits(const Camera& camera, const Opacity* opacity, const Blending& blending,
                             const TraceOptions& options, std::uint32_t x, std::uint32_t y) const {
  Counts counts;
  return built_->blend_hits(ray_of(camera, x, y, options.width, options.height), opacity, blending,
                            2 * (std::uint64_t{y} * options.width + x), counts);
}

}  // namespace mmverify::render
