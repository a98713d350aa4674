// The items of Vulkan's Opacity Micromaps, slides on VK_KHR_opacity_micromap.
#include <algorithm>

#include "bench/papers/item.hpp"
#include "impl/tree/stream.hpp"

namespace mmverify::bench::papers {
namespace {

namespace micromap = impl::micromap;
using Ours = std::function<std::vector<double>(Measured&)>;

constexpr unsigned shape_level = 6;
/// Three indices of 4 bytes, and half a vertex of 12: a closed surface has half as many vertices as triangles.
constexpr double bytes_of_cut_triangle = 18;

/// The number of opaque leaves of the 2-state trees of all planned triangles: the triangles of a cut-out model.
double cut_triangles(Measured& m, std::size_t at) {
  const PlannedScene& of = m.scenes()[at];
  const std::vector<unsigned> levels(of.plan.triangles.size(), shape_level);
  const scene::Baked baked = scene::bake(
      of.scene, of.plan, levels,
      {.threads = m.sources().threads, .two_state = true, .margin = 0, .done = [&](std::uint64_t) {
         m.stop();
       }});
  double count = 0;
  for (std::size_t k = 0; k < baked.triangles.size(); ++k) {
    const scene::BakedTriangle& one = baked.triangles[k];
    const auto copies = static_cast<double>(of.plan.triangles[k].unique);
    if (one.uniform) {
      count += *one.uniform == micromap::State::O ? copies : 0;
      continue;
    }
    const micromap::Bytes packed(one.map.begin(), one.map.end());
    const impl::tree::Stream tree = impl::tree::encode_stream(shape_level, one.format, packed);
    for (std::uint64_t leaf = 0; leaf < tree.leaves; ++leaf)
      count += copies * (tree.data[leaf / 8] >> leaf % 8 & 1);
  }
  return count;
}

/// A figure of each scene from its sizes at the slide's level.
Ours of_sizes(std::function<double(const scene::Sizes&)> figure) {
  return [figure = std::move(figure)](Measured& m) {
    return by_scene(
        m, [&](std::size_t k) { return m.sizes(k, shape_level) ? figure(*m.sizes(k, shape_level)) : 0; });
  };
}

/// A figure at level 5 over the same at level 4.
Ours five_over_four(double (*figure)(const scene::Sizes&)) {
  return [=](Measured& m) {
    return by_scene(
        m, [&](std::size_t k) { return figure(m.sizes(k, 5).value()) / figure(m.sizes(k, 4).value()); });
  };
}

std::vector<Item> slides() {
  return {
      {"motivation",
       "cut-out geometry, alpha maps or micromaps",
       Status::ok,
       "scene FILE --sizes 6 --details; render FILE",
       "a cut-out model: the opaque leaves of the maps' 2-state trees at level 6, 18 bytes each without a "
       "BVH",
       {{"cut-out geometry",
         {},
         "kB",
         [](Measured& m) {
           return by_scene(m,
                           [&](std::size_t k) { return cut_triangles(m, k) * bytes_of_cut_triangle / 1000; });
         }},
        {"alpha maps", {}, "kB", of_sizes([](const scene::Sizes& s) {
           return static_cast<double>(s.footprint.texture) / 1000;
         })},
        {"micromaps, 2-state", {}, "kB", of_sizes([](const scene::Sizes& s) {
           return static_cast<double>(s.footprint.mode[0].data + s.footprint.record_bytes +
                                      s.footprint.index_bytes) /
                  1000;
         })},
        {"area that calls no shader, 4-state", {}, "%", of_sizes([](const scene::Sizes& s) {
           return 100 * s.any_hit.known();
         })}}},
      {"first look", "micromaps off with ray queries by default", Status::ok, "prove traverse.decision",
       "the execution mode; two texts contradict each other (ERRATA.md)"},
      {"creating", "a map as an acceleration structure; usage counts", Status::ok,
       "prove array.array_histogram array.geometry_histogram", "ARRAYS.md"},
      {"shape",
       "level 4 or 5: memory against any-hit calls",
       Status::ok,
       "scene FILE --sizes 1..9 --plot OUT.png",
       "level 5 over level 4",
       {{"memory, 4-state", {}, "x", five_over_four([](const scene::Sizes& s) {
           return static_cast<double>(s.footprint.mode[1].data);
         })},
        {"area that calls a shader", {}, "x", five_over_four([](const scene::Sizes& s) {
           return s.any_hit.unknown;
         })}}},
      {"building", "data in little-endian bits; the triangle array", Status::ok,
       "prove micromap.packing array.resolves", "MICROMAP.md"},
      {"binding", "an index buffer, n to 1; special indices", Status::ok,
       "prove array.index_range array.special_indices", "ARRAYS.md"},
      {"copying", "clone, compact, serialise", Status::ok, "prove array.compact array.files",
       "a clone is a copy of an array's bytes (ARRAYS.md)"},
      {"copying, compatibility", "whether a serialised map fits a device", Status::not_here, "",
       "a driver's own answer; our files have a version and a checksum instead"},
      {"fetching", "states, special indices and results", Status::ok, "prove traverse.decision",
       "TRAVERSE.md"},
      {"lossy", "substitution into unknown states; deeper levels (5 and more, of a device with 4) emulated",
       Status::ok, "prove lossy traverse.lossy_is_conservative array.emulates",
       "invisible but for flags that prevent a call (ERRATA.md)"},
      {"force2state", "no any-hit shader calls; unknown states read as two", Status::ok,
       "prove traverse.two_state_never_calls_a_shader micromap.force2",
       "unless NoOpaque or FORCE_NO_OPAQUE (ERRATA.md)"},
  };
}

/// Rows of the API's own calls.
std::vector<Item> calls() {
  return {
      {"copying, addresses", "addresses that an application fills in before a BLAS is deserialised",
       Status::not_here, "", "a driver's own format"},
      {"building, calls", "no host or indirect builds; a BLAS no longer consumes usage counts",
       Status::not_here, "",
       "calls of the API; the counts of an array and of a geometry are checked (ARRAYS.md)"},
  };
}

}  // namespace

std::vector<Item> khr_slides() { return joined({slides(), calls()}); }

}  // namespace mmverify::bench::papers
