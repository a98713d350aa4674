#include "impl/array/build.hpp"

#include <bit>
#include <string>
#include <unordered_map>

#include "impl/micromap/append.hpp"
#include "impl/micromap/histogram.hpp"
#include "impl/micromap/words.hpp"

namespace mmverify::impl::array {
namespace {

using namespace micromap::detail;
using micromap::micro_triangles;
using micromap::packed_bytes;

constexpr Level highest = 12;

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument("array::build: " + what); }

void check(std::span<const PackedMap> maps) {
  for (std::size_t t = 0; t < maps.size(); ++t) {
    const PackedMap& m = maps[t];
    if (m.level > highest || (m.format != Format::two_state && m.format != Format::four_state) ||
        m.bytes.size() < packed_bytes(micro_triangles(m.level), m.format))
      refuse("map " + std::to_string(t) + ": not 4^level states of a level up to 12");
  }
}

/// One word of a record joined with that of a map.  The upper bit of a pair is set for an unknown state.
struct Join {
  std::uint64_t states;
  unsigned record_changes, map_changes;
  bool conflict;  ///< UT beside UO
};
Join join(std::uint64_t record, std::uint64_t map) {
  const std::uint64_t ua = record >> 1 & even_bits, ub = map >> 1 & even_bits, va = record & even_bits,
                      vb = map & even_bits;
  const std::uint64_t unknown = ua | ub | (va ^ vb);
  const std::uint64_t value = (ua & va) | (~ua & ub & vb) | (~ua & ~ub & (va | vb));
  return {unknown << 1 | value, static_cast<unsigned>(std::popcount(unknown & ~ua)),
          static_cast<unsigned>(std::popcount(unknown & ~ub)), (ua & ub & (va ^ vb)) != 0};
}

using Words = std::vector<std::uint64_t>;

Words words_of(const PackedMap& m) {
  Words words;
  each_word(m.bytes, micro_triangles(m.level) * bits(m.format),
            [&](std::uint64_t word, std::uint64_t) { words.push_back(word); });
  return words;
}

/// A record that maps may still join.
struct Entry {
  Level level;
  Format format;
  Words words;
  bool fixed;  ///< the record is one of those before this build
  std::uint64_t
      changes;  ///< micro-triangles that differ from the baked map, in the triangle with most of them
};

std::uint64_t hash_of(Level level, Format format, const Words& words) {
  std::uint64_t h = level * 4 + static_cast<std::uint64_t>(format);
  for (const std::uint64_t w : words) {
    h = (h ^ w) * 0x9e3779b97f4a7c15;
    h ^= h >> 32;
  }
  return h;
}

class Merger {
 public:
  Merger(std::uint32_t base, std::uint64_t bound) : base_(base), bound_(bound) {}

  void add_fixed(const PackedMap& m) { add(m.level, m.format, words_of(m), true); }

  /// The record of map m: an equal one, one that m joins, or a new one.
  std::size_t record_of(const PackedMap& m) {
    Words words = words_of(m);
    if (const auto equal = equal_to(m, words)) return *equal;
    if (m.format == Format::four_state)
      for (const std::size_t r : open_[m.level])
        if (joins(entries_[r], words)) {
          const auto [first, last] = known_.equal_range(hash_of(m.level, m.format, entries_[r].words));
          for (auto it = first; it != last; ++it)
            if (it->second == r) {
              known_.erase(it);
              break;
            }
          take(entries_[r], words);
          known_.emplace(hash_of(m.level, m.format, entries_[r].words), r);
          return r;
        }
    return add(m.level, m.format, std::move(words), false);
  }

  const std::vector<Entry>& entries() const { return entries_; }

 private:
  std::optional<std::size_t> equal_to(const PackedMap& m, const Words& words) const {
    std::optional<std::size_t> found;
    const auto [first, last] = known_.equal_range(hash_of(m.level, m.format, words));
    for (auto it = first; it != last; ++it) {
      const Entry& e = entries_[it->second];
      if (e.level == m.level && e.format == m.format && e.words == words && (!found || it->second < *found))
        found = it->second;
    }
    return found;
  }
  std::size_t add(Level level, Format format, Words words, bool fixed) {
    const std::size_t at = entries_.size();
    if (at >= base_) known_.emplace(hash_of(level, format, words), at);
    if (!fixed && format == Format::four_state) open_[level].push_back(at);
    entries_.push_back({level, format, std::move(words), fixed, 0});
    return at;
  }
  bool joins(const Entry& e, const Words& words) const {
    std::uint64_t of_record = e.changes, of_map = 0;
    for (std::size_t k = 0; k < words.size(); ++k) {
      const Join j = join(e.words[k], words[k]);
      of_record += j.record_changes;
      of_map += j.map_changes;
      if (j.conflict || of_record > bound_ || of_map > bound_) return false;
    }
    return true;
  }
  static void take(Entry& e, const Words& words) {
    std::uint64_t of_map = 0;
    for (std::size_t k = 0; k < words.size(); ++k) {
      const Join j = join(e.words[k], words[k]);
      // A record's state is T or O only if all its maps have it there, so each of them gets these changes.
      e.changes += j.record_changes;
      of_map += j.map_changes;
      e.words[k] = j.states;
    }
    e.changes = std::max(e.changes, of_map);
  }

  std::size_t base_;
  std::uint64_t bound_;
  std::vector<Entry> entries_;
  std::unordered_multimap<std::uint64_t, std::size_t>
      known_;  ///< numbers of records from base_ on, by hash_of()
  std::array<std::vector<std::size_t>, highest + 1> open_;  ///< records that maps may join, by level
};

micromap::Geometry merged(micromap::Array& array, std::span<const PackedMap> before,
                          std::span<const PackedMap> maps, const BuildOptions& o) {
  Merger merger(o.base, o.bound);
  for (const PackedMap& m : before) merger.add_fixed(m);
  micromap::Geometry geometry;
  const std::size_t size = micromap::width(o.encoding) / 8;
  geometry.indices.resize(maps.size() * size);
  Histogram histogram;
  for (std::size_t t = 0; t < maps.size(); ++t) {
    const PackedMap& m = maps[t];
    std::uint32_t code = 0;
    if (const auto state =
            o.special ? micromap::uniform(m.bytes, m.format, micro_triangles(m.level)) : std::nullopt) {
      code = micromap::special_code(*state, o.encoding);
    } else {
      const std::uint64_t index = merger.record_of(m) - o.base;
      if (index >= micromap::index_limit(o.encoding))
        throw std::length_error("array::build: triangle " + std::to_string(t) + ": index " +
                                std::to_string(index) + " does not fit the encoding");
      histogram.add(m.level, static_cast<std::uint32_t>(m.format), 1);
      code = static_cast<std::uint32_t>(index);
    }
    std::memcpy(geometry.indices.data() + t * size, &code, size);
  }
  geometry.counts = histogram.counts();
  for (const Entry& e : merger.entries()) {
    const std::size_t bytes = static_cast<std::size_t>(packed_bytes(micro_triangles(e.level), e.format));
    if (array.data.size() > 0xffffffff) throw std::length_error("array::build: data beyond 2^32 bytes");
    array.records.push_back({static_cast<std::uint32_t>(array.data.size()),
                             static_cast<std::uint16_t>(e.level), static_cast<std::uint16_t>(e.format)});
    const std::size_t at = array.data.size();
    array.data.resize(at + bytes);
    std::memcpy(array.data.data() + at, e.words.data(), bytes);
  }
  return geometry;
}

}  // namespace

Built build(std::span<const PackedMap> before, std::span<const PackedMap> maps, const BuildOptions& o) {
  if (!takes(o.api, o.encoding)) refuse("indices that the API does not take");
  if (o.base > before.size()) refuse("a base triangle beyond the records before");
  check(before);
  check(maps);
  Built built;
  micromap::Geometry geometry;
  if (o.bound > 0) {
    geometry = merged(built.array, before, maps, o);
  } else {
    micromap::append(built.array, before, {Encoding::u32, 0, false, false});
    geometry = micromap::append(built.array, maps, {o.encoding, o.base, o.share, o.special});
  }
  built.part = {o.encoding, o.base, std::move(geometry.indices)};
  built.array_counts = micromap::usage_counts(built.array.records);
  if (requirements(o.api).counts_geometry) built.geometry_counts = std::move(geometry.counts);
  return built;
}

}  // namespace mmverify::impl::array
