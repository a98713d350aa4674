#include <algorithm>

#include "scene/validate/index_use.hpp"
#include "scene/validate/sidecar.hpp"

namespace mmverify::scene {
namespace {

namespace micromap = impl::micromap;
using micromap::Place;
using micromap::Rule;

std::string pointer_of_array(const micromap::Violation& v) {
  using enum Rule;
  if (v.rule == align_data_256 || v.rule == align_data_128) return "/data";
  if (v.place == Place::array_count) return "/usageCounts/" + std::to_string(v.where);
  const bool counts = v.place == Place::level_and_format || v.rule == counts_limit;
  return counts ? "/usageCounts" : "/records";
}

std::string pointer_of_geometry(const micromap::Violation& v, const micromap::Input& in, std::size_t number) {
  const std::string at = "/geometries/" + std::to_string(number);
  if (v.place == Place::geometry_count) return at + "/usageCounts/" + std::to_string(v.where);
  if (v.rule == Rule::counts_geometry || v.rule == Rule::counts_geometry_is_array) return at + "/usageCounts";
  return in.indexed ? at + "/indices" : at;
}

bool has(const micromap::Violations& found, Rule rule) {
  return std::any_of(found.list.begin(), found.list.end(),
                     [rule](const micromap::Violation& v) { return v.rule == rule; });
}

/// Adds each violation by `in` at its pointer, except those of the rule `without`.
template <class Pointer>
void add(const micromap::Violations& found, const micromap::Input& in, Rule without, const Pointer& pointer,
         Report& report) {
  for (const micromap::Violation& v : found.list)
    if (v.rule != without) report.add(v, in, pointer(v));
  for (const auto& [rule, more] : found.more) {
    const auto listed = [rule = rule](const micromap::Violation& v) { return v.rule == rule; };
    if (rule != without)
      report.count(micromap::text(rule).id,
                   pointer(*std::find_if(found.list.begin(), found.list.end(), listed)), more);
  }
}

/// Adds an advice about the index alignment: EXT has no rule for it, but a driver crashes.
void advise(const micromap::Input& in, const std::string& at, Report& report) {
  const std::uint64_t size = micromap::width(in.encoding) / 8;
  if (!in.indexed || (in.sets & micromap::EXT) == 0 || in.indices_address % size == 0) return;
  if ((in.sets & micromap::text(Rule::align_index).sets) != 0) return;  // an error, and listed
  report.add("align.index_ext", at,
             "address " + std::to_string(in.indices_address) + " is no multiple of " + std::to_string(size));
}

}  // namespace

void validate_build(const micromap::Input& array, std::span<const micromap::Input> geometries,
                    const Device& device, Report& report) {
  const micromap::ArrayValidator validator(array, Report::most);
  std::vector<micromap::Violations> of_geometries;
  bool is_geometry = false;
  for (const micromap::Input& geometry : geometries) {
    of_geometries.push_back(validator.geometry(geometry));
    is_geometry |= has(of_geometries.back(), Rule::counts_array_is_geometry);
  }
  add(validator.array(), array, is_geometry ? Rule::counts_array : Rule::count_, pointer_of_array, report);
  if (is_geometry)
    report.add(micromap::Violation{Rule::counts_array_is_geometry, Place::whole, 0, 0, 0}, array,
               "/usageCounts");
  for (std::size_t g = 0; g < geometries.size(); ++g) {
    micromap::Violations& found = of_geometries[g];
    std::erase_if(found.list,
                  [](const micromap::Violation& v) { return v.rule == Rule::counts_array_is_geometry; });
    micromap::Input in = array;
    in.triangles = geometries[g].triangles;
    in.indexed = geometries[g].indexed;
    in.indices = geometries[g].indices;
    in.encoding = geometries[g].encoding;
    in.index_stride = geometries[g].index_stride;
    in.indices_address = geometries[g].indices_address;
    in.geometry_counts = geometries[g].geometry_counts;
    add(
        found, in, has(found, Rule::counts_geometry_is_array) ? Rule::counts_geometry : Rule::count_,
        [&](const micromap::Violation& v) { return pointer_of_geometry(v, in, g); }, report);
    const std::string at = "/geometries/" + std::to_string(g) + "/indices";
    advise(in, at, report);
    validate_index_use(in, device, at, report);
  }
}

}  // namespace mmverify::scene
