// The entropy of the states of maps: the least size for a coder with this model.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace mmverify::bench {

/// Counts of each state after each context.  The context of a state is the 16 bits before it in its map,
/// along the curve: the 16 states before with two states, the 8 before with four; before the first state all
/// are T.
class StateEntropy {
 public:
  /// bits: of a state, 1 or 2.
  explicit StateEntropy(std::uint32_t bits) : bits_(bits), counts_(std::size_t{contexts} << bits) {}

  /// Adds the states of a map.  Domain: a packed map of `states` states.
  void add(std::span<const std::uint8_t> map, std::uint64_t states);

  std::uint64_t states() const { return states_; }

  /// N H(S) in bytes: - sum over s of n(s) log2(n(s) / N) / 8, where n(s) of N states are s.  No code takes
  /// less if it gives each state bits by its frequency in all maps alone.
  double order_0_bytes() const;

  /// N H(S | context) in bytes: - sum over c, s of n(c, s) log2(n(c, s) / n(c)) / 8.  No code takes less if
  /// it gives each state bits by its frequency after its context alone; similarity beyond 16 bits of the
  /// curve does not count.
  /// None if there are fewer than 16 states for each of the 2^16 contexts: frequencies of few states say too
  /// little, and the figure would be too low.
  std::optional<double> context_bytes() const;

 private:
  static constexpr std::uint32_t contexts = 1 << 16;
  static constexpr std::uint64_t least_states = std::uint64_t{16} * contexts;

  std::uint32_t bits_;
  std::uint64_t states_ = 0;
  std::vector<std::uint64_t> counts_;  ///< of state s after context c at (c << bits) + s
};

}  // namespace mmverify::bench
