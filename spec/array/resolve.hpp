// The target of a triangle of a geometry: a state for all of it, no micromap, or a record's map.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spec/array/api.hpp"
#include "spec/micromap/array.hpp"

namespace mmverify::spec::array {

using micromap::Array;
using micromap::Bytes;
using micromap::Format;
using micromap::Map;
using micromap::Record;
using micromap::State;
using micromap::States;

/// The target of a code in a geometry whose base triangle is `base`, over `records` records.
struct Target {
  enum class Kind : std::uint8_t { special, none, record, outside } kind;
  State state = State::T;    ///< the special index's state
  std::uint64_t record = 0;  ///< the record's number; if outside, the number that no record has
  friend constexpr bool operator==(const Target&, const Target&) = default;
};

/// The target of a code: a special index's state for -1 .. -4; none for -5 in a cluster; else record index + base,
/// which must be less than `records`.
///   base is added to plain indices alone; the sum has 64 bits.
/// Domain: code < 2^width.  A signed code below -4 (-5 in a cluster) is outside, with record = code.
/// Source: VkAccelerationStructureTrianglesOpacityMicromapEXT; EXT_mesh_opacity_micromap, "Lookup".
constexpr Target target(std::uint32_t code, Encoding e, bool cluster, std::uint32_t base,
                        std::uint32_t records) {
  const std::uint32_t none = static_cast<std::uint32_t>((std::uint64_t{1} << micromap::width(e)) - 5);
  const micromap::Meaning m = micromap::meaning(code, e);
  if (m.kind == micromap::Meaning::Kind::special) return {Target::Kind::special, m.state};
  if (cluster && code == none) return {Target::Kind::none};
  if (m.kind == micromap::Meaning::Kind::unknown) return {Target::Kind::outside, State::T, code};
  const std::uint64_t record = std::uint64_t{m.index} + base;
  return {record < records ? Target::Kind::record : Target::Kind::outside, State::T, record};
}

/// A geometry's references into an array.
struct Part {
  Encoding encoding = Encoding::u32;
  std::uint32_t base = 0;
  Bytes indices;  ///< one code a triangle, tightly packed, little-endian
  friend bool operator==(const Part&, const Part&) = default;
};
inline std::uint64_t triangles(const Part& part) {
  return part.indices.size() / (micromap::width(part.encoding) / 8);
}
inline std::uint32_t code(const Part& part, std::uint64_t t) {
  return micromap::code_at(part.indices, part.encoding, micromap::width(part.encoding) / 8, t);
}

/// An array and the geometries that refer to it.
struct Bundle {
  Array array;
  std::vector<Part> parts;
  friend bool operator==(const Bundle&, const Bundle&) = default;
};

inline Target target(const Bundle& b, const Part& part, std::uint64_t t) {
  return target(code(part, t), part.encoding, false, part.base,
                static_cast<std::uint32_t>(b.array.records.size()));
}

/// The map of a record.  Domain: a format, a level up to 16, bytes within the data; else std::invalid_argument.
inline Map map_of(const Array& array, std::uint64_t record) {
  const Record& r = array.records.at(record);
  if (r.format != 1 && r.format != 2) throw std::invalid_argument("array: a record of no format");
  const Format f = static_cast<Format>(r.format);
  if (r.level > 16) throw std::invalid_argument("array: a record of a level above 16");
  const std::uint64_t count = micromap::micro_triangles(r.level);
  if (r.offset > array.data.size() || array.data.size() - r.offset < micromap::packed_bytes(count, f))
    throw std::invalid_argument("array: a record outside the data");
  return {r.level, f, micromap::unpack(std::span(array.data).subspan(r.offset), f, count)};
}

/// Whether state `is` may replace `baked`: it is equal, or unknown.
constexpr bool or_more_unknown(State baked, State is) { return is == baked || micromap::unknown(is); }

/// The number of records by level and format, and the number of a geometry's references.
/// Domain of the second: indices that name records.
inline micromap::Histogram array_histogram(const Array& array) {
  return micromap::array_histogram(array.records);
}
inline micromap::Histogram geometry_histogram(const Array& array, const Part& part) {
  return micromap::geometry_histogram(array.records, part.indices, part.encoding, part.base);
}

}  // namespace mmverify::spec::array
