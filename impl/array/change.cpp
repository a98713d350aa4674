#include "impl/array/change.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

#include "impl/micromap/level.hpp"
#include "impl/micromap/words.hpp"

namespace mmverify::impl::array {
namespace {

using micromap::micro_triangles;
using micromap::packed_bytes;
using micromap::Record;

constexpr std::uint32_t nowhere = 0xffffffff;

std::size_t index_bytes(const Part& part) { return micromap::width(part.encoding) / 8; }

std::uint32_t code_at(const Part& part, std::size_t t) {
  std::uint32_t code = 0;
  std::memcpy(&code, part.indices.data() + t * index_bytes(part), index_bytes(part));
  return code;
}

/// Calls f(part, triangle, code, target) for each triangle.
template <class F>
void each_triangle(const Bundle& b, F f) {
  for (std::size_t p = 0; p < b.parts.size(); ++p) {
    const Part& part = b.parts[p];
    for (std::size_t t = 0; t < part.indices.size() / index_bytes(part); ++t) {
      const std::uint32_t code = code_at(part, t);
      const Target to =
          target(code, part.encoding, false, part.base, static_cast<std::uint32_t>(b.array.records.size()));
      if (to.kind == Target::Kind::outside)
        throw std::invalid_argument("array: part " + std::to_string(p) + ", triangle " + std::to_string(t) +
                                    ": no such record");
      f(p, t, code, to);
    }
  }
}

/// The bundle with its records in this order, each with its own bytes and zero padding; record r becomes place[r].
Bundle arranged(const Bundle& b, std::span<const std::uint32_t> order,
                const std::vector<std::uint32_t>& place) {
  Bundle out;
  out.array.records.reserve(order.size());
  for (const std::uint32_t r : order) {
    const Record& record = b.array.records[r];
    if ((record.format != 1 && record.format != 2) || record.level > 16)
      throw std::invalid_argument("array: record " + std::to_string(r) + ": no such format or level");
    const Format f = static_cast<Format>(record.format);
    const std::uint64_t all = micro_triangles(record.level) * bits(f), size = (all + 7) / 8;
    if (record.offset + size > b.array.data.size())
      throw std::invalid_argument("array: record " + std::to_string(r) + ": outside the data");
    const auto from = b.array.data.begin() + record.offset;
    // The records may overlap in `b`, so their bytes may not fit once each has its own.
    if (out.array.data.size() > 0xffffffff) throw std::length_error("array: data beyond 2^32 bytes");
    out.array.records.push_back(
        {static_cast<std::uint32_t>(out.array.data.size()), record.level, record.format});
    out.array.data.insert(out.array.data.end(), from, from + static_cast<std::ptrdiff_t>(size));
    if (all % 8 != 0)
      out.array.data.back() =
          static_cast<std::uint8_t>(out.array.data.back() & micromap::detail::low(all % 8));
  }
  for (const Part& part : b.parts) out.parts.push_back({part.encoding, 0, Bytes(part.indices.size())});
  each_triangle(b, [&](std::size_t p, std::size_t t, std::uint32_t code, const Target& to) {
    Part& part = out.parts[p];
    if (to.kind == Target::Kind::record) {
      code = place[static_cast<std::size_t>(to.record)];
      if (code >= micromap::index_limit(part.encoding))
        throw std::length_error("array: part " + std::to_string(p) + ", triangle " + std::to_string(t) +
                                ": index " + std::to_string(code) + " does not fit the encoding");
    }
    std::memcpy(part.indices.data() + t * index_bytes(part), &code, index_bytes(part));
  });
  return out;
}

}  // namespace

Bundle compacted(const Bundle& b) {
  std::vector<std::uint32_t> place(b.array.records.size(), nowhere), order;
  each_triangle(b, [&](std::size_t, std::size_t, std::uint32_t, const Target& to) {
    if (to.kind == Target::Kind::record) place[static_cast<std::size_t>(to.record)] = 0;
  });
  for (std::uint32_t r = 0; r < place.size(); ++r)
    if (place[r] != nowhere) {
      place[r] = static_cast<std::uint32_t>(order.size());
      order.push_back(r);
    }
  return arranged(b, order, place);
}

Bundle reordered(const Bundle& b) {
  std::vector<std::uint32_t> place(b.array.records.size(), nowhere), order;
  const auto next = [&](std::size_t r) {
    if (place[r] != nowhere) return;
    place[r] = static_cast<std::uint32_t>(order.size());
    order.push_back(static_cast<std::uint32_t>(r));
  };
  each_triangle(b, [&](std::size_t, std::size_t, std::uint32_t, const Target& to) {
    if (to.kind == Target::Kind::record) next(static_cast<std::size_t>(to.record));
  });
  for (std::size_t r = 0; r < place.size(); ++r) next(r);
  return arranged(b, order, place);
}

Bundle concatenated(const Bundle& a, const Bundle& b) {
  if (a.array.data.size() + b.array.data.size() > 0xffffffff ||
      a.array.records.size() + b.array.records.size() > 0xffffffff)
    throw std::length_error("array::concatenated: beyond 2^32");
  const std::uint32_t bytes = static_cast<std::uint32_t>(a.array.data.size()),
                      records = static_cast<std::uint32_t>(a.array.records.size());
  Bundle out = a;
  for (const Record& r : b.array.records) out.array.records.push_back({r.offset + bytes, r.level, r.format});
  out.array.data.insert(out.array.data.end(), b.array.data.begin(), b.array.data.end());
  for (const Part& part : b.parts) out.parts.push_back({part.encoding, part.base + records, part.indices});
  return out;
}

Bytes emulated(std::span<const std::uint8_t> four_state, Level level, Level most) {
  if (level <= most || level > 12) throw std::invalid_argument("array::emulated: no level to emulate");
  const std::uint64_t size = packed_bytes(micro_triangles(level), Format::four_state);
  if (four_state.size() < size) throw std::invalid_argument("array::emulated: too few bytes");
  Bytes map(four_state.begin(), four_state.begin() + static_cast<std::ptrdiff_t>(size));
  for (Level n = level; n-- > most;) {
    Bytes below(static_cast<std::size_t>(packed_bytes(micro_triangles(n), Format::four_state)));
    micromap::down(map, Format::four_state, micro_triangles(n), below);
    map.swap(below);
  }
  return map;
}

std::vector<std::uint64_t> blocks(std::span<const std::uint32_t> codes, std::size_t most) {
  std::vector<std::uint64_t> sizes;
  std::vector<std::uint32_t> palette;
  for (const std::uint32_t c : codes) {
    const bool there = std::find(palette.begin(), palette.end(), c) != palette.end();
    if (sizes.empty() || (!there && palette.size() == most)) {
      sizes.push_back(0);
      palette.clear();
    }
    if (!there) palette.push_back(c);
    ++sizes.back();
  }
  return sizes;
}

}  // namespace mmverify::impl::array
