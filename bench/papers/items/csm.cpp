// The items of Common Subtree Merging Compressed Opacity Micromaps (HPG 2026).
#include "bench/papers/item.hpp"

namespace mmverify::bench::papers {
namespace {

using Ours = std::function<std::vector<double>(Measured&)>;

constexpr unsigned level = 10;  ///< of the paper's sizes
constexpr double mib = 1024.0 * 1024.0;

/// Bytes of a flat map, and flat over compressed, of the paper's sizes in MiB.
constexpr double flat_bytes = (1 << 2 * level) / 8.0;
constexpr double bytes_a_map(double flat, double merged) { return merged * mib / (flat * mib / flat_bytes); }

Ours of_two_states(std::function<double(const scene::ModeFootprint&)> figure) {
  return [figure = std::move(figure)](Measured& m) {
    return by_scene(m, [&](std::size_t k) {
      return m.sizes(k, level) ? figure(m.sizes(k, level)->footprint.mode[0]) : 0;
    });
  };
}
double per_map(const scene::ModeFootprint& f) {
  return static_cast<double>(f.graph) / static_cast<double>(f.records);
}
double times_smaller(const scene::ModeFootprint& f) {
  return static_cast<double>(f.data) / static_cast<double>(f.graph);
}

double over(std::uint64_t a, std::uint64_t b) {
  return b == 0 ? 0 : static_cast<double>(a) / static_cast<double>(b);
}
/// A figure of the paper's own layout, built here.
Ours of_layout(std::function<double(const CsmFigures&)> figure) {
  return [figure = std::move(figure)](Measured& m) {
    return by_scene(m, [&](std::size_t k) { return figure(m.common_subtrees(k, level)); });
  };
}
double layout_times_smaller(const CsmFigures& f) { return over(f.once_bytes, f.csm_bytes); }

}  // namespace

std::vector<Item> common_subtrees() {
  return {
      {"form", "16 children a node, a mask and pointers of 32 bits", Status::ok, "bench dag",
       "bench/dag/csm.hpp, built beside our graph, which has tiles of 64 states and references of 16 or 32 "
       "bits (DAG.md)"},
      {"form, mean opacity", "16 bits of mean opacity in a node, for levels of detail", Status::ok,
       "bench dag",
       "bench/dag/csm.hpp: a node's, at every second level from 4 below a map's; our graph keeps states "
       "alone"},
      {"sizes",
       "level 10, 2-state: times smaller than flat",
       Status::differs,
       "bench dag --scene FILE",
       "its scenes are not shipped; DAG.md has five free ones at levels 3 to 12",
       {{"Namaqualand, 3294 to 9.37 MiB", {3294 / 9.37}, "x", of_two_states(times_smaller)},
        {"Forest, 173.1 to 2.78 MiB", {173.1 / 2.78}, "x", of_two_states(times_smaller)},
        {"Bistro, 579.8 to 15.66 MiB", {579.8 / 15.66}, "x", of_two_states(times_smaller)},
        {"Intel Sponza, 633.9 to 68.73 MiB", {633.9 / 68.73}, "x", of_two_states(times_smaller)},
        {"bytes a map, ours a distinct one",
         {bytes_a_map(3294, 9.37), bytes_a_map(173.1, 2.78), bytes_a_map(579.8, 15.66),
          bytes_a_map(633.9, 68.73)},
         "B",
         of_two_states(per_map)},
        {"its layout here, below equal maps stored once", {351, 9}, "x", of_layout(layout_times_smaller)},
        {"its layout here, bytes a map of all",
         {bytes_a_map(3294, 9.37), bytes_a_map(633.9, 68.73)},
         "B",
         of_layout([](const CsmFigures& f) { return over(f.csm_bytes, f.maps); })},
        {"our graph over its layout here, all bytes", {}, "x", of_layout([](const CsmFigures& f) {
           return over(f.dag_bytes, f.csm_bytes);
         })}}},
      {"range",
       "times smaller than flat, abstract",
       Status::differs,
       "bench dag --scene FILE",
       "flat there may count equal maps once or not (DAG.md)",
       {{"factor", {9, 351}, "x", of_two_states(times_smaller)}}},
      {"time",
       "frame time over flat",
       Status::not_here,
       "bench dag --scene FILE",
       "a graphics card's; here its layout's lookups are timed on a processor, beside flat and ours (DAG.md)",
       {{"at most", {8, 14}, "%", {}, "8; 14"}}},
      {"worst case",
       "never larger than flat times",
       Status::ok,
       "prove dag.all_levels dag.bound",
       "ours: flat and its records, 1 + 64 / (4^n b) from level 5 on",
       {{"its layout here, a map of noise", {1.27}, "x", of_layout([](const CsmFigures& f) {
           return f.csm_worst;
         })},
        {"factor", {1.27}, "x", [](Measured&) { return std::vector<double>{1 + 64.0 / 1024}; }}}},
  };
}

}  // namespace mmverify::bench::papers
