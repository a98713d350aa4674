// Changes of arrays after which each triangle resolves as before: compact, reorder, concatenate.
#pragma once

#include <algorithm>
#include <map>
#include <string>

#include "spec/array/resolve.hpp"

namespace mmverify::spec::array {

/// Domain of all functions below: each plain index of a part names a record, and each record's bytes are in the data.

/// The bundle with its records in the order `order`, which names each at most once; the others are removed.  Each
/// record's bytes follow those of the one before it.  Parts get base 0 and keep their encoding.
/// Domain: every record that a part refers to is in `order`.  An index that its encoding cannot hold:
/// std::length_error, naming part and triangle.
inline Bundle arranged(const Bundle& b, std::span<const std::uint64_t> order) {
  Bundle out;
  std::map<std::uint64_t, std::uint64_t> place;
  for (const std::uint64_t r : order) {
    const Map map = map_of(b.array, r);
    const Bytes bytes = micromap::pack(map.states, map.format);
    place[r] = out.array.records.size();
    out.array.records.push_back({static_cast<std::uint32_t>(out.array.data.size()), b.array.records[r].level,
                                 b.array.records[r].format});
    out.array.data.insert(out.array.data.end(), bytes.begin(), bytes.end());
  }
  for (std::size_t p = 0; p < b.parts.size(); ++p) {
    const Part& part = b.parts[p];
    Part moved{part.encoding, 0, {}};
    for (std::uint64_t t = 0; t < triangles(part); ++t) {
      const Target to = target(b, part, t);
      std::uint32_t value = code(part, t);
      if (to.kind == Target::Kind::record) {
        const std::uint64_t index = place.at(to.record);
        if (index >= micromap::index_limit(part.encoding))
          throw std::length_error("array: part " + std::to_string(p) + ", triangle " + std::to_string(t) +
                                  ": index " + std::to_string(index) + " does not fit the encoding");
        value = static_cast<std::uint32_t>(index);
      }
      for (unsigned j = 0; j < micromap::width(part.encoding) / 8; ++j)
        moved.indices.push_back(static_cast<std::uint8_t>(value >> 8 * j));
    }
    out.parts.push_back(moved);
  }
  return out;
}

/// The records in use, in the order of part and triangle of their first use.
inline std::vector<std::uint64_t> in_order_of_use(const Bundle& b) {
  std::vector<std::uint64_t> order;
  for (const Part& part : b.parts)
    for (std::uint64_t t = 0; t < triangles(part); ++t)
      if (const Target to = target(b, part, t);
          to.kind == Target::Kind::record && std::find(order.begin(), order.end(), to.record) == order.end())
        order.push_back(to.record);
  return order;
}

/// The bundle without unused records and without bytes of no record; the other records keep their order.
inline Bundle compacted(const Bundle& b) {
  std::vector<std::uint64_t> order = in_order_of_use(b);
  std::sort(order.begin(), order.end());
  return arranged(b, order);
}

/// The bundle with its records in the order of their first use, then the unused ones in their order.
inline Bundle reordered(const Bundle& b) {
  std::vector<std::uint64_t> order = in_order_of_use(b);
  for (std::uint64_t r = 0; r < b.array.records.size(); ++r)
    if (std::find(order.begin(), order.end(), r) == order.end()) order.push_back(r);
  return arranged(b, order);
}

/// The second array behind the first: the second's offsets grow by the first's data, its bases by the first's records;
/// indices stay.  Data or records beyond 2^32: std::length_error.
inline Bundle concatenated(const Bundle& a, const Bundle& b) {
  Bundle out = a;
  if (a.array.data.size() + b.array.data.size() > 0xffffffff ||
      a.array.records.size() + b.array.records.size() > 0xffffffff)
    throw std::length_error("array::concatenated: beyond 2^32");
  for (const Record& r : b.array.records)
    out.array.records.push_back(
        {static_cast<std::uint32_t>(r.offset + a.array.data.size()), r.level, r.format});
  out.array.data.insert(out.array.data.end(), b.array.data.begin(), b.array.data.end());
  for (const Part& part : b.parts)
    out.parts.push_back(
        {part.encoding, static_cast<std::uint32_t>(part.base + a.array.records.size()), part.indices});
  return out;
}

}  // namespace mmverify::spec::array
