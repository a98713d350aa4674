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

/// The rules on levels and formats, of records or of counts.
struct LevelRules {
  Rule format, level, lossy, twelve, lossy_format;
};

/// validate() of one input.
class Validation {
 public:
  explicit Validation(const Input& in) : in_(in) {}

  std::vector<Violation> run() {
    addresses_and_strides();
    read_records();
    regions();
    if (in_force(Rule::record_overlap)) overlaps();
    entries_of_counts();
    if (in_.indexed)
      buffer_of_indices();
    else
      indices_without_buffer();
    histograms();
    std::sort(found_.begin(), found_.end());
    return found_;
  }

 private:
  bool in_force(Rule rule) const { return (text(rule).sets & in_.sets) != 0; }
  void report(Rule rule, Place place, std::uint64_t where, std::uint64_t what, std::uint64_t against) {
    if (in_force(rule)) found_.push_back({rule, place, where, what, against});
  }
  void require(bool holds, Rule rule, std::uint64_t what, std::uint64_t against) {
    if (!holds) report(rule, Place::whole, 0, what, against);
  }

  void addresses_and_strides() {
    require(in_.data_address % 256 == 0, Rule::align_data_256, in_.data_address, 256);
    require(in_.records_address % 256 == 0, Rule::align_records_256, in_.records_address, 256);
    require(in_.data_address % 128 == 0, Rule::align_data_128, in_.data_address, 128);
    require(in_.records_address % 128 == 0, Rule::align_records_128, in_.records_address, 128);
    require(in_.records_address % 4 == 0, Rule::align_records_4, in_.records_address, 4);
    require(in_.record_stride >= record_bytes, Rule::stride_least, in_.record_stride, record_bytes);
    require(in_.record_stride % 4 == 0, Rule::stride_multiple, in_.record_stride, 4);
    require(in_.record_stride == record_bytes, Rule::stride_tight, in_.record_stride, record_bytes);
    require(in_.records.size() % record_bytes == 0, Rule::records_whole, in_.records.size(), record_bytes);
  }

  /// The records that can be read.
  void read_records() {
    const std::uint64_t there =
        in_.record_stride < record_bytes
            ? 0
            : readable(in_.records.size(), record_bytes, in_.record_stride, in_.record_count);
    for (std::uint64_t r = 0; r < there; ++r)
      records_.push_back(record_at(in_.records, r * in_.record_stride));
    if (in_.record_stride >= record_bytes && there < in_.record_count)
      report(Rule::records_size, Place::record, there, in_.records.size(), in_.record_count);
    all_read_ = in_.record_stride >= record_bytes && there == in_.record_count;
    all_named_ = all_read_;
    for (std::uint64_t r = 0; r < records_.size(); ++r)
      judge(Place::record, r, records_[r].level, records_[r].format,
            {Rule::record_format, Rule::record_level, Rule::record_level_lossy, Rule::record_level_12,
             Rule::record_lossy_format});
  }

  /// The format and level of a record or a count.
  void judge(Place place, std::uint64_t where, std::uint32_t level, std::uint32_t format,
             const LevelRules& rules) {
    const Limits& most = in_.limits;
    if (!known(format)) report(rules.format, place, where, format, 2);
    if (format == 1 && level > most.two_state_level)
      report(rules.level, place, where, level, most.two_state_level);
    // A lossy build has its own limit; EXT has no lossy builds.
    if (format == 2 && level > most.four_state_level && (!in_.lossy || (in_.sets & EXT) != 0))
      report(rules.level, place, where, level, most.four_state_level);
    if (format == 2 && level > most.lossy_four_state_level && in_.lossy)
      report(rules.lossy, place, where, level, most.lossy_four_state_level);
    if (level > 12) report(rules.twelve, place, where, level, 12);
    if (format == 1 && in_.lossy) report(rules.lossy_format, place, where, format, 2);
  }

  void regions() {
    for (std::uint64_t r = 0; r < records_.size(); ++r) {
      if (!known(records_[r].format)) continue;
      const std::uint64_t end = region_end(records_[r]);
      if (end > in_.data.size()) report(Rule::record_region, Place::record, r, end, in_.data.size());
    }
  }

  void overlaps() {
    for (std::uint64_t r = 0; r < records_.size(); ++r) {
      if (!known(records_[r].format)) continue;
      std::uint64_t furthest = 0;
      std::optional<std::uint64_t> by;
      for (std::uint64_t k = 0; k < records_.size(); ++k) {
        const bool before = std::pair(records_[k].offset, k) < std::pair(records_[r].offset, r);
        if (!before || !known(records_[k].format)) continue;
        const std::uint64_t end = region_end(records_[k]);
        const bool first =
            by && end == furthest && std::pair(records_[k].offset, k) < std::pair(records_[*by].offset, *by);
        if (!by || end > furthest || first) {
          furthest = end;
          by = k;
        }
      }
      if (by && furthest > records_[r].offset)
        report(Rule::record_overlap, Place::record, r, *by, records_[r].offset);
    }
  }

  bool geometry_counted() const { return in_.geometry_counts && (in_.sets & EXT) != 0; }

  void judge_counts(Place place, std::span<const UsageCount> counts) {
    for (std::uint64_t i = 0; i < counts.size(); ++i)
      judge(place, i, counts[i].level, counts[i].format,
            {Rule::counts_format, Rule::counts_level, Rule::counts_level_lossy, Rule::counts_level_12,
             Rule::counts_lossy_format});
  }

  void entries_of_counts() {
    if (in_.array_counts) {
      judge_counts(Place::array_count, *in_.array_counts);
      std::uint64_t sum = 0;
      for (std::uint64_t i = 0; i < in_.array_counts->size(); ++i) {
        const UsageCount& c = (*in_.array_counts)[i];
        if (c.count == 0) report(Rule::counts_zero, Place::array_count, i, 0, 1);
        sum += c.count;
      }
      require(sum <= in_.limits.triangles, Rule::counts_limit, sum, in_.limits.triangles);
    }
    if (geometry_counted()) judge_counts(Place::geometry_count, *in_.geometry_counts);
  }

  void buffer_of_indices() {
    const std::uint64_t size = width(in_.encoding) / 8;
    require(in_.indices_address % size == 0, Rule::align_index, in_.indices_address, size);
    const bool ext = in_.encoding == Encoding::u16 || in_.encoding == Encoding::u32;
    require(!((in_.sets & EXT) != 0 && !ext) && !((in_.sets & (KHR | DXR)) != 0 && is_signed(in_.encoding)),
            Rule::index_encoding, static_cast<std::uint64_t>(in_.encoding), 0);
    require(in_.index_stride % size == 0, Rule::index_stride, in_.index_stride, size);
    require(in_.index_stride >> 32 == 0, Rule::index_stride_most, in_.index_stride, 0xffffffff);
    require(in_.index_stride == size, Rule::index_tight, in_.index_stride, size);
    require(in_.indices.size() / size <= in_.triangles, Rule::index_count, in_.indices.size() / size,
            in_.triangles);
    const std::uint64_t there = readable(in_.indices.size(), size, in_.index_stride, in_.triangles);
    if (there < in_.triangles) {
      report(Rule::index_size, Place::triangle, there, in_.indices.size(), in_.triangles);
      all_named_ = false;
    }
    const std::uint64_t looked_at = in_.index_stride == 0 ? std::min<std::uint64_t>(there, 1) : there;
    for (std::uint64_t t = 0; t < looked_at; ++t) read_index(t);
  }

  void read_index(std::uint64_t t) {
    const std::uint32_t code = code_at(in_.indices, in_.encoding, in_.index_stride, t);
    const Meaning m = meaning(code, in_.encoding);
    if (m.kind == Meaning::Kind::special) return;
    if (m.kind == Meaning::Kind::unknown) {
      report(Rule::index_special, Place::triangle, t, code, 4);
      all_named_ = false;
      return;
    }
    const std::uint64_t record = std::uint64_t{m.index} + in_.base_triangle;
    if (record >= in_.record_count) {
      report(Rule::index_range, Place::triangle, t, record, in_.record_count);
      all_named_ = false;
      return;
    }
    references_.push_back({record, in_.index_stride == 0 ? in_.triangles : 1});
  }

  void indices_without_buffer() {
    const std::uint64_t named =
        in_.record_count > in_.base_triangle ? in_.record_count - in_.base_triangle : 0;
    if (in_.triangles > named) {
      report(Rule::index_range, Place::triangle, named, named + in_.base_triangle, in_.record_count);
      all_named_ = false;
    } else if (all_read_) {
      for (std::uint64_t t = 0; t < in_.triangles; ++t) references_.push_back({t + in_.base_triangle, 1});
    }
  }

  /// Reports each difference of given counts from the actual ones; false if there is one.
  bool agree(Rule rule, const Histogram& said, const Histogram& is) {
    Histogram keys = said;
    keys.insert(is.begin(), is.end());
    for (const auto& [k, _] : keys) {
      const std::uint64_t a = said.contains(k) ? said.at(k) : 0, b = is.contains(k) ? is.at(k) : 0;
      if (a != b) report(rule, Place::level_and_format, key(k.first, k.second), a, b);
    }
    return said == is;
  }

  void histograms() {
    const Histogram of_array = array_histogram(records_);
    Histogram of_geometry;
    if (all_named_)
      for (const auto& [record, times] : references_)
        of_geometry[{records_[record].level, records_[record].format}] += times;
    if (all_read_ && in_.array_counts) {
      const Histogram said = histogram(*in_.array_counts);
      if (!agree(Rule::counts_array, said, of_array) && all_named_ && in_.triangles > 0 &&
          said == of_geometry)
        report(Rule::counts_array_is_geometry, Place::whole, 0, 0, 0);
    }
    if (all_named_ && geometry_counted()) {
      const Histogram said = histogram(*in_.geometry_counts);
      if (!agree(Rule::counts_geometry, said, of_geometry) && said == of_array)
        report(Rule::counts_geometry_is_array, Place::whole, 0, 0, 0);
    }
  }

  const Input& in_;
  std::vector<Violation> found_;
  std::vector<Record> records_;
  bool all_read_ = false;   ///< every record could be read
  bool all_named_ = false;  ///< and every triangle names a record or a state
  std::vector<std::pair<std::uint64_t, std::uint64_t>> references_;  ///< record, number of references
};

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
inline std::vector<Violation> validate(const Input& in) { return detail::Validation(in).run(); }

}  // namespace mmverify::spec::micromap
