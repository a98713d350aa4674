// Builds an array, a geometry's indices and both histograms from the maps of many triangles.
#pragma once

#include <optional>
#include <string>

#include "spec/array/resolve.hpp"

namespace mmverify::spec::array {

/// The options of a build.
struct BuildOptions {
  Api api = Api::KHR;
  Encoding encoding = Encoding::u32;
  std::uint32_t base = 0;  ///< the record that index 0 names, at most before.size()
  bool special = true;     ///< a uniform map becomes a special index
  bool share = true;       ///< equal level, format and states share a record
  std::uint32_t bound =
      0;  ///< near-duplicate merging: micro-triangles that may differ; above 0 it shares, too
};

/// The result of a build: the array, the geometry that refers to it, both histograms.
struct Built {
  Array array;
  Part part;
  std::vector<micromap::UsageCount> array_counts;
  std::optional<std::vector<micromap::UsageCount>> geometry_counts;  ///< if the API takes them
};

/// The state that serves two maps: theirs if they agree; an unknown one beside T or O; UO for T beside O, a tie
/// counting as opaque.  None for UT beside UO.
constexpr std::optional<State> joined(State a, State b) {
  if (a == b) return a;
  if (micromap::unknown(a) && micromap::unknown(b)) return std::nullopt;
  if (micromap::unknown(a)) return a;
  if (micromap::unknown(b)) return b;
  return State::UO;
}
inline std::optional<States> joined(const States& a, const States& b) {
  States out;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::optional<State> s = joined(a[i], b[i]);
    if (!s) return std::nullopt;
    out.push_back(*s);
  }
  return out;
}

/// The number of micro-triangles in which two maps differ.
inline std::uint64_t differences(const States& a, const States& b) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

namespace detail {

[[noreturn]] inline void refuse_build(const std::string& what) {
  throw std::invalid_argument("array::build: " + what);
}

/// Refuses a map that is none; t: its number.
inline void check_map(const Map& map, std::size_t t) {
  if (map.level > 12 || map.states.size() != micromap::micro_triangles(map.level))
    refuse_build("map " + std::to_string(t) + ": not 4^level states of a level up to 12");
  for (const State s : map.states)
    if (!micromap::holds(map.format, s))
      refuse_build("map " + std::to_string(t) + ": an unknown state in 2-state");
}

/// A record of a build: its map, and the maps of this build that use it.
struct Entry {
  Map map;
  std::vector<const Map*> users;
};

/// The states of the record if the map joins it; none if one of its users would differ in more than `bound`.
inline std::optional<States> states_after_joining(const Entry& e, const Map& map, std::uint32_t bound) {
  if (e.map.format != Format::four_state || map.format != Format::four_state || e.map.level != map.level)
    return std::nullopt;
  const std::optional<States> both = joined(e.map.states, map.states);
  if (!both || differences(*both, map.states) > bound) return std::nullopt;
  for (const Map* user : e.users)
    if (differences(*both, user->states) > bound) return std::nullopt;
  return both;
}

/// The record that the map takes, which is added if none serves; the first `before` ones are not of this build.
inline std::size_t take_record(std::vector<Entry>& records, std::size_t before, const Map& map,
                               const BuildOptions& o) {
  std::size_t at = records.size();
  if (o.share || o.bound > 0)
    for (std::size_t r = records.size(); r-- > o.base;)
      if (records[r].map.level == map.level && records[r].map.format == map.format &&
          records[r].map.states == map.states)
        at = r;
  if (at == records.size() && o.bound > 0)
    for (std::size_t r = records.size(); r-- > before;)
      if (states_after_joining(records[r], map, o.bound)) at = r;
  if (at == records.size())
    records.push_back({map, {}});
  else if (at >= before && records[at].map.states != map.states)
    records[at].map.states = *states_after_joining(records[at], map, o.bound);
  if (at >= before) records[at].users.push_back(&map);
  return at;
}

inline Array array_of(const std::vector<Entry>& records) {
  Array array;
  for (const Entry& e : records) {
    const Bytes bytes = micromap::pack(e.map.states, e.map.format);
    array.records.push_back({static_cast<std::uint32_t>(array.data.size()),
                             static_cast<std::uint16_t>(e.map.level),
                             static_cast<std::uint16_t>(e.map.format)});
    array.data.insert(array.data.end(), bytes.begin(), bytes.end());
  }
  return array;
}

}  // namespace detail

/// Builds a geometry's maps, in their order, behind an array in which each map of `before` has a record of its own.
///   With `special`, a uniform map becomes a special index.  Else, with `share` or bound > 0, the map takes the first
///   equal record from base on.  Else, with bound > 0, it joins the first 4-state record of this build and of its level
///   that admits it: no triangle of the record may differ from its map in more than `bound` micro-triangles.  Else it
///   gets a new record at the end, its bytes at the end of the data.  A record's map may change as others join.
/// Domain: maps as micromap::Map has them, levels up to 12, base at most before.size(), an encoding that the API takes;
/// else std::invalid_argument.  An index that the encoding cannot hold: std::length_error, naming the triangle.
inline Built build(std::span<const Map> before, std::span<const Map> maps, const BuildOptions& o) {
  if (!takes(o.api, o.encoding)) detail::refuse_build("indices that the API does not take");
  if (o.base > before.size()) detail::refuse_build("a base triangle beyond the records before");
  std::vector<detail::Entry> records;
  for (std::size_t k = 0; k < before.size(); ++k) {
    detail::check_map(before[k], k);
    records.push_back({before[k], {}});
  }
  Built built;
  built.part = {o.encoding, o.base, {}};
  for (std::size_t t = 0; t < maps.size(); ++t) {
    const Map& map = maps[t];
    detail::check_map(map, t);
    std::uint32_t code = 0;
    if (const auto state = micromap::uniform(map.states); state && o.special) {
      code = micromap::special_code(*state, o.encoding);
    } else {
      const std::uint64_t index = detail::take_record(records, before.size(), map, o) - o.base;
      if (index >= micromap::index_limit(o.encoding))
        throw std::length_error("array::build: triangle " + std::to_string(t) + ": index " +
                                std::to_string(index) + " does not fit the encoding");
      code = static_cast<std::uint32_t>(index);
    }
    for (unsigned j = 0; j < micromap::width(o.encoding) / 8; ++j)
      built.part.indices.push_back(static_cast<std::uint8_t>(code >> 8 * j));
  }
  built.array = detail::array_of(records);
  built.array_counts = micromap::usage_counts(array_histogram(built.array));
  if (requirements(o.api).counts_geometry)
    built.geometry_counts = micromap::usage_counts(geometry_histogram(built.array, built.part));
  return built;
}

}  // namespace mmverify::spec::array
