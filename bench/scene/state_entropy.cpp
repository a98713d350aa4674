#include "bench/scene/state_entropy.hpp"

#include <array>
#include <cmath>

namespace mmverify::bench {
namespace {

/// The information of the counts n in bits: - sum of n log2(n / all).
double information(std::span<const std::uint64_t> counts) {
  double all = 0, bits = 0;
  for (const std::uint64_t n : counts) all += static_cast<double>(n);
  for (const std::uint64_t n : counts)
    if (n != 0) bits -= static_cast<double>(n) * std::log2(static_cast<double>(n) / all);
  return bits;
}

}  // namespace

void StateEntropy::add(std::span<const std::uint8_t> map, std::uint64_t states) {
  const std::uint32_t mask = (1u << bits_) - 1;
  std::uint32_t context = 0;
  for (std::uint64_t k = 0; k < states; ++k) {
    const std::uint32_t state = map[k * bits_ / 8] >> (k * bits_ % 8) & mask;
    const std::uint32_t with_state = context << bits_ | state;
    ++counts_[with_state];
    context = with_state & (contexts - 1);
  }
  states_ += states;
}

double StateEntropy::order_0_bytes() const {
  std::array<std::uint64_t, 4> counts{};
  for (std::size_t k = 0; k < counts_.size(); ++k) counts[k & ((1u << bits_) - 1)] += counts_[k];
  return information(counts) / 8;
}

std::optional<double> StateEntropy::context_bytes() const {
  if (states_ < least_states) return {};
  double bits = 0;
  const std::size_t each = std::size_t{1} << bits_;
  for (std::size_t k = 0; k < counts_.size(); k += each) bits += information({&counts_[k], each});
  return bits / 8;
}

}  // namespace mmverify::bench
