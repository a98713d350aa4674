#include <algorithm>

#include "scene/validate/sidecar.hpp"

namespace mmverify::scene {
namespace {

namespace micromap = impl::micromap;
using micromap::Place;
using micromap::Rule;

/// Whether a rule is about a geometry: the array's own are listed once, not with each.
bool of_geometry(const micromap::Violation& v) {
  using enum Rule;
  switch (v.rule) {
    case align_index:
    case counts_geometry:
    case counts_geometry_is_array:
    case index_encoding:
    case index_stride:
    case index_stride_most:
    case index_tight:
    case index_size:
    case index_count:
    case index_special:
    case index_range:
      return true;
    default:
      return v.place == Place::geometry_count;
  }
}

std::string pointer_of_array(const micromap::Violation& v) {
  using enum Rule;
  if (v.rule == align_data_256 || v.rule == align_data_128) return "/data";
  if (v.place == Place::array_count) return "/usageCounts/" + std::to_string(v.where);
  const bool counts =
      v.place == Place::level_and_format || v.rule == counts_limit || v.rule == counts_array_is_geometry;
  return counts ? "/usageCounts" : "/records";
}

std::string pointer_of_geometry(const micromap::Violation& v, const micromap::Input& in, std::size_t number) {
  const std::string at = "/geometries/" + std::to_string(number);
  if (v.place == Place::geometry_count) return at + "/usageCounts/" + std::to_string(v.where);
  if (v.rule == Rule::counts_geometry || v.rule == Rule::counts_geometry_is_array) return at + "/usageCounts";
  return in.indexed ? at + "/indices" : at;
}

bool has(const std::vector<micromap::Violation>& list, Rule rule) {
  return std::any_of(list.begin(), list.end(),
                     [rule](const micromap::Violation& v) { return v.rule == rule; });
}

/// No rule of EXT's, and a driver crashes.
void advise(const micromap::Input& in, const std::string& at, Report& report) {
  const std::uint64_t size = micromap::width(in.encoding) / 8;
  if (!in.indexed || (in.sets & micromap::EXT) == 0 || in.indices_address % size == 0) return;
  if ((in.sets & micromap::text(Rule::align_index).sets) != 0) return;  // an error, and listed
  report.add("align.index_ext", at,
             "address " + std::to_string(in.indices_address) + " is no multiple of " + std::to_string(size));
}

}  // namespace

void validate_build(const micromap::Input& array, std::span<const micromap::Input> geometries,
                    Report& report) {
  std::vector<std::vector<micromap::Violation>> of_geometries;
  bool is_geometry = false;
  for (const micromap::Input& geometry : geometries) {
    micromap::Input in = geometry;
    in.sets = array.sets;
    in.limits = array.limits;
    in.lossy = array.lossy;
    in.records = array.records;
    in.record_count = array.record_count;
    in.record_stride = array.record_stride;
    in.data = array.data;
    in.array_counts = array.array_counts;
    of_geometries.push_back(micromap::validate(in));
    is_geometry |= has(of_geometries.back(), Rule::counts_array_is_geometry);
  }
  for (const micromap::Violation& v : micromap::validate(array))
    if (!is_geometry || v.rule != Rule::counts_array) report.add(v, pointer_of_array(v));
  if (is_geometry)
    report.add(micromap::Violation{Rule::counts_array_is_geometry, Place::whole, 0, 0, 0}, "/usageCounts");
  for (std::size_t g = 0; g < geometries.size(); ++g) {
    const bool is_array = has(of_geometries[g], Rule::counts_geometry_is_array);
    for (const micromap::Violation& v : of_geometries[g])
      if (of_geometry(v) && !(is_array && v.rule == Rule::counts_geometry))
        report.add(v, pointer_of_geometry(v, geometries[g], g));
    micromap::Input in = geometries[g];
    in.sets = array.sets;
    advise(in, "/geometries/" + std::to_string(g) + "/indices", report);
  }
}

}  // namespace mmverify::scene
