#include "impl/micromap/validate.hpp"

#include <algorithm>
#include <cstring>
#include <tuple>
#include <utility>

#include "impl/micromap/histogram.hpp"

namespace mmverify::impl::micromap {
namespace {

using detail::Histogram;

constexpr std::uint64_t beyond = std::numeric_limits<std::uint64_t>::max();

bool known(std::uint32_t format) { return format == 1 || format == 2; }

// One beyond a region's last byte.  From level 30 on it is beyond every buffer, and its number does not
// matter.
std::uint64_t region_end(const Record& r) {
  if (r.level > 29) return beyond;
  return r.offset + packed_bytes(micro_triangles(r.level), static_cast<Format>(r.format));
}

// How many elements of `size` bytes, `stride` apart, lie whole within `bytes`, of `count` that should.
std::uint64_t readable(std::uint64_t bytes, std::uint64_t size, std::uint64_t stride, std::uint64_t count) {
  if (bytes < size) return 0;
  return stride == 0 ? count : std::min(count, (bytes - size) / stride + 1);
}

class Validation {
 public:
  explicit Validation(const Input& in) : in_(in) {}

  std::vector<Violation> run() {
    addresses_and_strides();
    records();
    overlap();
    counts();
    indices();
    histograms();
    std::sort(found_.begin(), found_.end());
    return std::move(found_);
  }

 private:
  void report(Rule rule, Place place, std::uint64_t where, std::uint64_t found, std::uint64_t other) {
    if ((text(rule).sets & in_.sets) != 0) found_.push_back({rule, place, where, found, other});
  }
  void require(bool holds, Rule rule, std::uint64_t found, std::uint64_t other) {
    if (!holds) report(rule, Place::whole, 0, found, other);
  }
  bool any_of(Sets sets) const { return (in_.sets & sets) != 0; }

  void addresses_and_strides() {
    for (const auto& [rule, address, multiple] :
         std::initializer_list<std::tuple<Rule, std::uint64_t, unsigned>>{
             {Rule::align_data_256, in_.data_address, 256},
             {Rule::align_records_256, in_.records_address, 256},
             {Rule::align_data_128, in_.data_address, 128},
             {Rule::align_records_128, in_.records_address, 128},
             {Rule::align_records_4, in_.records_address, 4}})
      require(address % multiple == 0, rule, address, multiple);
    require(in_.record_stride >= record_bytes, Rule::stride_least, in_.record_stride, record_bytes);
    require(in_.record_stride % 4 == 0, Rule::stride_multiple, in_.record_stride, 4);
    require(in_.record_stride == record_bytes, Rule::stride_tight, in_.record_stride, record_bytes);
    require(in_.records.size() % record_bytes == 0, Rule::records_whole, in_.records.size(), record_bytes);
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

  struct LevelRules {
    Rule format, level, lossy, twelve, lossy_format;
  };

  void judge(Place place, std::uint64_t where, std::uint32_t level, std::uint32_t format,
             const LevelRules& rules) {
    const Limits& most = in_.limits;
    if (level > 12) report(rules.twelve, place, where, level, 12);
    if (format == 1) {
      if (level > most.two_state_level) report(rules.level, place, where, level, most.two_state_level);
      if (in_.lossy) report(rules.lossy_format, place, where, format, 2);
    } else if (format == 2) {
      // A lossy build has a limit of its own; EXT has no lossy builds.
      if (level > most.four_state_level && (!in_.lossy || any_of(EXT)))
        report(rules.level, place, where, level, most.four_state_level);
      if (level > most.lossy_four_state_level && in_.lossy)
        report(rules.lossy, place, where, level, most.lossy_four_state_level);
    } else {
      report(rules.format, place, where, format, 2);
    }
  }

  void records() {
    if (in_.record_stride < record_bytes) return;
    const std::uint64_t there =
        readable(in_.records.size(), record_bytes, in_.record_stride, in_.record_count);
    if (there < in_.record_count)
      report(Rule::records_size, Place::record, there, in_.records.size(), in_.record_count);
    all_records_ = there == in_.record_count;
    records_.resize(static_cast<std::size_t>(there));
    const LevelRules rules{Rule::record_format, Rule::record_level, Rule::record_level_lossy,
                           Rule::record_level_12, Rule::record_lossy_format};
    for (std::uint64_t r = 0; r < there; ++r) {
      const Record record = record_at(in_.records, r * in_.record_stride);
      records_[static_cast<std::size_t>(r)] = record;
      of_array_.add(record.level, record.format, 1);
      judge(Place::record, r, record.level, record.format, rules);
      if (!known(record.format)) continue;
      const std::uint64_t end = region_end(record);
      if (end > in_.data.size()) report(Rule::record_region, Place::record, r, end, in_.data.size());
    }
  }

  // In the order of their first bytes, each record against the furthest end of those before it.
  void overlap() {
    if (!any_of(text(Rule::record_overlap).sets)) return;
    std::vector<std::uint64_t> order;  // offset, then number
    order.reserve(records_.size());
    for (std::size_t r = 0; r < records_.size(); ++r)
      if (known(records_[r].format)) order.push_back(r);
    const auto offset = [this](std::uint64_t r) { return records_[static_cast<std::size_t>(r)].offset; };
    const auto before = [&](std::uint64_t a, std::uint64_t b) {
      return std::pair(offset(a), a) < std::pair(offset(b), b);
    };
    // Bakers write their records in order.
    if (!std::is_sorted(order.begin(), order.end(), before)) std::sort(order.begin(), order.end(), before);
    std::uint64_t furthest = 0, by = 0;
    for (const std::uint64_t r : order) {
      if (offset(r) < furthest) report(Rule::record_overlap, Place::record, r, by, offset(r));
      const std::uint64_t end = region_end(records_[static_cast<std::size_t>(r)]);
      if (end > furthest) {
        furthest = end;
        by = r;
      }
    }
  }

  void counts() {
    const LevelRules rules{Rule::counts_format, Rule::counts_level, Rule::counts_level_lossy,
                           Rule::counts_level_12, Rule::counts_lossy_format};
    if (in_.array_counts) {
      std::uint64_t sum = 0;
      for (std::size_t i = 0; i < in_.array_counts->size(); ++i) {
        const UsageCount& c = (*in_.array_counts)[i];
        judge(Place::array_count, i, c.level, c.format, rules);
        if (c.count == 0) report(Rule::counts_zero, Place::array_count, i, 0, 1);
        sum += c.count;
      }
      require(sum <= in_.limits.triangles, Rule::counts_limit, sum, in_.limits.triangles);
    }
    if (in_.geometry_counts && any_of(EXT))
      for (std::size_t i = 0; i < in_.geometry_counts->size(); ++i) {
        const UsageCount& c = (*in_.geometry_counts)[i];
        judge(Place::geometry_count, i, c.level, c.format, rules);
      }
  }

  void indices() {
    all_named_ = all_records_;
    if (in_.indexed) {
      switch (in_.encoding) {
        case Encoding::u8:
          return read_indices<std::uint8_t>();
        case Encoding::u16:
        case Encoding::i16:
          return read_indices<std::uint16_t>();
        case Encoding::u32:
        case Encoding::i32:
          return read_indices<std::uint32_t>();
      }
    }
    const std::uint64_t base = in_.base_triangle,
                        named = in_.record_count > base ? in_.record_count - base : 0;
    if (in_.triangles > named) {
      report(Rule::index_range, Place::triangle, named, named + base, in_.record_count);
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
        if (record >= in_.record_count) {
          report(Rule::index_range, Place::triangle, t, record, in_.record_count);
          all_named_ = false;
        } else if (all_records_) {
          refer(record, times);
        }
      } else if (!special_state(code, in_.encoding)) {
        report(Rule::index_special, Place::triangle, t, code, 4);
        all_named_ = false;
      }
    }
  }

  void refer(std::uint64_t record, std::uint64_t times) {
    const Record& r = records_[static_cast<std::size_t>(record)];
    of_geometry_.add(r.level, r.format, times);
  }

  // Whether the counts are what there is; each difference is reported.
  bool compare(Rule rule, std::span<const UsageCount> counts, const Histogram& is) {
    const auto said = sums(counts), there = is.sums();
    auto keys = said;
    keys.insert(there.begin(), there.end());
    for (const auto& [key, _] : keys) {
      const auto number = [&key = key](const auto& sums) {
        const auto at = sums.find(key);
        return at == sums.end() ? 0 : at->second;
      };
      if (number(said) != number(there))
        report(rule, Place::level_and_format, std::uint64_t{key.first} << 32 | key.second, number(said),
               number(there));
    }
    return said == there;
  }

  static std::map<Histogram::Key, std::uint64_t> sums(std::span<const UsageCount> counts) {
    Histogram said;
    for (const UsageCount& c : counts) said.add(c.level, c.format, c.count);
    return said.sums();
  }

  void histograms() {
    if (all_records_ && in_.array_counts && !compare(Rule::counts_array, *in_.array_counts, of_array_) &&
        all_named_ && in_.triangles > 0 && sums(*in_.array_counts) == of_geometry_.sums())
      report(Rule::counts_array_is_geometry, Place::whole, 0, 0, 0);
    if (all_named_ && in_.geometry_counts && any_of(EXT) &&
        !compare(Rule::counts_geometry, *in_.geometry_counts, of_geometry_) &&
        sums(*in_.geometry_counts) == of_array_.sums())
      report(Rule::counts_geometry_is_array, Place::whole, 0, 0, 0);
  }

  const Input& in_;
  std::vector<Violation> found_;
  std::vector<Record> records_;
  bool all_records_ = false;  // every record could be read
  bool all_named_ = false;    // and every triangle names one, or a state
  Histogram of_array_, of_geometry_;
};

}  // namespace

std::vector<Violation> validate(const Input& in) { return Validation(in).run(); }

std::string describe(const Violation& v) {
  const auto n = [](std::uint64_t x) { return std::to_string(x); };
  const auto place = [&]() -> std::string {
    switch (v.place) {
      case Place::whole:
        return "";
      case Place::record:
        return "record " + n(v.where) + ": ";
      case Place::array_count:
        return "array's usage count " + n(v.where) + ": ";
      case Place::geometry_count:
        return "geometry's usage count " + n(v.where) + ": ";
      case Place::level_and_format:
        return "level " + n(v.where >> 32) + ", format " + n(v.where & 0xffffffff) + ": ";
      case Place::triangle:
        return "triangle " + n(v.where) + ": ";
    }
    return "";
  };
  const auto found = [&]() -> std::string {
    switch (v.rule) {
      case Rule::align_data_256:
      case Rule::align_records_256:
      case Rule::align_data_128:
      case Rule::align_records_128:
      case Rule::align_records_4:
      case Rule::align_index:
        return "address " + n(v.found) + " is no multiple of " + n(v.other);
      case Rule::stride_least:
      case Rule::stride_multiple:
      case Rule::stride_tight:
      case Rule::index_stride:
      case Rule::index_tight:
        return "the stride is " + n(v.found) + ", not " + (v.rule == Rule::stride_least ? "at least " : "") +
               (v.rule == Rule::stride_multiple || v.rule == Rule::index_stride ? "a multiple of " : "") +
               n(v.other);
      case Rule::records_whole:
        return n(v.found) + " bytes are no multiple of " + n(v.other);
      case Rule::records_size:
        return "missing from the buffer of " + n(v.found) + " bytes; there should be " + n(v.other) +
               " records";
      case Rule::record_format:
      case Rule::counts_format:
        return "format " + n(v.found) + " is neither 1 nor 2";
      case Rule::record_level:
      case Rule::record_level_lossy:
      case Rule::record_level_12:
      case Rule::counts_level:
      case Rule::counts_level_lossy:
      case Rule::counts_level_12:
        return "level " + n(v.found) + " is above " + n(v.other);
      case Rule::record_lossy_format:
      case Rule::counts_lossy_format:
        return "2-state in a lossy build";
      case Rule::record_region:
        return (v.found == beyond ? "its bytes end beyond all numbers" : "its bytes end at " + n(v.found)) +
               ", the data at " + n(v.other);
      case Rule::record_overlap:
        return "its first byte, " + n(v.other) + ", belongs to record " + n(v.found);
      case Rule::counts_zero:
        return "counts nothing";
      case Rule::counts_limit:
        return "the usage counts add up to " + n(v.found) + ", above maxMicromapTriangles = " + n(v.other);
      case Rule::counts_array:
        return "the array's usage counts say " + n(v.found) + ", there are " + n(v.other) + " records";
      case Rule::counts_geometry:
        return "the geometry's usage counts say " + n(v.found) + ", there are " + n(v.other) + " triangles";
      case Rule::counts_array_is_geometry:
        return "the array's usage counts are the geometry's";
      case Rule::counts_geometry_is_array:
        return "the geometry's usage counts are the array's";
      case Rule::index_encoding: {
        constexpr const char* names[] = {"u8", "u16", "u32", "i16", "i32"};
        return std::string("indices are ") + (v.found < 5 ? names[v.found] : "of no known type");
      }
      case Rule::index_stride_most:
        return "the stride is " + n(v.found) + ", above " + n(v.other);
      case Rule::index_size:
        return "no index in the buffer of " + n(v.found) + " bytes; there should be " + n(v.other);
      case Rule::index_count:
        return n(v.found) + " indices for " + n(v.other) + " triangles";
      case Rule::index_special:
        return "code " + n(v.found) + " is below -4";
      case Rule::index_range:
        return "record " + n(v.found) + " of " + n(v.other);
      case Rule::count_:
        break;
    }
    return "";
  };
  std::string sets;
  constexpr std::pair<Sets, const char*> names[] = {{EXT, "EXT"}, {KHR, "KHR"}, {DXR, "DXR"}, {glTF, "glTF"}};
  for (const auto& [set, name] : names)
    if ((text(v.rule).sets & set) != 0) sets += (sets.empty() ? "" : ", ") + std::string(name);
  return std::string(text(v.rule).id) + " (" + sets + "): " + place() + found();
}

}  // namespace mmverify::impl::micromap
