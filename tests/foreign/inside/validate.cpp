// Topic micromap: the violations of an array.
// Source: docs/MICROMAP.md, "The array validator", its table and the notes above it.
#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <utility>

#include "proofs/micromap/subject.hpp"
#include "tests/foreign/inside/micromap.hpp"

namespace mmverify::tests::foreign {
namespace {

using namespace proofs::micromap;
using proofs::Levels;
using spec::micromap::Place;
using spec::micromap::Rule;
using Counts = std::map<std::pair<std::uint64_t, std::uint64_t>, std::uint64_t>;  // by level and format

constexpr unsigned E = 1, K = 2, D = 4, G = 8;
/// Whose each rule is, in the table's order.
constexpr unsigned whose[] = {E,
                              E,
                              K | D,
                              K,
                              D,
                              D | G,
                              E | K | D | G,
                              K | D,
                              G,
                              E | K | D | G,
                              G,
                              E | K | D | G,
                              E | K,
                              K,
                              D | G,
                              K,
                              E | K | D | G,
                              G,
                              E | K | D | G,
                              E | K,
                              K,
                              D | G,
                              K,
                              G,
                              K,
                              E | K | D | G,
                              E | K | D | G,
                              E,
                              E,
                              E | K | D,
                              E | K | D,
                              E | K,
                              G,
                              E | K | D | G,
                              G,
                              G,
                              E | K | D | G};
static_assert(std::size(whose) == static_cast<std::size_t>(Rule::count_));

struct Entry3 {
  std::uint32_t offset, level, format;
};

/// One look through one input.
class Look {
 public:
  Look(const Input& in, Fault wrong) : in_(in), wrong_(wrong) {}

  std::vector<Violation> all() {
    addresses();
    records();
    overlaps();
    counts();
    indices();
    histograms();
    std::sort(out_.begin(), out_.end());
    return out_;
  }

 private:
  void say(Rule rule, Place place, std::uint64_t where, std::uint64_t found, std::uint64_t other) {
    unsigned sets = whose[static_cast<std::size_t>(rule)];
    if (wrong_ == "data_128_of_khr_alone"_fault && rule == Rule::align_data_128) sets = K;
    if ((sets & in_.sets) != 0) out_.push_back({rule, place, where, found, other});
  }
  void divides(std::uint64_t by, std::uint64_t number, Rule rule) {
    if (number % by != 0) say(rule, Place::whole, 0, number, by);
  }

  void addresses() {
    divides(256, in_.data_address, Rule::align_data_256);
    divides(128, in_.data_address, Rule::align_data_128);
    divides(256, in_.records_address, Rule::align_records_256);
    divides(128, in_.records_address, Rule::align_records_128);
    divides(4, in_.records_address, Rule::align_records_4);
    divides(4, in_.record_stride, Rule::stride_multiple);
    if (in_.record_stride < 8) say(Rule::stride_least, Place::whole, 0, in_.record_stride, 8);
    if (in_.record_stride != 8) say(Rule::stride_tight, Place::whole, 0, in_.record_stride, 8);
    const std::uint64_t each =
        wrong_ == "whole_of_glTF_by_stride"_fault && in_.record_stride > 0 ? in_.record_stride : 8;
    if (in_.records.size() % each != 0) say(Rule::records_whole, Place::whole, 0, in_.records.size(), 8);
  }

  /// The number that `count` little-endian bytes hold.
  static std::uint32_t number(std::span<const std::uint8_t> bytes, std::uint64_t at, unsigned count) {
    std::uint32_t value = 0;
    while (count-- > 0) value = value << 8 | bytes[at + count];
    return value;
  }

  void level_and_format(Place place, std::uint64_t where, std::uint32_t level, std::uint32_t format) {
    const bool of_record = place == Place::record;
    const auto pick = [&](Rule record, Rule count) { return of_record ? record : count; };
    if (format != 1 && format != 2)
      say(pick(Rule::record_format, Rule::counts_format), place, where, format, 2);
    if (level > 12 && !(wrong_ == "geometry_level_12_unseen"_fault && place == Place::geometry_count))
      say(pick(Rule::record_level_12, Rule::counts_level_12), place, where, level, 12);
    const Rule usual = pick(Rule::record_level, Rule::counts_level);
    if (format == 1) {
      if (level > in_.limits.two_state_level) say(usual, place, where, level, in_.limits.two_state_level);
      const bool unseen = wrong_ == "lossy_2_state_of_counts_unseen"_fault && !of_record;
      if (in_.lossy && !unseen)
        say(pick(Rule::record_lossy_format, Rule::counts_lossy_format), place, where, 1, 2);
    }
    if (format == 2) {
      const bool judged = !in_.lossy || (in_.sets & E) != 0 || wrong_ == "lossy_has_the_usual_limit"_fault;
      if (judged && level > in_.limits.four_state_level)
        say(usual, place, where, level, in_.limits.four_state_level);
      if (in_.lossy && level > in_.limits.lossy_four_state_level)
        say(pick(Rule::record_level_lossy, Rule::counts_level_lossy), place, where, level,
            in_.limits.lossy_four_state_level);
    }
  }

  /// One beyond a record's last byte; all ones where that takes more than 64 bits.
  std::uint64_t end(const Entry3& r) const {
    if (r.level > 29 && wrong_ != "huge_level_wraps"_fault) return ~std::uint64_t{0};
    const std::uint64_t bits = (std::uint64_t{1} << (2 * r.level % 64)) * r.format;
    const std::uint64_t sum = r.offset + (bits + 7) / 8;
    return wrong_ == "region_in_32_bits"_fault ? sum & 0xffffffff : sum;
  }

  void records() {
    const std::uint64_t stride = in_.record_stride,
                        last = wrong_ == "last_record_needs_its_stride"_fault ? stride : 8;
    while (stride >= 8 && there_.size() < in_.record_count) {
      const std::uint64_t size = in_.records.size();
      if (size < last || (!there_.empty() && stride > (size - last) / there_.size())) break;
      const std::uint64_t at = there_.size() * stride;
      there_.push_back(
          {number(in_.records, at, 4), number(in_.records, at + 4, 2), number(in_.records, at + 6, 2)});
    }
    complete_ = stride >= 8 && there_.size() == in_.record_count;
    if (stride >= 8 && !complete_)
      say(Rule::records_size, Place::record, there_.size(), in_.records.size(), in_.record_count);
    for (std::uint64_t r = 0; r < there_.size(); ++r) {
      level_and_format(Place::record, r, there_[r].level, there_[r].format);
      if (understood(r) && end(there_[r]) > in_.data.size())
        say(Rule::record_region, Place::record, r, end(there_[r]), in_.data.size());
    }
  }
  bool understood(std::uint64_t r) const { return there_[r].format == 1 || there_[r].format == 2; }

  /// Through the records by their first byte, remembering who reaches furthest.
  void overlaps() {
    std::vector<std::uint64_t> order;
    for (std::uint64_t r = 0; r < there_.size(); ++r)
      if (understood(r)) order.push_back(r);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint64_t a, std::uint64_t b) { return there_[a].offset < there_[b].offset; });
    for (std::size_t k = 1, furthest = 0; k < order.size(); ++k) {
      if (wrong_ == "overlap_with_the_neighbour_alone"_fault) furthest = k - 1;
      const Entry3 &before = there_[order[furthest]], &now = there_[order[k]];
      const bool unseen = wrong_ == "overlap_of_equal_offsets_unseen"_fault && before.offset == now.offset;
      if (end(before) > now.offset && !unseen)
        say(Rule::record_overlap, Place::record, order[k], order[furthest], now.offset);
      if (end(now) > end(before)) furthest = k;
    }
  }

  void counts() {
    if (in_.array_counts) {
      std::uint64_t sum = 0;
      for (std::uint64_t k = 0; k < in_.array_counts->size(); ++k) {
        const UsageCount& c = (*in_.array_counts)[k];
        level_and_format(Place::array_count, k, c.level, c.format);
        if (c.count == 0) say(Rule::counts_zero, Place::array_count, k, 0, 1);
        sum += c.count;
      }
      if (wrong_ == "limit_in_32_bits"_fault) sum &= 0xffffffff;
      if (sum > in_.limits.triangles) say(Rule::counts_limit, Place::whole, 0, sum, in_.limits.triangles);
    }
    if (!geometry_counts()) return;
    for (std::uint64_t k = 0; k < in_.geometry_counts->size(); ++k) {
      const UsageCount& c = (*in_.geometry_counts)[k];
      level_and_format(Place::geometry_count, k, c.level, c.format);
      if (wrong_ == "zero_in_geometry_too"_fault && c.count == 0)
        say(Rule::counts_zero, Place::geometry_count, k, 0, 1);
    }
  }
  bool geometry_counts() const { return in_.geometry_counts && (in_.sets & E) != 0; }

  void indices() {
    named_ = complete_;
    if (in_.indexed) {
      through_the_buffer();
      return;
    }
    // Triangle t has index t: the first beyond the records is the only one listed.
    const std::uint64_t base = in_.base_triangle, count = in_.record_count;
    const std::uint64_t first = count > base ? count - base : 0;
    if (in_.triangles > first) {
      say(Rule::index_range, Place::triangle, first, first + base, count);
      named_ = false;
    }
    for (std::uint64_t t = 0; named_ && t < in_.triangles; ++t) refer(t + base, 1);
  }

  void through_the_buffer() {
    const unsigned width = in_.encoding == Encoding::u8                                     ? 1
                           : in_.encoding == Encoding::u16 || in_.encoding == Encoding::i16 ? 2
                                                                                            : 4;
    const bool has_sign = in_.encoding == Encoding::i16 || in_.encoding == Encoding::i32;
    divides(width, in_.indices_address, Rule::align_index);
    divides(width, in_.index_stride, Rule::index_stride);
    const bool no_ext =
        (in_.sets & E) != 0 && (width == 1 || has_sign) && !(wrong_ == "bytes_are_ext"_fault && width == 1);
    if (no_ext || ((in_.sets & (K | D)) != 0 && has_sign))
      say(Rule::index_encoding, Place::whole, 0, static_cast<std::uint64_t>(in_.encoding), 0);
    if (in_.index_stride > 0xffffffff && wrong_ != "wide_stride_unseen"_fault)
      say(Rule::index_stride_most, Place::whole, 0, in_.index_stride, 0xffffffff);
    if (in_.index_stride != width) say(Rule::index_tight, Place::whole, 0, in_.index_stride, width);
    if (in_.indices.size() / width > in_.triangles)
      say(Rule::index_count, Place::whole, 0, in_.indices.size() / width, in_.triangles);

    std::uint64_t whole = 0;  // triangles that have an index
    if (in_.indices.size() >= width)
      whole = in_.index_stride == 0
                  ? in_.triangles
                  : std::min(in_.triangles, (in_.indices.size() - width) / in_.index_stride + 1);
    if (whole < in_.triangles) {
      say(Rule::index_size, Place::triangle, whole, in_.indices.size(), in_.triangles);
      named_ = named_ && wrong_ == "counts_judged_with_a_missing_record"_fault;
    }
    const bool same = in_.index_stride == 0 && wrong_ != "stride_0_lists_all"_fault;
    bool listed = false;
    for (std::uint64_t t = 0; t < (same ? std::min<std::uint64_t>(whole, 1) : whole); ++t) {
      const std::uint32_t code = number(in_.indices, t * in_.index_stride, width);
      const std::uint64_t limit = std::uint64_t{1} << 8 * width;
      if (code >= limit - 4) {
        if (wrong_ == "special_counts_in_geometry"_fault && !there_.empty()) refer(0, 1);
        if (wrong_ == "base_on_special"_fault && in_.base_triangle >= limit - code) refer(0, 1);
        continue;
      }
      if (has_sign && code >= limit / 2) {
        say(Rule::index_special, Place::triangle, t, code, 4);
        named_ = false;
        continue;
      }
      std::uint64_t record = std::uint64_t{code} + in_.base_triangle;
      if (wrong_ == "range_in_32_bits"_fault) record &= 0xffffffff;
      if (record >= in_.record_count + (wrong_ == "range_lets_the_last_in"_fault ? 1 : 0)) {
        if (!listed || wrong_ != "one_range_is_enough"_fault)
          say(Rule::index_range, Place::triangle, t, record, in_.record_count);
        listed = true;
        named_ = false;
      } else {
        refer(record, same ? in_.triangles : 1);
      }
    }
  }
  void refer(std::uint64_t record, std::uint64_t times) {
    if (record < there_.size()) used_[{there_[record].level, there_[record].format}] += times;
  }

  Counts said(std::span<const UsageCount> counts) const {
    Counts sum;
    for (const UsageCount& c : counts) {
      if (c.count == 0) continue;
      std::uint64_t& to = sum[{c.level, c.format}];
      to = wrong_ == "counts_are_not_added"_fault ? c.count : to + c.count;
    }
    return sum;
  }
  void differences(Rule rule, Counts said, Counts is) {
    for (const auto& [key, n] : said) is.emplace(key, 0);
    for (const auto& [key, n] : is)
      if (said[key] != n) say(rule, Place::level_and_format, key.first << 32 | key.second, said[key], n);
  }
  void histograms() {
    Counts stored;
    for (const Entry3& r : there_) ++stored[{r.level, r.format}];
    if (complete_ && in_.array_counts) {
      const Counts counts = said(*in_.array_counts);
      differences(Rule::counts_array, counts, stored);
      const bool geometry = in_.triangles > 0 || wrong_ == "diagnosis_without_triangles"_fault;
      if (counts != stored && named_ && geometry && counts == used_)
        say(Rule::counts_array_is_geometry, Place::whole, 0, 0, 0);
    }
    if (named_ && geometry_counts()) {
      const Counts counts = said(*in_.geometry_counts);
      differences(Rule::counts_geometry, counts, used_);
      if (counts != used_ && counts == stored) say(Rule::counts_geometry_is_array, Place::whole, 0, 0, 0);
    }
  }

  const Input& in_;
  const Fault wrong_;
  std::vector<Entry3> there_;
  bool complete_ = false, named_ = false;
  Counts used_;
  std::vector<Violation> out_;
};

MicromapSubjectPtr validating_subject(Fault wrong) {
  Functions functions;
  functions.validate = [wrong](const Input& in) { return Look(in, wrong).all(); };
  return std::make_shared<MicromapSubject>("foreign-validator", "the table of rules, read anew",
                                           std::move(functions));
}

InsideFault row(const char* name, const char* wrong) {
  return {"micromap.validate", name, wrong, validating_subject(named(name)), {0, 5}};
}

}  // namespace

InsideRows faults_of_validators() {
  return {
      row("region_in_32_bits", "a record's end wraps at 2^32"),
      row("overlap_with_the_neighbour_alone", "a record is held against the one before it alone"),
      row("overlap_of_equal_offsets_unseen", "records that begin at one byte do not overlap"),
      row("range_in_32_bits", "index and base triangle add up in 32 bits"),
      row("last_record_needs_its_stride", "the last record takes its whole stride"),
      row("lossy_has_the_usual_limit", "a lossy KHR build is held against the usual limit too"),
      row("special_counts_in_geometry", "a special index counts as record 0"),
      row("stride_0_lists_all", "with a stride of 0 each triangle is listed"),
      row("counts_are_not_added", "of two counts of one level and format the last one holds"),
      row("zero_in_geometry_too", "a geometry's count must not be zero either"),
      row("bytes_are_ext", "EXT has indices of a byte"),
      row("wide_stride_unseen", "an index stride of 2^32 passes"),
      row("data_128_of_khr_alone", "DXR does not ask for data at a multiple of 128"),
      row("limit_in_32_bits", "the sum of the counts wraps at 2^32"),
      row("huge_level_wraps", "the size of a map of level 32 is that of level 0"),
      row("geometry_level_12_unseen", "a geometry's count may have level 13"),
      row("diagnosis_without_triangles", "the array's counts are the geometry's though there is none"),
      row("range_lets_the_last_in", "an index may be the number of records"),
      row("one_range_is_enough", "only the first index out of range is listed"),
      row("counts_judged_with_a_missing_record", "counts are judged though indices are missing"),
      row("base_on_special", "the base triangle is added to a special index, which then wraps to record 0"),
      row("whole_of_glTF_by_stride", "the record buffer holds whole strides"),
      row("lossy_2_state_of_counts_unseen", "a lossy build may have 2-state counts"),
  };
}

InsideRows right_validators() { return {row("validates", "")}; }

}  // namespace mmverify::tests::foreign
