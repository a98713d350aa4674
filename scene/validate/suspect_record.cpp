#include "scene/validate/suspect_record.hpp"

#include <algorithm>
#include <vector>

#include "scene/edit/record_sizes.hpp"

namespace mmverify::scene {
namespace {

namespace micromap = impl::micromap;
using micromap::Record;
using micromap::Rule;

std::uint64_t bytes_of(const Record& record) {
  return micromap::packed_bytes(micromap::micro_triangles(record.level),
                                static_cast<micromap::Format>(record.format));
}

bool has_size(const Record& record) {
  return record.level <= 12 && (record.format == 1 || record.format == 2);
}

/// Whether the maps, one after another, fill the data.
bool fill_the_data(const std::vector<Record>& records, std::uint64_t data_bytes) {
  std::uint64_t end = 0;
  for (const Record& record : records) {
    if (!has_size(record)) return false;
    end += bytes_of(record);
  }
  return end == data_bytes;
}

/// Whether a rule is broken that tells of a map's bytes, or of its level and format.
bool breaks_rules(micromap::Input in, const std::vector<std::uint8_t>& records, bool counts) {
  in.sets = micromap::glTF;
  in.records = records;
  in.triangles = 0;
  const auto found = micromap::validate(in);
  return std::any_of(found.begin(), found.end(), [counts](const micromap::Violation& v) {
    return v.rule == Rule::record_overlap || v.rule == Rule::record_region || v.rule == Rule::record_format ||
           v.rule == Rule::record_level_12 || (counts && v.rule == Rule::counts_array);
  });
}

std::string shape_of(const Record& record) {
  if (record.format != 1 && record.format != 2) return "format " + std::to_string(record.format);
  return "level " + std::to_string(record.level) + (record.format == 1 ? " in 2-state" : " in 4-state");
}

}  // namespace

std::string suspect_record(const micromap::Input& in) {
  if (in.record_stride != micromap::record_bytes ||
      in.record_count > in.records.size() / micromap::record_bytes)
    return "";
  std::vector<Record> records;
  for (std::uint64_t r = 0; r < in.record_count; ++r)
    records.push_back(micromap::record_at(in.records, r * micromap::record_bytes));
  if (fill_the_data(records, in.data.size())) return "";
  const auto sized = sized_by_gaps(records, in.data.size());
  if (!sized || *sized == records) return "";
  const bool counts = in.array_counts.has_value();
  const bool bytes_clash = breaks_rules(in, micromap::record_buffer(records), false);
  if (breaks_rules(in, micromap::record_buffer(*sized), !bytes_clash)) return "";
  if (!bytes_clash && !counts) return "";
  std::size_t first = records.size(), changed = 0;
  for (std::size_t r = records.size(); r-- > 0;)
    if (!(records[r] == (*sized)[r])) first = r, ++changed;
  const Record &says = records[first], &has = (*sized)[first];
  std::string text = "suspect: record " + std::to_string(first) + ": it says " + shape_of(says) +
                     (has_size(says) ? " (" + std::to_string(bytes_of(says)) + " bytes)" : "") +
                     ", and has the " + std::to_string(bytes_of(has)) + " bytes of " + shape_of(has);
  if (changed > 1)
    text += "; and " + std::to_string(changed - 1) + " more such record" + (changed == 2 ? "" : "s");
  return text;
}

}  // namespace mmverify::scene
