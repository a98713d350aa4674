// Arrays as files: docs/ARRAYS.md, "Files".
#pragma once

#include <optional>
#include <string>

#include "spec/array/resolve.hpp"

namespace mmverify::spec::array {

inline constexpr std::uint32_t newest_version = 2;

/// The checksum FNV-1a, 32 bits.
inline std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
  std::uint32_t sum = 0x811C9DC5;
  for (const std::uint8_t b : bytes) sum = (sum ^ b) * 0x01000193;
  return sum;
}

namespace detail {

inline void put(Bytes& out, std::uint32_t word) {
  for (unsigned j = 0; j < 4; ++j) out.push_back(static_cast<std::uint8_t>(word >> 8 * j));
}
inline void put(Bytes& out, const Bytes& bytes) { out.insert(out.end(), bytes.begin(), bytes.end()); }

}  // namespace detail

/// The file of a bundle.
/// Domain: version 1: one part, of encoding u32; version 2: any bundle.  Else std::invalid_argument.
inline Bytes written(const Bundle& b, std::uint32_t version = newest_version) {
  using detail::put;
  if (version != 1 && version != 2)
    throw std::invalid_argument("array::written: no version " + std::to_string(version));
  if (version == 1 && (b.parts.size() != 1 || b.parts[0].encoding != Encoding::u32))
    throw std::invalid_argument("array::written: version 1 holds one geometry with indices of 32 bits");
  Bytes out;
  for (const char c : std::string("MMARRAYS")) out.push_back(static_cast<std::uint8_t>(c));
  put(out, version);
  put(out, static_cast<std::uint32_t>(b.array.records.size()));
  put(out, static_cast<std::uint32_t>(b.array.data.size()));
  if (version == 1) {
    put(out, static_cast<std::uint32_t>(triangles(b.parts[0])));
    put(out, b.parts[0].base);
  } else {
    put(out, static_cast<std::uint32_t>(b.parts.size()));
    for (const Part& part : b.parts) {
      put(out, static_cast<std::uint32_t>(part.encoding));
      put(out, part.base);
      put(out, static_cast<std::uint32_t>(triangles(part)));
    }
  }
  put(out, micromap::record_buffer(b.array.records));
  for (const Part& part : b.parts) put(out, part.indices);
  put(out, b.array.data);
  if (version == 2) put(out, checksum(out));
  return out;
}

/// The bundle of a file; none for bytes that are no file of versions 1 and 2.  written() gives back the very bytes.
/// The values of records and indices are not checked.
/// Domain: any bytes.
inline std::optional<Bundle> read(std::span<const std::uint8_t> file) {
  std::uint64_t at = 0;
  bool short_of = false;
  const auto word = [&]() -> std::uint32_t {
    if (file.size() - at < 4) {
      short_of = true;
      return 0;
    }
    std::uint32_t value = 0;
    for (unsigned j = 0; j < 4; ++j) value |= std::uint32_t{file[at + j]} << 8 * j;
    at += 4;
    return value;
  };
  const auto bytes = [&](std::uint64_t count) {
    if (file.size() - at < count) {
      short_of = true;
      return Bytes();
    }
    at += count;
    const auto there = file.subspan(at - count, count);
    return Bytes(there.begin(), there.end());
  };
  const std::string name = "MMARRAYS";
  if (file.size() < name.size() || !std::equal(name.begin(), name.end(), file.begin())) return std::nullopt;
  at = name.size();
  const std::uint32_t version = word();
  if (version != 1 && version != 2) return std::nullopt;
  const std::uint64_t records = word(), data = word();
  Bundle b;
  std::vector<std::uint64_t> counts;
  if (version == 1) {
    counts.push_back(word());
    b.parts.push_back({Encoding::u32, word(), {}});
  } else {
    const std::uint32_t parts = word();
    for (std::uint32_t p = 0; p < parts && !short_of; ++p) {
      const std::uint32_t encoding = word();
      if (encoding > 4) return std::nullopt;
      b.parts.push_back({static_cast<Encoding>(encoding), word(), {}});
      counts.push_back(word());
    }
  }
  const Bytes buffer = bytes(micromap::record_bytes * records);
  for (std::uint64_t r = 0; r < buffer.size() / micromap::record_bytes; ++r)
    b.array.records.push_back(micromap::record_at(buffer, r * micromap::record_bytes));
  for (std::size_t p = 0; p < b.parts.size() && !short_of; ++p)
    b.parts[p].indices = bytes(counts[p] * (micromap::width(b.parts[p].encoding) / 8));
  b.array.data = bytes(data);
  if (version == 2) {
    const std::uint32_t sum = checksum(file.first(at));
    if (word() != sum) return std::nullopt;
  }
  if (short_of || at != file.size()) return std::nullopt;
  return b;
}

}  // namespace mmverify::spec::array
