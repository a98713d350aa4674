// Micromaps in packed form, many states to a word: packing, force-2-state, counts, special indices.
//
// A packed map is 4^n states of b bits, LSB first, in packed_bytes(4^n, format) bytes.  Bits after the last state are
// ignored on reading and zero on writing.  Every function takes a number of states, not a level, and any number works.
// Output spans have the exact size, input spans at least it, or std::invalid_argument is thrown and nothing is written.
// Input and output must not overlap.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace mmverify::impl::micromap {

/// A subdivision level n: 4^n micro-triangles.
using Level = std::uint32_t;

/// The 4-state codes.  Source: VkOpacityMicromapSpecialIndexKHR's order; Succinct Opacity Micromaps, 3.1.
enum class State : std::uint8_t {
  T = 0,   ///< transparent
  O = 1,   ///< opaque
  UT = 2,  ///< unknown; transparent under force-2-state
  UO = 3,  ///< unknown; opaque under force-2-state
};

/// Source: VkOpacityMicromapFormatKHR.
enum class Format : std::uint16_t { two_state = 1, four_state = 2 };

/// The bits b of one state.
constexpr unsigned bits(Format f) noexcept { return f == Format::two_state ? 1 : 2; }

/// The number of micro-triangles, 4^n.  Domain: n in 0..31.
constexpr std::uint64_t micro_triangles(Level n) noexcept { return std::uint64_t{1} << (2 * n); }

/// The bytes of a packed map, ceil(count b / 8).  Domain: count below 2^62.
constexpr std::uint64_t packed_bytes(std::uint64_t count, Format f) noexcept {
  return (count * bits(f) + 7) / 8;
}

/// Force-2-state, the low bit of the code: T and UT become T, O and UO become O.
/// Law: micromap.force2
constexpr State force2(State s) noexcept { return static_cast<State>(static_cast<unsigned>(s) & 1); }

/// Packs states.  Domain: codes 0..3, in 2-state 0..1, else std::invalid_argument.
/// Law: micromap.packing, micromap.packing_any_count
void pack(std::span<const State> states, Format f, std::span<std::uint8_t> out);

/// Unpacks out.size() states.
/// Law: micromap.packing, micromap.packing_any_count
void unpack(std::span<const std::uint8_t> bytes, Format f, std::span<State> out);

/// Force-2-state of a packed 4-state map, as a packed 2-state map: the even bits.
/// Law: micromap.force2, micromap.on_samples
void force2(std::span<const std::uint8_t> four_state, std::uint64_t count, std::span<std::uint8_t> two_state);

/// A packed 2-state map as a packed 4-state map.
/// Law: micromap.force2, micromap.on_samples
void widen(std::span<const std::uint8_t> two_state, std::uint64_t count, std::span<std::uint8_t> four_state);

/// The state of a uniform map; none if states differ or count = 0.
/// Test: impl_micromap_test
std::optional<State> uniform(std::span<const std::uint8_t> bytes, Format f, std::uint64_t count);

/// A number of micro-triangles for each state, by code.
using StateCounts = std::array<std::uint64_t, 4>;
/// The number of micro-triangles of each state.
/// Test: impl_micromap_test
StateCounts count_states(std::span<const std::uint8_t> bytes, Format f, std::uint64_t count);

/// The changes of a 4-state map by a lossy form: count[was][is], by code.
struct Substitutions {
  std::array<StateCounts, 4> count{};

  /// KHR's rule: any state may become UT or UO, none becomes T or O.
  /// Law: lossy.judges, lossy.judges_on_samples
  bool allowed() const noexcept;
  /// T and O may become unknown; nothing else changes.
  /// Law: lossy.judges, lossy.judges_on_samples
  bool conservative() const noexcept;
  /// T may become UT and O may become UO; nothing else changes, so that force-2-state sees no difference.
  /// Law: lossy.judges, lossy.judges_on_samples
  bool force2_stable() const noexcept;
};
/// Counts the changes from one packed 4-state map to another, micro-triangle by micro-triangle.
/// Domain: both have packed_bytes(count, four_state) bytes or more, else std::invalid_argument.
/// Law: lossy.judges, lossy.judges_on_samples
Substitutions substitutions(std::span<const std::uint8_t> was, std::span<const std::uint8_t> is,
                            std::uint64_t count);

// ---- Special indices

/// The encoding of an index buffer.  Vulkan and DirectX allow the three unsigned ones, glTF all five.
enum class Encoding : std::uint8_t { u8, u16, u32, i16, i32 };

/// The bits of a code in this encoding.
/// Law: micromap.special_indices, micromap.special_indices_32
constexpr unsigned width(Encoding e) noexcept {
  return e == Encoding::u8 ? 8 : e == Encoding::u16 || e == Encoding::i16 ? 16 : 32;
}
/// Whether codes are signed numbers in two's complement.
/// Law: micromap.special_indices, micromap.special_indices_32
constexpr bool is_signed(Encoding e) noexcept { return e == Encoding::i16 || e == Encoding::i32; }

/// The number of plain indices: 2^w - 4 for an unsigned encoding of w bits, 2^(w-1) for a signed one.
/// Law: micromap.special_indices, micromap.special_indices_32
constexpr std::uint64_t index_limit(Encoding e) noexcept {
  return is_signed(e) ? std::uint64_t{1} << (width(e) - 1) : (std::uint64_t{1} << width(e)) - 4;
}

/// The code of a special index, -1 T, -2 O, -3 UT, -4 UO: two's complement, which is NOT s, in the encoding's width.
/// Law: micromap.special_indices, micromap.special_indices_32
constexpr std::uint32_t special_code(State s, Encoding e) noexcept {
  return ~static_cast<std::uint32_t>(s) & (0xffffffffu >> (32 - width(e)));
}

/// The state of a special code; none for other codes.  Domain: every code; bits beyond the width are ignored.
/// Law: micromap.special_indices, micromap.special_indices_32
constexpr std::optional<State> special_state(std::uint32_t code, Encoding e) noexcept {
  const std::uint32_t s = ~code & (0xffffffffu >> (32 - width(e)));
  return s < 4 ? std::optional(static_cast<State>(s)) : std::nullopt;
}

/// Whether a code is a plain index: neither special nor, in a signed encoding, below -4.  Domain: code < 2^width.
/// Law: micromap.special_indices, micromap.special_indices_32
constexpr bool is_index(std::uint32_t code, Encoding e) noexcept { return code < index_limit(e); }

}  // namespace mmverify::impl::micromap
