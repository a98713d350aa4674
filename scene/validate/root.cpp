#include "scene/validate/report.hpp"
#include "scene/validate/shared.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

constexpr const char* usage_names[] = {"usageCounts", "usageLevels", "usageFormats"};

/// The bytes of the view that `name` refers to: data or triangles.
std::optional<std::span<const unsigned char>> bytes_of(const Document& document, const Buffers& buffers,
                                                       const Json& micromap, const char* name,
                                                       const std::string& at, Report& report) {
  if (!micromap.contains(name)) {
    report.add("micromap.missing", at, std::string(name) + " is not there");
    return {};
  }
  const std::size_t views = member(document.json, "bufferViews").size();
  const std::string pointer = at + "/" + name;
  const auto view = whole(micromap[name], views);
  if (!view) {
    report.add("micromap.view", pointer,
               found(micromap[name]) + " is no index of the " + std::to_string(views) + " bufferViews");
    return {};
  }
  if (const std::string reader = other_reader_of_view(document.json, static_cast<std::size_t>(*view));
      !reader.empty())
    report.add("view.shared", pointer,
               place("bufferView", static_cast<std::size_t>(*view)) + " is " + reader + ", too");
  return plain_view(document, buffers, static_cast<std::size_t>(*view), pointer, report);
}

/// One of the three usage arrays; none if an element is no number.
std::optional<std::vector<std::uint32_t>> numbers(const Json& micromap, const char* name,
                                                  const std::string& at, Report& report) {
  if (!micromap.contains(name)) {
    report.add("micromap.missing", at, std::string(name) + " is not there");
    return {};
  }
  const Json& given = micromap[name];
  const std::string pointer = at + "/" + name;
  if (!given.is_array() || given.empty()) {
    report.add("usage.array", pointer, "an array of at least one is due, not " + found(given));
    return {};
  }
  std::vector<std::uint32_t> values;
  for (std::size_t k = 0; k < given.size(); ++k)
    if (const auto value = whole(given[k]))
      values.push_back(static_cast<std::uint32_t>(*value));
    else
      report.add("usage.integer", pointer + "/" + std::to_string(k),
                 "a whole number from 0, below 2^32, is due, not " + found(given[k]));
  if (values.size() != given.size()) return {};
  return values;
}

/// The list of (count, level, format); none if it cannot be read.
std::optional<std::vector<impl::micromap::UsageCount>> usage(const Json& micromap, const std::string& at,
                                                             Report& report) {
  std::optional<std::vector<std::uint32_t>> columns[3];
  for (std::size_t c = 0; c < 3; ++c) columns[c] = numbers(micromap, usage_names[c], at, report);
  for (std::size_t c = 1; c < 3; ++c) {
    const Json &counts = member(micromap, usage_names[0]), &other = member(micromap, usage_names[c]);
    if (counts.is_array() && other.is_array() && counts.size() != other.size()) {
      report.add(
          "usage.length", at + "/" + usage_names[c],
          std::to_string(other.size()) + " elements for " + std::to_string(counts.size()) + " usageCounts");
      columns[0].reset();
    }
  }
  if (!columns[0] || !columns[1] || !columns[2]) return {};
  std::vector<impl::micromap::UsageCount> counts;
  for (std::size_t k = 0; k < columns[0]->size(); ++k)
    counts.push_back({(*columns[0])[k], (*columns[1])[k], (*columns[2])[k]});
  return counts;
}

std::string pointer_of(const impl::micromap::Violation& violation, const std::string& at) {
  switch (violation.place) {
    case impl::micromap::Place::array_count: {
      const char* const column = violation.rule == impl::micromap::Rule::counts_zero     ? usage_names[0]
                                 : violation.rule == impl::micromap::Rule::counts_format ? usage_names[2]
                                                                                         : usage_names[1];
      return at + "/" + column + "/" + std::to_string(violation.where);
    }
    case impl::micromap::Place::level_and_format: return at + "/usageCounts";
    default:
      return at + (violation.rule == impl::micromap::Rule::counts_limit ? "/usageCounts" : "/triangles");
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// The older drafts
// ---------------------------------------------------------------------------------------------------------------------

/// Whether a rule of glTF is only the newest draft's.  The older drafts bound no level, let records lie apart, and
/// compare sums alone.
bool of_the_newest_alone(impl::micromap::Rule rule) {
  using enum impl::micromap::Rule;
  return rule == record_level_12 || rule == counts_level_12 || rule == stride_tight ||
         rule == records_whole || rule == counts_array;
}

/// Sets the records' stride, byteStride, which is a multiple of 4, as for every bufferView that is read.
void stride_of(const Document& document, const Json& micromap, const std::string& at,
               impl::micromap::Input& in, Report& report) {
  using impl::micromap::record_bytes;
  const std::string pointer = at + "/triangles";
  in.record_stride = document.json["bufferViews"][micromap["triangles"].get<std::size_t>()].value(
      "byteStride", std::uint64_t{record_bytes});
  const std::uint64_t stride = in.record_stride, size = in.records.size();
  if (stride < record_bytes) return;
  in.record_count = size < record_bytes ? 0 : (size - record_bytes) / stride + 1;
  const std::uint64_t end = in.record_count == 0 ? 0 : (in.record_count - 1) * stride + record_bytes;
  // The rest may be the gap before one more record.
  if (size - end > stride - record_bytes)
    report.add("records.whole", pointer,
               std::to_string(size) + " bytes end within record " + std::to_string(in.record_count));
}

void compare_sum(const std::vector<impl::micromap::UsageCount>& counts, std::uint64_t records,
                 const std::string& at, Report& report) {
  std::uint64_t sum = 0;
  for (const impl::micromap::UsageCount& c : counts) sum += c.count;
  if (sum != records)
    report.add("counts.array", at + "/usageCounts",
               "the usage counts add up to " + std::to_string(sum) + ", there are " +
                   std::to_string(records) + " records");
}

RecordCount validate_micromap(const Document& document, const Buffers& buffers, const Json& micromap,
                              const std::string& at, Report& report) {
  if (!micromap.is_object()) {
    report.add("micromap.object", at, "an object is due, not " + found(micromap));
    return {};
  }
  if (report.newest() && micromap.contains("name") && !micromap["name"].is_string())
    report.add("micromap.name", at + "/name", "a string is due, not " + found(micromap["name"]));
  const auto data = bytes_of(document, buffers, micromap, "data", at, report);
  const auto records = bytes_of(document, buffers, micromap, "triangles", at, report);
  const auto counts = usage(micromap, at, report);
  if (!records) return {};
  impl::micromap::Input in;
  in.sets = static_cast<impl::micromap::Sets>(impl::micromap::glTF | report.target().apis);
  if (report.target().device) in.limits = report.target().device->limits;
  in.records = *records;
  in.record_count = records->size() / impl::micromap::record_bytes;
  if (!report.newest()) stride_of(document, micromap, at, in, report);
  if (data) in.data = *data;
  if (counts) in.array_counts = *counts;
  for (const impl::micromap::Violation& violation : impl::micromap::validate(in)) {
    if (!data && violation.rule == impl::micromap::Rule::record_region) continue;  // its cause is listed
    const bool of_an_api = (impl::micromap::text(violation.rule).sets & report.target().apis) != 0;
    if (!report.newest() && of_the_newest_alone(violation.rule) && !of_an_api) continue;
    report.add(violation, in, pointer_of(violation, at));
  }
  if (!report.newest() && counts && report.target().apis == 0)
    compare_sum(*counts, in.record_count, at, report);
  return in.record_count;
}

}  // namespace

std::vector<RecordCount> validate_root(const Document& document, const Buffers& buffers, Report& report) {
  const Json& extensions = member(document.json, "extensions");
  const auto root = extensions.find(report.extension());
  if (root == extensions.end()) return {};
  const std::string at = std::string("/extensions/") + report.extension();
  if (!root->is_object()) {
    report.add("root.object", at, "an object is due, not " + found(*root));
    return {};
  }
  const Json& micromaps = member(*root, "micromaps");
  if (!micromaps.is_array() || micromaps.empty()) {
    report.add("root.micromaps", at + "/micromaps",
               root->contains("micromaps") ? "an array of at least one is due, not " + found(micromaps)
                                           : std::string("missing"));
    return {};
  }
  std::vector<RecordCount> counts;
  for (std::size_t k = 0; k < micromaps.size(); ++k)
    counts.push_back(
        validate_micromap(document, buffers, micromaps[k], at + "/micromaps/" + std::to_string(k), report));
  return counts;
}

}  // namespace mmverify::scene
