// Counts by level and format: a table for the usual pairs, a map for the rest.  Internal to impl.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>

#include "impl/micromap/array.hpp"

namespace mmverify::impl::micromap::detail {

class Histogram {
 public:
  using Key = std::pair<std::uint32_t, std::uint32_t>;  ///< level, format

  void add(std::uint32_t level, std::uint32_t format, std::uint64_t times) {
    if (level < levels && format < formats)
      usual_[level * formats + format] += times;
    else if (times != 0)
      rest_[{level, format}] += times;
  }

  /// The counts that are not zero, in order.
  std::map<Key, std::uint64_t> sums() const {
    std::map<Key, std::uint64_t> all = rest_;
    for (std::uint32_t k = 0; k < usual_.size(); ++k)
      if (usual_[k] != 0) all[{k / formats, k % formats}] = usual_[k];
    return all;
  }
  std::vector<UsageCount> counts() const {
    std::vector<UsageCount> all;
    for (const auto& [key, count] : sums())
      all.push_back({static_cast<std::uint32_t>(count), key.first, key.second});
    return all;
  }

 private:
  static constexpr std::uint32_t levels = 17, formats = 3;
  std::array<std::uint64_t, levels * formats> usual_{};
  std::map<Key, std::uint64_t> rest_;
};

}  // namespace mmverify::impl::micromap::detail
