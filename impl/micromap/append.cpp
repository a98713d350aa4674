#include "impl/micromap/append.hpp"

#include <algorithm>
#include <cstring>
#include <string>

#include "impl/micromap/histogram.hpp"
#include "impl/micromap/words.hpp"

namespace mmverify::impl::micromap {
namespace {

using namespace detail;

// The packed bytes of a map with zero padding, so that equal maps have equal bytes.
struct Canonical {
  std::span<const std::uint8_t> body;  ///< all bytes but the last
  std::uint8_t last;

  Canonical(std::span<const std::uint8_t> bytes, std::uint64_t count, Format f) {
    const std::uint64_t all = count * bits(f), whole = (all - 1) / 8;
    body = bytes.first(static_cast<std::size_t>(whole));
    last = static_cast<std::uint8_t>(bytes[static_cast<std::size_t>(whole)] & low(all - 8 * whole));
  }
  friend bool operator==(const Canonical& a, const Canonical& b) {
    return a.last == b.last && std::equal(a.body.begin(), a.body.end(), b.body.begin(), b.body.end());
  }
};

std::uint64_t hash(const Canonical& map, Level level, Format f) {
  std::uint64_t h = level * 4 + static_cast<std::uint64_t>(f);
  const auto mix = [&h](std::uint64_t word) {
    h = (h ^ word) * 0x9e3779b97f4a7c15;
    h ^= h >> 32;
  };
  each_word(map.body, 8 * std::uint64_t{map.body.size()},
            [&](std::uint64_t word, std::uint64_t) { mix(word); });
  mix(map.last);
  return h;
}

// A hash table of records by their maps.  Open addressing; a slot is the record's number + 1, or 0.
class RecordTable {
 public:
  explicit RecordTable(std::size_t expected) : slots_(std::bit_ceil(2 * expected + 16)) {}

  // The slot of an equal record, or an empty one.  The table is at most half full.
  template <class Equal>
  std::uint32_t& find(std::uint64_t hash, Equal equal) {
    std::size_t at = static_cast<std::size_t>(hash) & (slots_.size() - 1);
    while (slots_[at] != 0 && !equal(slots_[at] - 1)) at = (at + 1) & (slots_.size() - 1);
    return slots_[at];
  }

 private:
  std::vector<std::uint32_t> slots_;
};

// The bytes of a record, if its format, its level and its bytes exist.
std::optional<Canonical> map_of(const Array& array, const Record& r) {
  if ((r.format != 1 && r.format != 2) || r.level > 16) return std::nullopt;
  const Format f = static_cast<Format>(r.format);
  const std::uint64_t count = micro_triangles(r.level), size = packed_bytes(count, f);
  if (r.offset + size > array.data.size()) return std::nullopt;
  return Canonical(std::span(array.data).subspan(r.offset, static_cast<std::size_t>(size)), count, f);
}

void check(const PackedMap& map, std::size_t t) {
  if (map.level > 16 || (map.format != Format::two_state && map.format != Format::four_state) ||
      map.bytes.size() < packed_bytes(micro_triangles(map.level), map.format))
    throw std::invalid_argument("micromap::append: triangle " + std::to_string(t) + ": not 4^level states");
}

[[noreturn]] void too_long(std::size_t t, const std::string& what) {
  throw std::length_error("micromap::append: triangle " + std::to_string(t) + ": " + what);
}

Geometry append_checked(Array& array, std::span<const PackedMap> maps, const Options& options) {
  const std::uint32_t base = options.base_triangle;
  const std::uint64_t limit = index_limit(options.encoding);
  const std::size_t index_bytes = width(options.encoding) / 8;
  Geometry geometry;
  geometry.indices.resize(maps.size() * index_bytes);
  Histogram histogram;

  const std::size_t shared = options.deduplicate ? array.records.size() - base : 0;
  RecordTable known(options.deduplicate ? shared + maps.size() : 0);
  const auto slot_for = [&](const Canonical& map, Level level, Format f) -> std::uint32_t& {
    return known.find(hash(map, level, f), [&](std::uint32_t number) {
      const Record& r = array.records[number];
      return r.level == level && r.format == static_cast<std::uint16_t>(f) && *map_of(array, r) == map;
    });
  };
  for (std::size_t r = base; r < base + shared; ++r) {
    const Record& record = array.records[r];
    const std::optional<Canonical> map = map_of(array, record);
    if (!map) continue;
    std::uint32_t& slot = slot_for(*map, record.level, static_cast<Format>(record.format));
    if (slot == 0) slot = static_cast<std::uint32_t>(r + 1);
  }

  for (std::size_t t = 0; t < maps.size(); ++t) {
    const PackedMap& m = maps[t];
    const std::uint64_t count = micro_triangles(m.level);
    std::uint32_t code = 0;
    if (const auto state = options.special ? uniform(m.bytes, m.format, count) : std::nullopt) {
      code = special_code(*state, options.encoding);
    } else {
      const Canonical map(m.bytes, count, m.format);
      std::uint32_t unshared = 0;
      std::uint32_t& slot = options.deduplicate ? slot_for(map, m.level, m.format) : unshared;
      if (slot == 0) {
        if (array.data.size() > 0xffffffff) too_long(t, "its bytes begin beyond 2^32");
        if (array.records.size() >= 0xffffffff) too_long(t, "more than 2^32 - 1 records");
        array.records.push_back({static_cast<std::uint32_t>(array.data.size()),
                                 static_cast<std::uint16_t>(m.level), static_cast<std::uint16_t>(m.format)});
        array.data.insert(array.data.end(), map.body.begin(), map.body.end());
        array.data.push_back(map.last);
        slot = static_cast<std::uint32_t>(array.records.size());
      }
      const std::uint32_t index = slot - 1 - base;
      if (index >= limit)
        too_long(t, "index " + std::to_string(index) + " does not fit the encoding, which has " +
                        std::to_string(limit));
      histogram.add(m.level, static_cast<std::uint32_t>(m.format), 1);
      code = index;
    }
    std::memcpy(geometry.indices.data() + t * index_bytes, &code, index_bytes);
  }
  geometry.counts = histogram.counts();
  return geometry;
}

}  // namespace

Geometry append(Array& array, std::span<const PackedMap> maps, const Options& options) {
  const std::size_t records = array.records.size(), bytes = array.data.size();
  if (options.base_triangle > records)
    throw std::invalid_argument("micromap::append: baseTriangle " + std::to_string(options.base_triangle) +
                                " of " + std::to_string(records) + " records");
  for (std::size_t t = 0; t < maps.size(); ++t) check(maps[t], t);
  try {
    return append_checked(array, maps, options);
  } catch (...) {
    array.records.resize(records);
    array.data.resize(bytes);
    throw;
  }
}

}  // namespace mmverify::impl::micromap
