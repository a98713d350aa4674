// The array of micromaps that a build takes: triangle records, data, usage counts, and a geometry's index
// buffer into it.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "spec/micromap/micromap.hpp"

namespace mmverify::spec::micromap {

/// The place, level and format of a map's bytes.  Source: VkMicromapTriangleKHR.
struct Record {
  std::uint32_t offset;  ///< first byte in the data
  std::uint16_t level;
  std::uint16_t format;
  friend constexpr bool operator==(const Record&, const Record&) = default;
};
inline constexpr std::uint64_t record_bytes = 8;

/// Source: VkMicromapUsageKHR.
struct UsageCount {
  std::uint32_t count, level, format;
  friend constexpr bool operator==(const UsageCount&, const UsageCount&) = default;
};

/// Counts by (level, format).
using Histogram = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t>;

/// The histogram of usage counts: those of one level and format add up.
/// Source: VkAccelerationStructureGeometryMicromapDataKHR.
inline Histogram histogram(std::span<const UsageCount> counts) {
  Histogram sum;
  for (const UsageCount& c : counts)
    if (c.count != 0) sum[{c.level, c.format}] += c.count;
  return sum;
}

/// A histogram as usage counts, ordered by level, then format, none of them zero.
inline std::vector<UsageCount> usage_counts(const Histogram& sum) {
  std::vector<UsageCount> counts;
  for (const auto& [key, count] : sum)
    counts.push_back({static_cast<std::uint32_t>(count), key.first, key.second});
  return counts;
}

/// One triangle's micromap.  Domain: 4^level states that the format holds.
struct Map {
  Level level = 0;
  Format format = Format::four_state;
  States states;
};

/// The input of a micromap build.
struct Array {
  std::vector<Record> records;
  Bytes data;
  friend bool operator==(const Array&, const Array&) = default;
};

/// The input of a geometry's build beside the array.
struct Geometry {
  Bytes indices;  ///< one code a triangle, tightly packed, little-endian
  std::vector<UsageCount> counts;
  friend bool operator==(const Geometry&, const Geometry&) = default;
};

/// The options of append().
struct Options {
  Encoding encoding = Encoding::u32;
  std::uint32_t base_triangle = 0;
  bool deduplicate = true;  ///< equal level, format and states share one record
  bool special = true;      ///< a uniform map becomes a special index and needs no record
};

/// The array's histogram: its records.
inline Histogram array_histogram(std::span<const Record> records) {
  Histogram sum;
  for (const Record& r : records) ++sum[{r.level, r.format}];
  return sum;
}

/// The geometry's histogram: the record of each triangle after indirection, baseTriangle added to plain
/// indices; special indices are left out.
/// Domain: plain indices that name a record.  Source: VkAccelerationStructureTrianglesOpacityMicromapEXT.
inline Histogram geometry_histogram(std::span<const Record> records, std::span<const std::uint8_t> indices,
                                    Encoding e, std::uint32_t base_triangle) {
  Histogram sum;
  const std::uint64_t stride = width(e) / 8;
  for (std::uint64_t t = 0; t < indices.size() / stride; ++t) {
    const Meaning m = meaning(code_at(indices, e, stride, t), e);
    if (m.kind != Meaning::Kind::index) continue;
    const Record& r = records[std::uint64_t{m.index} + base_triangle];
    ++sum[{r.level, r.format}];
  }
  return sum;
}

/// Adds a geometry's maps, in their order, to an array.
/// With `special`, a uniform map becomes a special index.  With `deduplicate`, another map takes the first equal record
/// from base_triangle on.  Else it gets a new record at the end, its bytes at the end of the data.  A triangle's index
/// is its record less base_triangle.
/// Domain: base_triangle at most the number of records; maps as Map has them; else std::invalid_argument.  An index
/// that the encoding cannot hold, or data beyond 2^32 bytes: std::length_error, naming the triangle.  After an error
/// the array is as before.
inline Geometry append(Array& array, std::span<const Map> maps, const Options& options) {
  if (options.base_triangle > array.records.size())
    throw std::invalid_argument("micromap::append: baseTriangle " + std::to_string(options.base_triangle) +
                                " of " + std::to_string(array.records.size()) + " records");
  Array grown = array;
  Geometry geometry;
  const auto same = [&](const Record& r, const Map& map, const Bytes& bytes) {
    return r.level == map.level && r.format == static_cast<std::uint16_t>(map.format) &&
           std::uint64_t{r.offset} + bytes.size() <= grown.data.size() &&
           unpack(std::span(grown.data).subspan(r.offset, bytes.size()), map.format, map.states.size()) ==
               map.states;
  };
  for (std::size_t t = 0; t < maps.size(); ++t) {
    const Map& map = maps[t];
    if (map.level > 16 || map.states.size() != micro_triangles(map.level))
      throw std::invalid_argument("micromap::append: triangle " + std::to_string(t) + ": not 4^level states");
    const Bytes bytes = pack(map.states, map.format);
    std::uint32_t code = 0;
    if (const auto state = uniform(map.states); state && options.special) {
      code = special_code(*state, options.encoding);
    } else {
      std::size_t record = options.deduplicate ? options.base_triangle : grown.records.size();
      while (record < grown.records.size() && !same(grown.records[record], map, bytes)) ++record;
      if (record == grown.records.size()) {
        if (grown.data.size() > 0xffffffff)
          throw std::length_error("micromap::append: triangle " + std::to_string(t) +
                                  ": its bytes begin beyond 2^32");
        grown.records.push_back({static_cast<std::uint32_t>(grown.data.size()),
                                 static_cast<std::uint16_t>(map.level),
                                 static_cast<std::uint16_t>(map.format)});
        grown.data.insert(grown.data.end(), bytes.begin(), bytes.end());
      }
      const std::uint64_t index = record - options.base_triangle;
      if (index >= index_limit(options.encoding))
        throw std::length_error("micromap::append: triangle " + std::to_string(t) + ": index " +
                                std::to_string(index) + " does not fit the encoding, which has " +
                                std::to_string(index_limit(options.encoding)));
      code = static_cast<std::uint32_t>(index);
    }
    for (unsigned j = 0; j < width(options.encoding) / 8; ++j)
      geometry.indices.push_back(static_cast<std::uint8_t>(code >> 8 * j));
  }
  geometry.counts = usage_counts(
      geometry_histogram(grown.records, geometry.indices, options.encoding, options.base_triangle));
  array = std::move(grown);
  return geometry;
}

/// Records as bytes: 8 each, little-endian, tightly packed.
inline Bytes record_buffer(std::span<const Record> records) {
  Bytes bytes;
  for (const Record& r : records)
    for (unsigned j = 0; j < record_bytes; ++j) {
      const std::uint32_t word = j < 4 ? r.offset : r.level | std::uint32_t{r.format} << 16;
      bytes.push_back(static_cast<std::uint8_t>(word >> 8 * (j % 4)));
    }
  return bytes;
}

/// The record at a byte.  Domain: at + 8 <= bytes.
inline Record record_at(std::span<const std::uint8_t> bytes, std::uint64_t at) {
  const auto word = [&](std::uint64_t from) {
    return static_cast<std::uint32_t>(bytes[from]) | static_cast<std::uint32_t>(bytes[from + 1]) << 8 |
           static_cast<std::uint32_t>(bytes[from + 2]) << 16 |
           static_cast<std::uint32_t>(bytes[from + 3]) << 24;
  };
  const std::uint32_t high = word(at + 4);
  return {word(at), static_cast<std::uint16_t>(high), static_cast<std::uint16_t>(high >> 16)};
}

/// The state of a triangle at micro-triangle i of its map, as a traversal fetches it: through the index buffer, the
/// record and the packed bytes, or through the special index.
/// Domain: a clean array; t a triangle; i below 4^level of its map (any i for a special index).
inline State fetch(const Array& array, const Geometry& geometry, Encoding e, std::uint32_t base_triangle,
                   std::uint64_t t, std::uint64_t i) {
  const Meaning m = meaning(code_at(geometry.indices, e, width(e) / 8, t), e);
  if (m.kind == Meaning::Kind::special) return m.state;
  const Record& r = array.records.at(std::uint64_t{m.index} + base_triangle);
  return unpack(std::span(array.data).subspan(r.offset), static_cast<Format>(r.format), i + 1).back();
}

}  // namespace mmverify::spec::micromap
