#include "impl/micromap/validate.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <tuple>
#include <utility>

#include "impl/micromap/histogram.hpp"

namespace mmverify::impl::micromap {
namespace {

using detail::Histogram;

constexpr std::uint64_t beyond = std::numeric_limits<std::uint64_t>::max();

bool known(std::uint32_t format) { return format == 1 || format == 2; }

// One byte beyond a region's last.  From level 30 on it is beyond every buffer, and its number does not matter.
std::uint64_t region_end(const Record& r) {
  if (r.level > 29) return beyond;
  return r.offset + packed_bytes(micro_triangles(r.level), static_cast<Format>(r.format));
}

// The number of elements of `size` bytes, `stride` apart, that lie whole within `bytes`; `count` at most.
std::uint64_t readable(std::uint64_t bytes, std::uint64_t size, std::uint64_t stride, std::uint64_t count) {
  if (bytes < size) return 0;
  return stride == 0 ? count : std::min(count, (bytes - size) / stride + 1);
}

using Sums = std::map<Histogram::Key, std::uint64_t>;

Sums sums(std::span<const UsageCount> counts) {
  Histogram said;
  for (const UsageCount& c : counts) said.add(c.level, c.format, c.count);
  return said.sums();
}

struct LevelRules {
  Rule format, level, lossy, twelve, lossy_format;
};

/// The common part of both validators: the array's input, and the list of violations.
class Part {
 protected:
  Part(const Input& array, std::size_t most) : of_(array), most_(most) {}

  void report(Rule rule, Place place, std::uint64_t where, std::uint64_t found, std::uint64_t other) {
    if (!any_of(text(rule).sets)) return;
    std::vector<Violation>& list = found_[static_cast<std::size_t>(rule)];
    const Violation one{rule, place, where, found, other};
    const bool all = place == Place::array_count || place == Place::geometry_count;
    if (all || list.size() < most_) return list.push_back(one);
    // Overlaps are not found in the order of records.
    if (list.size() == most_ && more_[rule]++ == 0) std::sort(list.begin(), list.end());
    if (!list.empty() && one < list.back()) {
      list.insert(std::upper_bound(list.begin(), list.end(), one), one);
      list.pop_back();
    }
  }
  void require(bool holds, Rule rule, std::uint64_t found, std::uint64_t other) {
    if (!holds) report(rule, Place::whole, 0, found, other);
  }
  bool any_of(Sets sets) const { return (of_.sets & sets) != 0; }

  void judge(Place place, std::uint64_t where, std::uint32_t level, std::uint32_t format,
             const LevelRules& rules) {
    const Limits& most = of_.limits;
    if (level > 12) report(rules.twelve, place, where, level, 12);
    if (format == 1) {
      if (level > most.two_state_level) report(rules.level, place, where, level, most.two_state_level);
      if (of_.lossy) report(rules.lossy_format, place, where, format, 2);
    } else if (format == 2) {
      // A lossy build has its own limit; EXT has no lossy builds.
      if (level > most.four_state_level && (!of_.lossy || any_of(EXT)))
        report(rules.level, place, where, level, most.four_state_level);
      if (level > most.lossy_four_state_level && of_.lossy)
        report(rules.lossy, place, where, level, most.lossy_four_state_level);
    } else {
      report(rules.format, place, where, format, 2);
    }
  }

  // Reports each difference between the given counts and the actual ones.
  void compare(Rule rule, const Sums& said, const Sums& there) {
    Sums keys = said;
    keys.insert(there.begin(), there.end());
    for (const auto& [key, _] : keys) {
      const auto number = [&key = key](const Sums& sums) {
        const auto at = sums.find(key);
        return at == sums.end() ? 0 : at->second;
      };
      if (number(said) != number(there))
        report(rule, Place::level_and_format, std::uint64_t{key.first} << 32 | key.second, number(said),
               number(there));
    }
  }

  // All violations: rules in their order, and the violations of each rule in theirs.
  Violations taken() {
    Violations all;
    for (std::vector<Violation>& of_rule : found_) {
      std::sort(of_rule.begin(), of_rule.end());
      all.list.insert(all.list.end(), of_rule.begin(), of_rule.end());
      of_rule = {};
    }
    all.more = std::move(more_);
    return all;
  }

  const Input& of_;

 private:
  std::size_t most_;
  std::array<std::vector<Violation>, static_cast<std::size_t>(Rule::count_)> found_;
  std::map<Rule, std::uint64_t> more_;
};

constexpr LevelRules of_counts{Rule::counts_format, Rule::counts_level, Rule::counts_level_lossy,
                               Rule::counts_level_12, Rule::counts_lossy_format};

/// The records of the array, and their histograms, for geometries.
struct Kinds {
  std::vector<Record> records = {};
  bool all = false;  // every record could be read
  Sums there = {}, said = {};
};

class ArrayPart : Part {
 public:
  ArrayPart(const Input& array, std::size_t most) : Part(array, most) {}

  Violations run(Kinds& kinds) {
    addresses_and_strides();
    records(kinds);
    overlap(kinds.records);
    counts(kinds);
    return taken();
  }

 private:
  void addresses_and_strides() {
    for (const auto& [rule, address, multiple] :
         std::initializer_list<std::tuple<Rule, std::uint64_t, unsigned>>{
             {Rule::align_data_256, of_.data_address, 256},
             {Rule::align_records_256, of_.records_address, 256},
             {Rule::align_data_128, of_.data_address, 128},
             {Rule::align_records_128, of_.records_address, 128},
             {Rule::align_records_4, of_.records_address, 4}})
      require(address % multiple == 0, rule, address, multiple);
    require(of_.record_stride >= record_bytes, Rule::stride_least, of_.record_stride, record_bytes);
    require(of_.record_stride % 4 == 0, Rule::stride_multiple, of_.record_stride, 4);
    require(of_.record_stride == record_bytes, Rule::stride_tight, of_.record_stride, record_bytes);
    require(of_.records.size() % record_bytes == 0, Rule::records_whole, of_.records.size(), record_bytes);
  }

  void records(Kinds& kinds) {
    if (of_.record_stride < record_bytes) return;
    const std::uint64_t there =
        readable(of_.records.size(), record_bytes, of_.record_stride, of_.record_count);
    if (there < of_.record_count)
      report(Rule::records_size, Place::record, there, of_.records.size(), of_.record_count);
    kinds.all = there == of_.record_count;
    kinds.records.resize(static_cast<std::size_t>(there));
    Histogram of_array;
    const LevelRules rules{Rule::record_format, Rule::record_level, Rule::record_level_lossy,
                           Rule::record_level_12, Rule::record_lossy_format};
    for (std::uint64_t r = 0; r < there; ++r) {
      const Record record = record_at(of_.records, r * of_.record_stride);
      kinds.records[static_cast<std::size_t>(r)] = record;
      of_array.add(record.level, record.format, 1);
      judge(Place::record, r, record.level, record.format, rules);
      if (!known(record.format)) continue;
      const std::uint64_t end = region_end(record);
      if (end > of_.data.size()) report(Rule::record_region, Place::record, r, end, of_.data.size());
    }
    kinds.there = of_array.sums();
  }

  // Reports overlaps: records in the order of their first bytes, each against the furthest end before it.
  void overlap(const std::vector<Record>& records) {
    if (!any_of(text(Rule::record_overlap).sets)) return;
    std::vector<std::uint64_t> order;  // sorted by offset, then number
    order.reserve(records.size());
    for (std::size_t r = 0; r < records.size(); ++r)
      if (known(records[r].format)) order.push_back(r);
    const auto offset = [&](std::uint64_t r) { return records[static_cast<std::size_t>(r)].offset; };
    const auto before = [&](std::uint64_t a, std::uint64_t b) {
      return std::pair(offset(a), a) < std::pair(offset(b), b);
    };
    // Most bakers write their records in order.
    if (!std::is_sorted(order.begin(), order.end(), before)) std::sort(order.begin(), order.end(), before);
    std::uint64_t furthest = 0, by = 0;
    for (const std::uint64_t r : order) {
      if (offset(r) < furthest) report(Rule::record_overlap, Place::record, r, by, offset(r));
      const std::uint64_t end = region_end(records[static_cast<std::size_t>(r)]);
      if (end > furthest) {
        furthest = end;
        by = r;
      }
    }
  }

  void counts(Kinds& kinds) {
    if (!of_.array_counts) return;
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < of_.array_counts->size(); ++i) {
      const UsageCount& c = (*of_.array_counts)[i];
      judge(Place::array_count, i, c.level, c.format, of_counts);
      if (c.count == 0) report(Rule::counts_zero, Place::array_count, i, 0, 1);
      sum += c.count;
    }
    require(sum <= of_.limits.triangles, Rule::counts_limit, sum, of_.limits.triangles);
    kinds.said = sums(*of_.array_counts);
    if (kinds.all) compare(Rule::counts_array, kinds.said, kinds.there);
  }
};

class GeometryPart : Part {
 public:
  GeometryPart(const Input& array, const Kinds& kinds, const Input& geometry, std::size_t most)
      : Part(array, most), kinds_(kinds), in_(geometry) {}

  Violations run() {
    addresses_and_strides();
    counts();
    indices();
    histograms();
    return taken();
  }

 private:
  void addresses_and_strides() {
    if (!in_.indexed) return;
    const std::uint64_t size = width(in_.encoding) / 8, there = in_.indices.size() / size;
    const bool plain_ext = in_.encoding == Encoding::u16 || in_.encoding == Encoding::u32;
    require(in_.indices_address % size == 0, Rule::align_index, in_.indices_address, size);
    require((plain_ext || !any_of(EXT)) && (!is_signed(in_.encoding) || !any_of(KHR | DXR)),
            Rule::index_encoding, static_cast<std::uint64_t>(in_.encoding), 0);
    require(in_.index_stride % size == 0, Rule::index_stride, in_.index_stride, size);
    require(in_.index_stride <= 0xffffffff, Rule::index_stride_most, in_.index_stride, 0xffffffff);
    require(in_.index_stride == size, Rule::index_tight, in_.index_stride, size);
    require(there <= in_.triangles, Rule::index_count, there, in_.triangles);
  }

  void counts() {
    if (!in_.geometry_counts || !any_of(EXT)) return;
    for (std::size_t i = 0; i < in_.geometry_counts->size(); ++i) {
      const UsageCount& c = (*in_.geometry_counts)[i];
      judge(Place::geometry_count, i, c.level, c.format, of_counts);
    }
  }

  void indices() {
    all_named_ = kinds_.all;
    if (in_.indexed) {
      switch (in_.encoding) {
        case Encoding::u8: return read_indices<std::uint8_t>();
        case Encoding::u16:
        case Encoding::i16: return read_indices<std::uint16_t>();
        case Encoding::u32:
        case Encoding::i32: return read_indices<std::uint32_t>();
      }
    }
    const std::uint64_t base = in_.base_triangle,
                        named = of_.record_count > base ? of_.record_count - base : 0;
    if (in_.triangles > named) {
      report(Rule::index_range, Place::triangle, named, named + base, of_.record_count);
      all_named_ = false;
    }
    if (!all_named_) return;
    for (std::uint64_t t = 0; t < in_.triangles; ++t) refer(t + base, 1);
  }

  template <class Code>
  void read_indices() {
    const std::uint64_t there = readable(in_.indices.size(), sizeof(Code), in_.index_stride, in_.triangles);
    if (there < in_.triangles) {
      report(Rule::index_size, Place::triangle, there, in_.indices.size(), in_.triangles);
      all_named_ = false;
    }
    const bool one_for_all = in_.index_stride == 0;
    const std::uint64_t looked_at = one_for_all ? std::min<std::uint64_t>(there, 1) : there;
    const std::uint64_t times = one_for_all ? in_.triangles : 1;
    for (std::uint64_t t = 0; t < looked_at; ++t) {
      Code code;
      std::memcpy(&code, in_.indices.data() + t * in_.index_stride, sizeof code);
      if (is_index(code, in_.encoding)) {
        const std::uint64_t record = std::uint64_t{code} + in_.base_triangle;
        if (record >= of_.record_count) {
          report(Rule::index_range, Place::triangle, t, record, of_.record_count);
          all_named_ = false;
        } else if (kinds_.all) {
          refer(record, times);
        }
      } else if (!special_state(code, in_.encoding)) {
        report(Rule::index_special, Place::triangle, t, code, 4);
        all_named_ = false;
      }
    }
  }

  void refer(std::uint64_t record, std::uint64_t times) {
    const Record& r = kinds_.records[static_cast<std::size_t>(record)];
    of_geometry_.add(r.level, r.format, times);
  }

  void histograms() {
    if (!all_named_) return;
    const Sums named = of_geometry_.sums();
    if (of_.array_counts && in_.triangles > 0 && kinds_.said == named && kinds_.said != kinds_.there)
      report(Rule::counts_array_is_geometry, Place::whole, 0, 0, 0);
    if (!in_.geometry_counts || !any_of(EXT)) return;
    const Sums said = sums(*in_.geometry_counts);
    compare(Rule::counts_geometry, said, named);
    if (said != named && said == kinds_.there) report(Rule::counts_geometry_is_array, Place::whole, 0, 0, 0);
  }

  const Kinds& kinds_;
  const Input& in_;
  bool all_named_ = false;  // every record could be read, and every triangle names a record or a state
  Histogram of_geometry_;
};

}  // namespace

struct ArrayValidator::Judged {
  Input array;
  std::size_t most;
  Kinds kinds = {};
  Violations found = {};
};

ArrayValidator::ArrayValidator(const Input& array, std::size_t most) {
  auto judged = std::make_unique<Judged>(Judged{array, most});
  judged->found = ArrayPart(judged->array, most).run(judged->kinds);
  judged_ = std::move(judged);
}
ArrayValidator::~ArrayValidator() = default;

const Violations& ArrayValidator::array() const { return judged_->found; }

Violations ArrayValidator::geometry(const Input& geometry) const {
  return GeometryPart(judged_->array, judged_->kinds, geometry, judged_->most).run();
}

std::vector<Violation> validate(const Input& in) {
  const ArrayValidator validator(in, std::numeric_limits<std::size_t>::max());
  std::vector<Violation> all = validator.array().list;
  const std::vector<Violation> of_geometry = validator.geometry(in).list;
  all.insert(all.end(), of_geometry.begin(), of_geometry.end());
  std::sort(all.begin(), all.end());
  return all;
}

namespace {

std::string told(std::uint64_t x) { return std::to_string(x); }

std::string place_of(const Violation& v) {
  switch (v.place) {
    case Place::whole: return "";
    case Place::record: return "record " + told(v.where) + ": ";
    case Place::array_count: return "array's usage count " + told(v.where) + ": ";
    case Place::geometry_count: return "geometry's usage count " + told(v.where) + ": ";
    case Place::level_and_format:
      return "level " + told(v.where >> 32) + ", format " + told(v.where & 0xffffffff) + ": ";
    case Place::triangle: return "triangle " + told(v.where) + ": ";
  }
  return "";
}

std::string found_of_stride(const Violation& v) {
  return "the stride is " + told(v.found) + ", not " + (v.rule == Rule::stride_least ? "at least " : "") +
         (v.rule == Rule::stride_multiple || v.rule == Rule::index_stride ? "a multiple of " : "") +
         told(v.other);
}

std::string found_of_counts(const Violation& v) {
  switch (v.rule) {
    case Rule::counts_zero: return "counts nothing";
    case Rule::counts_limit:
      return "the usage counts add up to " + told(v.found) +
             ", above maxMicromapTriangles = " + told(v.other);
    case Rule::counts_array:
      return "the array's usage counts say " + told(v.found) + ", there are " + told(v.other) + " records";
    case Rule::counts_geometry:
      return "the geometry's usage counts say " + told(v.found) + ", there are " + told(v.other) +
             " triangles";
    case Rule::counts_array_is_geometry: return "the array's usage counts are the geometry's";
    case Rule::counts_geometry_is_array: return "the geometry's usage counts are the array's";
    default: return "";
  }
}

std::string found_of_indices(const Violation& v) {
  switch (v.rule) {
    case Rule::index_encoding: {
      constexpr const char* names[] = {"u8", "u16", "u32", "i16", "i32"};
      return std::string("indices are ") + (v.found < 5 ? names[v.found] : "of no known type");
    }
    case Rule::index_stride_most: return "the stride is " + told(v.found) + ", above " + told(v.other);
    case Rule::index_size:
      return "no index in the buffer of " + told(v.found) + " bytes; there should be " + told(v.other);
    case Rule::index_count: return told(v.found) + " indices for " + told(v.other) + " triangles";
    case Rule::index_special: return "code " + told(v.found) + " is below -4";
    case Rule::index_range: return "record " + told(v.found) + " of " + told(v.other);
    default: return "";
  }
}

std::string found_of(const Violation& v) {
  switch (v.rule) {
    case Rule::align_data_256:
    case Rule::align_records_256:
    case Rule::align_data_128:
    case Rule::align_records_128:
    case Rule::align_records_4:
    case Rule::align_index: return "address " + told(v.found) + " is no multiple of " + told(v.other);
    case Rule::stride_least:
    case Rule::stride_multiple:
    case Rule::stride_tight:
    case Rule::index_stride:
    case Rule::index_tight: return found_of_stride(v);
    case Rule::records_whole: return told(v.found) + " bytes are no multiple of " + told(v.other);
    case Rule::records_size:
      return "missing from the buffer of " + told(v.found) + " bytes; there should be " + told(v.other) +
             " records";
    case Rule::record_format:
    case Rule::counts_format: return "format " + told(v.found) + " is neither 1 nor 2";
    case Rule::record_level:
    case Rule::record_level_lossy:
    case Rule::record_level_12:
    case Rule::counts_level:
    case Rule::counts_level_lossy:
    case Rule::counts_level_12: return "level " + told(v.found) + " is above " + told(v.other);
    case Rule::record_lossy_format:
    case Rule::counts_lossy_format: return "2-state in a lossy build";
    case Rule::record_region:
      return (v.found == beyond ? "its bytes end beyond all numbers" : "its bytes end at " + told(v.found)) +
             ", the data at " + told(v.other);
    case Rule::record_overlap:
      return "its first byte, " + told(v.other) + ", belongs to record " + told(v.found);
    case Rule::counts_zero:
    case Rule::counts_limit:
    case Rule::counts_array:
    case Rule::counts_geometry:
    case Rule::counts_array_is_geometry:
    case Rule::counts_geometry_is_array: return found_of_counts(v);
    case Rule::index_encoding:
    case Rule::index_stride_most:
    case Rule::index_size:
    case Rule::index_count:
    case Rule::index_special:
    case Rule::index_range: return found_of_indices(v);
    case Rule::count_: break;
  }
  return "";
}

}  // namespace

std::string describe(const Violation& v) {
  std::string sets;
  constexpr std::pair<Sets, const char*> names[] = {{EXT, "EXT"}, {KHR, "KHR"}, {DXR, "DXR"}, {glTF, "glTF"}};
  for (const auto& [set, name] : names)
    if ((text(v.rule).sets & set) != 0) sets += (sets.empty() ? "" : ", ") + std::string(name);
  return std::string(text(v.rule).id) + " (" + sets + "): " + place_of(v) + found_of(v);
}

}  // namespace mmverify::impl::micromap
