#include "impl/array/lookup.hpp"

#include <cstring>
#include <stdexcept>
#include <string>

#include "impl/index/index.hpp"
#include "impl/micromap/histogram.hpp"

namespace mmverify::impl::array {
namespace {

constexpr Level highest_of_records = 12;

std::size_t code_bytes(const Part& part) { return micromap::width(part.encoding) / 8; }

/// The target of a triangle's code.  Domain: the part has the triangle.
Target target_of(const Part& part, std::size_t triangle, std::size_t records) noexcept {
  std::uint32_t code = 0;
  std::memcpy(&code, part.indices.data() + triangle * code_bytes(part), code_bytes(part));
  return target(code, part.encoding, false, part.base, static_cast<std::uint32_t>(records));
}

}  // namespace

std::optional<State> state_at(const micromap::Array& array, const Part& part, std::uint64_t triangle, float u,
                              float v) noexcept {
  if (triangle >= part.indices.size() / code_bytes(part)) return std::nullopt;
  const Target to = target_of(part, static_cast<std::size_t>(triangle), array.records.size());
  if (to.kind == Target::Kind::special) return to.state;
  if (to.kind != Target::Kind::record) return std::nullopt;
  const micromap::Record& r = array.records[static_cast<std::size_t>(to.record)];
  if (r.level > highest_of_records || (r.format != 1 && r.format != 2)) return std::nullopt;
  const auto format = static_cast<Format>(r.format);
  const std::uint64_t size = micromap::packed_bytes(micromap::micro_triangles(r.level), format);
  if (r.offset + size > array.data.size()) return std::nullopt;
  const std::uint32_t bit = index::from_barycentrics(u, v, r.level) * micromap::bits(format);
  const unsigned states = array.data[r.offset + bit / 8];
  return static_cast<State>(states >> (bit % 8) & ((1u << micromap::bits(format)) - 1));
}

std::vector<UsageCount> geometry_counts(std::span<const micromap::Record> records, const Part& part) {
  micromap::detail::Histogram histogram;
  for (std::size_t t = 0; t < part.indices.size() / code_bytes(part); ++t) {
    const Target to = target_of(part, t, records.size());
    if (to.kind == Target::Kind::special) continue;
    if (to.kind != Target::Kind::record)
      throw std::invalid_argument("array::geometry_counts: triangle " + std::to_string(t) + ": no record " +
                                  std::to_string(to.record));
    const micromap::Record& r = records[static_cast<std::size_t>(to.record)];
    histogram.add(r.level, r.format, 1);
  }
  return histogram.counts();
}

}  // namespace mmverify::impl::array
