// The array validator, rule by rule: it tests each rule literally, and is as slow as that takes.
#pragma once

#include <algorithm>
#include <compare>
#include <limits>

#include "spec/micromap/array.hpp"
#include "spec/micromap/rules.hpp"

namespace mmverify::spec::micromap {

/// The limits of a device.  Source: VkPhysicalDeviceOpacityMicromapPropertiesKHR.
struct Limits {
  std::uint32_t two_state_level = 12, four_state_level = 12, lossy_four_state_level = 12;
  std::uint64_t triangles = std::numeric_limits<std::uint64_t>::max();  ///< maxMicromapTriangles
};

/// An array, and a geometry that refers to it, from somebody else: nothing in it is trusted.
struct Input {
  Sets sets = all_sets;  ///< specifications whose rules apply
  Limits limits = {};
  bool lossy = false;  ///< a lossy build (KHR)

  std::span<const std::uint8_t> records = {};
  std::uint64_t record_count = 0, record_stride = record_bytes, records_address = 0;
  std::span<const std::uint8_t> data = {};
  std::uint64_t data_address = 0;
  std::optional<std::span<const UsageCount>> array_counts = {};

  std::uint64_t triangles = 0;  ///< triangles of the geometry; 0: no geometry
  bool indexed = false;         ///< otherwise triangle t has index t
  std::span<const std::uint8_t> indices = {};
  Encoding encoding = Encoding::u32;
  std::uint64_t index_stride = 4, indices_address = 0;
  std::uint32_t base_triangle = 0;
  std::optional<std::span<const UsageCount>> geometry_counts = {};  ///< EXT only; other sets ignore it
};

/// The meaning of a violation's `where`: a number of records, counts or triangles, or a level and a format.
enum class Place : std::uint8_t { whole, record, array_count, geometry_count, level_and_format, triangle };

/// One violation.  found and other are the two values that the rule compares, see validate().
struct Violation {
  Rule rule;
  Place place;
  std::uint64_t where, found, other;
  friend constexpr auto operator<=>(const Violation&, const Violation&) = default;
};

namespace detail {

inline constexpr std::uint64_t beyond = std::numeric_limits<std::uint64_t>::max();

/// The number of elements of `size` bytes, `stride` apart, that lie whole within `bytes`; `count` at most.
inline std::uint64_t readable(std::uint64_t bytes, std::uint64_t size, std::uint64_t stride,
                              std::uint64_t count) {
  if (bytes < size) return 0;
  return stride == 0 ? count : std::min(count, (bytes - size) / stride + 1);
}

inline bool known(std::uint32_t format) { return format == 1 || format == 2; }

/// One byte beyond the last of a record's region; the greatest number if 64 bits do not suffice.
/// Domain: a known format.
inline std::uint64_t region_end(const Record& r) {
  if (r.level > 29) return beyond;
  return r.offset + packed_bytes(micro_triangles(r.level), static_cast<Format>(r.format));
}

inline std::uint64_t key(std::uint32_t level, std::uint32_t format) {
  return std::uint64_t{level} << 32 | format;
}

}  // namespace detail

/// Every violation of the rules of the given sets, in the order of Violation.  By rule: the place; found; other.
///   align.*, stride.*, records.whole, counts.limit, index.encoding, .stride*, .tight, .count
///                          whole; the actual value; the required one
///   records.size           record, the first that is missing; bytes; the required number of records
///   record.format .level*  record; its format or level; the limit
///   record.region          record; its end; the data's size
///   record.overlap         record that begins, in the order of (offset, number), before the end of an earlier one;
///                          the earlier record with the furthest end (the first such); its own first byte
///   counts.format .level* .zero   entry; its format or level; the limit
///   counts.array .geometry level 2^32 + format; the given count; the actual one
///   index.size             triangle, the first without an index; bytes; the required number of triangles
///   index.special .range   triangle; its code, or its record; 4, or the number of records.  Without a buffer the first
///                          such triangle stands for those after it; with a stride of 0, triangle 0 stands for all
/// If records or indices are missing, or an index names no record, counts that depend on them are not judged.
/// Domain: any input.
inline std::vector<Violation> validate(const Input& in) {
  std::vector<Violation> found;
  const auto in_force = [&](Rule rule) { return (text(rule).sets & in.sets) != 0; };
  const auto report = [&](Rule rule, Place place, std::uint64_t where, std::uint64_t what,
                          std::uint64_t against) {
    if (in_force(rule)) found.push_back({rule, place, where, what, against});
  };
  const auto require = [&](bool holds, Rule rule, std::uint64_t what, std::uint64_t against) {
    if (!holds) report(rule, Place::whole, 0, what, against);
  };

  // Addresses and strides.
  const std::uint64_t size = width(in.encoding) / 8;
  require(in.data_address % 256 == 0, Rule::align_data_256, in.data_address, 256);
  require(in.records_address % 256 == 0, Rule::align_records_256, in.records_address, 256);
  require(in.data_address % 128 == 0, Rule::align_data_128, in.data_address, 128);
  require(in.records_address % 128 == 0, Rule::align_records_128, in.records_address, 128);
  require(in.records_address % 4 == 0, Rule::align_records_4, in.records_address, 4);
  if (in.indexed) require(in.indices_address % size == 0, Rule::align_index, in.indices_address, size);
  require(in.record_stride >= record_bytes, Rule::stride_least, in.record_stride, record_bytes);
  require(in.record_stride % 4 == 0, Rule::stride_multiple, in.record_stride, 4);
  require(in.record_stride == record_bytes, Rule::stride_tight, in.record_stride, record_bytes);
  require(in.records.size() % record_bytes == 0, Rule::records_whole, in.records.size(), record_bytes);

  // The records that can be read.
  std::vector<Record> records;
  const std::uint64_t there =
      in.record_stride < record_bytes
          ? 0
          : detail::readable(in.records.size(), record_bytes, in.record_stride, in.record_count);
  for (std::uint64_t r = 0; r < there; ++r) records.push_back(record_at(in.records, r * in.record_stride));
  if (in.record_stride >= record_bytes && there < in.record_count)
    report(Rule::records_size, Place::record, there, in.records.size(), in.record_count);
  const bool whole = in.record_stride >= record_bytes && there == in.record_count;

  // Formats and levels, for records and for counts alike.
  const auto judge = [&](Place place, std::uint64_t where, std::uint32_t level, std::uint32_t format,
                         Rule r_format, Rule r_level, Rule r_lossy, Rule r_12, Rule r_lossy_format) {
    const Limits& most = in.limits;
    if (!detail::known(format)) report(r_format, place, where, format, 2);
    if (format == 1 && level > most.two_state_level)
      report(r_level, place, where, level, most.two_state_level);
    // A lossy build has its own limit; EXT has no lossy builds.
    if (format == 2 && level > most.four_state_level && (!in.lossy || (in.sets & EXT) != 0))
      report(r_level, place, where, level, most.four_state_level);
    if (format == 2 && level > most.lossy_four_state_level && in.lossy)
      report(r_lossy, place, where, level, most.lossy_four_state_level);
    if (level > 12) report(r_12, place, where, level, 12);
    if (format == 1 && in.lossy) report(r_lossy_format, place, where, format, 2);
  };
  for (std::uint64_t r = 0; r < records.size(); ++r)
    judge(Place::record, r, records[r].level, records[r].format, Rule::record_format, Rule::record_level,
          Rule::record_level_lossy, Rule::record_level_12, Rule::record_lossy_format);

  // Regions.
  for (std::uint64_t r = 0; r < records.size(); ++r) {
    if (!detail::known(records[r].format)) continue;
    const std::uint64_t end = detail::region_end(records[r]);
    if (end > in.data.size()) report(Rule::record_region, Place::record, r, end, in.data.size());
  }
  if (in_force(Rule::record_overlap)) {
    for (std::uint64_t r = 0; r < records.size(); ++r) {
      if (!detail::known(records[r].format)) continue;
      std::uint64_t furthest = 0;
      std::optional<std::uint64_t> by;
      for (std::uint64_t k = 0; k < records.size(); ++k) {
        const bool before = std::pair(records[k].offset, k) < std::pair(records[r].offset, r);
        if (!before || !detail::known(records[k].format)) continue;
        const std::uint64_t end = detail::region_end(records[k]);
        const bool first =
            by && end == furthest && std::pair(records[k].offset, k) < std::pair(records[*by].offset, *by);
        if (!by || end > furthest || first) {
          furthest = end;
          by = k;
        }
      }
      if (by && furthest > records[r].offset)
        report(Rule::record_overlap, Place::record, r, *by, records[r].offset);
    }
  }

  // The entries of the counts.
  const auto judge_counts = [&](Place place, std::span<const UsageCount> counts) {
    for (std::uint64_t i = 0; i < counts.size(); ++i)
      judge(place, i, counts[i].level, counts[i].format, Rule::counts_format, Rule::counts_level,
            Rule::counts_level_lossy, Rule::counts_level_12, Rule::counts_lossy_format);
  };
  if (in.array_counts) {
    judge_counts(Place::array_count, *in.array_counts);
    std::uint64_t sum = 0;
    for (std::uint64_t i = 0; i < in.array_counts->size(); ++i) {
      const UsageCount& c = (*in.array_counts)[i];
      if (c.count == 0) report(Rule::counts_zero, Place::array_count, i, 0, 1);
      sum += c.count;
    }
    require(sum <= in.limits.triangles, Rule::counts_limit, sum, in.limits.triangles);
  }
  const bool geometry_counted = in.geometry_counts && (in.sets & EXT) != 0;
  if (geometry_counted) judge_counts(Place::geometry_count, *in.geometry_counts);

  // Indices.
  std::uint64_t indices_there = 0;
  if (in.indexed) {
    const bool ext = in.encoding == Encoding::u16 || in.encoding == Encoding::u32;
    require(!((in.sets & EXT) != 0 && !ext) && !((in.sets & (KHR | DXR)) != 0 && is_signed(in.encoding)),
            Rule::index_encoding, static_cast<std::uint64_t>(in.encoding), 0);
    require(in.index_stride % size == 0, Rule::index_stride, in.index_stride, size);
    require(in.index_stride >> 32 == 0, Rule::index_stride_most, in.index_stride, 0xffffffff);
    require(in.index_stride == size, Rule::index_tight, in.index_stride, size);
    require(in.indices.size() / size <= in.triangles, Rule::index_count, in.indices.size() / size,
            in.triangles);
    indices_there = detail::readable(in.indices.size(), size, in.index_stride, in.triangles);
    if (indices_there < in.triangles)
      report(Rule::index_size, Place::triangle, indices_there, in.indices.size(), in.triangles);
  }
  bool all_named = whole && (!in.indexed || indices_there == in.triangles);
  std::vector<std::pair<std::uint64_t, std::uint64_t>> references;  // record, number of references
  if (in.indexed) {
    const std::uint64_t looked_at =
        in.index_stride == 0 ? std::min<std::uint64_t>(indices_there, 1) : indices_there;
    for (std::uint64_t t = 0; t < looked_at; ++t) {
      const Meaning m = meaning(code_at(in.indices, in.encoding, in.index_stride, t), in.encoding);
      if (m.kind == Meaning::Kind::special) continue;
      if (m.kind == Meaning::Kind::unknown) {
        report(Rule::index_special, Place::triangle, t, code_at(in.indices, in.encoding, in.index_stride, t),
               4);
        all_named = false;
        continue;
      }
      const std::uint64_t record = std::uint64_t{m.index} + in.base_triangle;
      if (record >= in.record_count) {
        report(Rule::index_range, Place::triangle, t, record, in.record_count);
        all_named = false;
        continue;
      }
      references.push_back({record, in.index_stride == 0 ? in.triangles : 1});
    }
  } else {
    const std::uint64_t named = in.record_count > in.base_triangle ? in.record_count - in.base_triangle : 0;
    if (in.triangles > named) {
      report(Rule::index_range, Place::triangle, named, named + in.base_triangle, in.record_count);
      all_named = false;
    } else if (whole) {
      for (std::uint64_t t = 0; t < in.triangles; ++t) references.push_back({t + in.base_triangle, 1});
    }
  }

  // Histograms: the given counts against the actual ones.
  const Histogram of_array = array_histogram(records);
  Histogram of_geometry;
  if (all_named)
    for (const auto& [record, times] : references)
      of_geometry[{records[record].level, records[record].format}] += times;
  const auto compare = [&](Rule rule, const Histogram& said, const Histogram& is) {
    Histogram keys = said;
    keys.insert(is.begin(), is.end());
    for (const auto& [k, _] : keys) {
      const std::uint64_t a = said.contains(k) ? said.at(k) : 0, b = is.contains(k) ? is.at(k) : 0;
      if (a != b) report(rule, Place::level_and_format, detail::key(k.first, k.second), a, b);
    }
    return said == is;
  };
  if (whole && in.array_counts) {
    const Histogram said = histogram(*in.array_counts);
    if (!compare(Rule::counts_array, said, of_array) && all_named && in.triangles > 0 && said == of_geometry)
      report(Rule::counts_array_is_geometry, Place::whole, 0, 0, 0);
  }
  if (all_named && geometry_counted) {
    const Histogram said = histogram(*in.geometry_counts);
    if (!compare(Rule::counts_geometry, said, of_geometry) && said == of_array)
      report(Rule::counts_geometry_is_array, Place::whole, 0, 0, 0);
  }

  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace mmverify::spec::micromap
