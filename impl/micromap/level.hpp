// Packed maps one level up, one level down, and through the 1-bit modes, a word at a time.
//
// Micro-triangle i of level n has the children 4i .. 4i+3 of level n+1, so four neighbours in the packed bytes become
// one.  Spans as in impl/micromap/micromap.hpp.
#pragma once

#include "impl/micromap/micromap.hpp"

namespace mmverify::impl::micromap {

/// Copies each state to its four children; `count` is the number of states of the smaller map.
/// Law: micromap.up, micromap.down_up, micromap.on_samples
void up(std::span<const std::uint8_t> bytes, Format f, std::uint64_t count, std::span<std::uint8_t> out);

/// Merges four children into one state of the same format; `count` is the number of states of the smaller map.
///   4-state: T for four T, O for four O, else UO if at least two are opaque under force-2-state, else UT.
///   Conservative.  2-state: O if at least two are O.  Not conservative: 2-state has no code for children that differ.
/// Force-2-state and down commute.
/// Law: micromap.down, micromap.down_force2, micromap.on_samples
void down(std::span<const std::uint8_t> bytes, Format f, std::uint64_t count, std::span<std::uint8_t> out);

/// The two states that one bit tells apart: T_O is 2-state; C is unknown.
enum class Mode : std::uint8_t { T_O, T_C, O_C };

/// A 4-state map in one bit a state.  T_O: force-2-state; T_C: 0 for T, else 1; O_C: 0 for O, else 1.
/// Law: micromap.modes, micromap.on_samples
void to_mode(std::span<const std::uint8_t> four_state, std::uint64_t count, Mode mode,
             std::span<std::uint8_t> out);

/// The 4-state map of one bit a state.  T_O: T and O; T_C: T and UO; O_C: O and UT.
/// Law: micromap.modes, micromap.on_samples
void from_mode(std::span<const std::uint8_t> one_bit, std::uint64_t count, Mode mode,
               std::span<std::uint8_t> out);

/// The cost of a map in a mode, or in 4-state.
struct Cost {
  std::uint64_t bits, any_hit;  ///< any_hit: micro-triangles where the shader still runs
};
Cost cost(const StateCounts& states) noexcept;
Cost cost(const StateCounts& states, Mode mode) noexcept;

}  // namespace mmverify::impl::micromap
