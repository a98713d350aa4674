// Topic micromap: arrays from maps.
// Source: docs/MICROMAP.md, "Building"; VkMicromapTriangleKHR.
#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <tuple>
#include <utility>

#include "proofs/micromap/subject.hpp"
#include "tests/foreign/inside/micromap.hpp"

namespace mmverify::tests::foreign {
namespace {

using namespace proofs::micromap;
using proofs::Levels;

struct Stored {
  std::uint32_t offset, level, format;
};

void put(Bytes& bytes, std::uint64_t value, unsigned count) {
  for (unsigned k = 0; k < count; ++k, value >>= 8) bytes.push_back(static_cast<std::uint8_t>(value));
}

class Builder {
 public:
  explicit Builder(Fault wrong) : wrong_(wrong) {}

  Built build(std::span<const PackedMap> before, std::span<const PackedMap> maps,
              const Options& options) const {
    Work work;
    const bool is_signed = options.encoding == Encoding::i16 || options.encoding == Encoding::i32;
    const unsigned size = options.encoding == Encoding::u8                                         ? 1
                          : options.encoding == Encoding::u16 || options.encoding == Encoding::i16 ? 2
                                                                                                   : 4;
    take_existing(work, before, options.base_triangle);
    for (std::size_t t = 0; t < maps.size(); ++t) {
      const std::uint32_t level = maps[t].level, format = static_cast<std::uint32_t>(maps[t].format);
      const Bytes bytes = cleaned(maps[t], t);
      if (const int state = only(bytes, level, format); state >= 0 && special(options)) {
        int said = state;
        if (wrong_ == "uniform_two_state_is_unknown"_fault && format == 1 && level > 0) said |= 2;
        if (wrong_ == "i16_special_of_uo"_fault && size == 2 && is_signed && said == 3) said = 2;
        put(work.built.indices, ~static_cast<std::uint64_t>(said), size);
        if (wrong_ == "keeps_record_of_special"_fault && state == 3) add(work, bytes, level, format);
        continue;
      }
      const std::uint32_t record = record_of(work, maps[t], bytes, options.deduplicate);
      if (wrong_ != "counts_records_for_geometry"_fault) ++work.in_geometry[{level, format}];
      const std::uint32_t index = record - options.base_triangle;
      put(work.built.indices, wrong_ == "indices_of_a_byte"_fault ? index & 0xff : index, size);
    }
    write_records(work);
    write_counts(work);
    return work.built;
  }

 private:
  struct Work {
    Built built;
    std::vector<Stored> stored;
    std::map<std::tuple<std::uint32_t, std::uint32_t, Bytes>, std::uint32_t> known;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> in_array, in_geometry;
  };

  /// The records that the array holds already; maps may share those from the base triangle on.
  void take_existing(Work& work, std::span<const PackedMap> before, std::uint32_t base_triangle) const {
    for (std::size_t r = 0; r < before.size(); ++r) {
      const std::uint32_t level = before[r].level, format = static_cast<std::uint32_t>(before[r].format);
      const Bytes bytes = cleaned(before[r], r);
      add(work, bytes, level, format);
      if (r >= base_triangle)
        work.known.emplace(std::tuple{level, format, bytes}, static_cast<std::uint32_t>(r));
    }
  }

  void add(Work& work, const Bytes& bytes, std::uint32_t level, std::uint32_t format) const {
    work.stored.push_back(store(work.built, bytes, level, format));
    ++work.in_array[{level, format}];
  }

  /// The record of a map whose cleaned bytes these are: one that may be shared, or a new one.
  std::uint32_t record_of(Work& work, const PackedMap& map, const Bytes& bytes, bool deduplicate) const {
    const std::uint32_t level = map.level, format = static_cast<std::uint32_t>(map.format);
    const auto next = static_cast<std::uint32_t>(work.stored.size());
    Bytes key = bytes;
    if (wrong_ == "turned_maps_share"_fault && level == 1 && format == 2)
      while (key != turned(key) && turned(key) < key) key = turned(key);
    if (wrong_ == "padding_tells_maps_apart"_fault) key = map.bytes;
    const std::tuple name{level, wrong_ == "formats_share"_fault && level > 0 ? 0 : format, key};
    const auto found = work.known.find(name);
    const bool near = wrong_ != "shares_with_the_last_four"_fault ||
                      (found != work.known.end() && found->second + 4 >= work.stored.size());
    if (deduplicate && found != work.known.end() && near) {
      if (wrong_ != "bytes_shared_records_not"_fault) return found->second;
      const Stored copy = work.stored[found->second];
      work.stored.push_back(copy);
      ++work.in_array[{level, format}];
      return next;
    }
    work.known[name] = next;
    add(work, bytes, level, format);
    if (wrong_ == "counts_records_for_geometry"_fault) ++work.in_geometry[{level, format}];
    return next;
  }

  void write_records(Work& work) const {
    Bytes& records = work.built.records;
    for (const Stored& s : work.stored) {
      put(records, wrong_ == "offset_of_12_bits"_fault ? s.offset & 0xfff : s.offset, 4);
      put(records, wrong_ == "level_4_said_of_5"_fault && s.level == 5 ? 4 : s.level, 2);
      put(records, s.format, 2);
    }
  }

  void write_counts(Work& work) const {
    Built& built = work.built;
    for (const auto& [key, count] : work.in_array)
      built.array_counts.push_back({count, key.first, key.second});
    if (wrong_ == "first_of_a_level_is_forgotten"_fault && built.array_counts.size() > 3)
      --built.array_counts[2].count;
    for (const auto& [key, count] : work.in_geometry)
      built.geometry_counts.push_back({count, key.first, key.second});
    if (wrong_ == "counts_references_for_array"_fault) built.array_counts = built.geometry_counts;
  }

  bool special(const Options& options) const {
    if (wrong_ == "special_unasked"_fault) return true;
    if (wrong_ == "never_special"_fault) return false;
    if (wrong_ == "no_special_when_not_sharing"_fault) return options.special && options.deduplicate;
    return options.special;
  }

  /// The map's bytes with nothing in the padding.
  Bytes cleaned(const PackedMap& map, std::size_t t) const {
    const std::uint64_t used =
        (std::uint64_t{1} << 2 * map.level) * (map.format == Format::two_state ? 1 : 2);
    Bytes bytes(map.bytes.begin(), map.bytes.begin() + static_cast<std::ptrdiff_t>((used + 7) / 8));
    if (used < 8 && wrong_ != "padding_is_written"_fault)
      bytes[0] = static_cast<std::uint8_t>(bytes[0] & ((1u << used) - 1));
    if (wrong_ == "last_state_beyond_16_maps"_fault && t > 16)
      bytes.back() = static_cast<std::uint8_t>(bytes.back() & 0x3f);
    return bytes;
  }

  /// The one state of a map; -1 where it has several.
  static int only(const Bytes& bytes, std::uint32_t level, std::uint32_t format) {
    const unsigned b = format, mask = (1u << b) - 1;
    const unsigned first = bytes[0] & mask;
    const std::uint64_t count = std::uint64_t{1} << 2 * level;
    for (std::uint64_t k = 0; k < count; ++k)
      if ((bytes[k * b / 8] >> (k * b % 8) & mask) != first) return -1;
    return static_cast<int>(first);
  }

  /// The four states of a byte, each in the next one's place.
  static Bytes turned(const Bytes& bytes) {
    return {static_cast<std::uint8_t>(bytes[0] << 2 | bytes[0] >> 6)};
  }

  Stored store(Built& built, const Bytes& bytes, std::uint32_t level, std::uint32_t format) const {
    if (wrong_ == "aligns"_fault)  // right: nobody asks for tight data
      while (built.data.size() % 4 != 0) built.data.push_back(0);
    const Stored s{static_cast<std::uint32_t>(built.data.size()), level, format};
    built.data.insert(built.data.end(), bytes.begin(), bytes.end());
    return s;
  }

  Fault wrong_;
};

MicromapSubjectPtr building_subject(Fault wrong) {
  const Builder made(wrong);
  Functions functions;
  functions.build = [made](auto before, auto maps, const Options& options) {
    return made.build(before, maps, options);
  };
  return std::make_shared<MicromapSubject>("foreign-builder", "shares by a dictionary", std::move(functions));
}

InsideFault pair_row(const char* name, const char* wrong, Levels levels) {
  return {"micromap.build", name, wrong, building_subject(named(name)), levels};
}
InsideFault sample_row(const char* name, const char* wrong, Levels levels) {
  return {"micromap.build_on_samples", name, wrong, building_subject(named(name)), levels};
}

}  // namespace

InsideRows faults_of_builders() {
  return {
      pair_row("formats_share", "maps of one level and the same bytes share a record across formats", {1, 1}),
      pair_row("turned_maps_share", "4-state maps whose states are turned in their places share a record",
               {1, 1}),
      pair_row("uniform_two_state_is_unknown", "a uniform 2-state map of level 1 becomes UT or UO", {1, 1}),
      pair_row("counts_records_for_geometry", "the geometry's counts leave out shared records", {1, 1}),
      pair_row("counts_references_for_array", "the array's counts are the geometry's", {1, 1}),
      pair_row("bytes_shared_records_not", "equal maps share bytes, and have a record each", {1, 1}),
      pair_row("keeps_record_of_special", "a map of UO has a special index and a record", {0, 1}),
      pair_row("never_special", "a uniform map has a record though a special index was wanted", {0, 1}),
      pair_row("padding_is_written", "the padding of a map goes into the data", {0, 1}),
      sample_row("formats_share", "maps of one level and the same bytes share a record across formats",
                 {0, 5}),
      sample_row("shares_with_the_last_four", "a record is shared while it is among the last four", {2, 5}),
      sample_row("offset_of_12_bits", "an offset has 12 bits", {5, 5}),
      sample_row("indices_of_a_byte", "an index has 8 bits in every encoding", {0, 5}),
      sample_row("special_unasked", "a uniform map becomes a special index though none was wanted", {0, 5}),
      sample_row("no_special_when_not_sharing", "no special index where records are not shared", {0, 5}),
      sample_row("i16_special_of_uo", "UO is UT in 16 bits with sign", {0, 5}),
      sample_row("last_state_beyond_16_maps", "from the 17th map on, the last states of its bytes are lost",
                 {1, 5}),
      sample_row("first_of_a_level_is_forgotten", "the third of more than three counts is one too low",
                 {1, 5}),
      sample_row("level_4_said_of_5", "a record of level 5 says 4", {5, 5}),
      sample_row("padding_tells_maps_apart", "equal maps with other padding are not shared", {0, 5}),
  };
}

InsideRows right_builders() {
  return {pair_row("builds", "", {0, 1}), sample_row("builds", "", {0, 5}), sample_row("aligns", "", {0, 5})};
}

}  // namespace mmverify::tests::foreign
