#include "impl/micromap/array.hpp"

#include <cstring>

#include "impl/micromap/histogram.hpp"

namespace mmverify::impl::micromap {

std::vector<UsageCount> usage_counts(std::span<const Record> records) {
  detail::Histogram histogram;
  for (const Record& r : records) histogram.add(r.level, r.format, 1);
  return histogram.counts();
}

Bytes record_buffer(std::span<const Record> records) {
  static_assert(sizeof(Record) == record_bytes);
  Bytes bytes(records.size() * record_bytes);
  if (!bytes.empty()) std::memcpy(bytes.data(), records.data(), bytes.size());
  return bytes;
}

Record record_at(std::span<const std::uint8_t> bytes, std::uint64_t at) noexcept {
  Record r;
  std::memcpy(&r, bytes.data() + at, record_bytes);
  return r;
}

}  // namespace mmverify::impl::micromap
