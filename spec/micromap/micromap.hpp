// Micromaps: states, formats, the packing of states in bytes, force-2-state, and special indices for uniform triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "spec/number.hpp"

namespace mmverify::spec::micromap {

using Bytes = std::vector<std::uint8_t>;

// ---- States

/// The state of one micro-triangle, by its 4-state code.  Source: VkOpacityMicromapSpecialIndexKHR's order;
/// Succinct Opacity Micromaps, 3.1.
enum class State : std::uint8_t {
  T = 0,   ///< transparent
  O = 1,   ///< opaque
  UT = 2,  ///< unknown; transparent under force-2-state
  UO = 3,  ///< unknown; opaque under force-2-state
};
using States = std::vector<State>;

constexpr std::uint8_t code(State s) { return static_cast<std::uint8_t>(s); }
constexpr const char* name_of(State s) {
  constexpr const char* names[] = {"T", "O", "UT", "UO"};
  return names[code(s)];
}

/// Whether a state is UT or UO, for which the any-hit shader runs.
constexpr bool unknown(State s) { return s == State::UT || s == State::UO; }

/// Force-2-state: T and UT become T, O and UO become O.  Source: the KHR slides, "force2state".
constexpr State force2(State s) { return s == State::O || s == State::UO ? State::O : State::T; }

/// The unknown state with the same force-2-state: UT for T and UT, UO for O and UO.
constexpr State as_unknown(State s) { return force2(s) == State::O ? State::UO : State::UT; }

inline States force2(std::span<const State> states) {
  States out;
  for (const State s : states) out.push_back(force2(s));
  return out;
}

/// The state of a uniform map; none if states differ.  Domain: every sequence; an empty one has none.
inline std::optional<State> uniform(std::span<const State> states) {
  if (states.empty()) return std::nullopt;
  for (const State s : states)
    if (s != states.front()) return std::nullopt;
  return states.front();
}

// ---- Formats and packing

/// Source: VkOpacityMicromapFormatKHR.
enum class Format : std::uint16_t { two_state = 1, four_state = 2 };

/// The bits b of one state.
constexpr unsigned bits(Format f) { return f == Format::two_state ? 1 : 2; }

/// Whether the format has a code for the state.
constexpr bool holds(Format f, State s) { return f == Format::four_state || !unknown(s); }

/// The number of micro-triangles, 4^n.  Domain: n in 0..31.
constexpr std::uint64_t micro_triangles(Level n) { return std::uint64_t{1} << (2 * n); }

/// The bytes of a packed map, ceil(count b / 8).  Domain: count below 2^62.
constexpr std::uint64_t packed_bytes(std::uint64_t count, Format f) { return (count * bits(f) + 7) / 8; }

/// The packed bytes of states.  The state of micro-triangle i is in bits i b .. i b + b-1, counted from the least
/// significant bit of byte 0; the bits after the last state are zero.
/// Domain: states that the format holds, else std::invalid_argument.
/// Source: VkAccelerationStructureGeometryMicromapDataKHR; EXT_mesh_opacity_micromap, "Microtriangle Data".
inline Bytes pack(std::span<const State> states, Format f) {
  Bytes bytes(packed_bytes(states.size(), f), 0);
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!holds(f, states[i])) throw std::invalid_argument("micromap::pack: an unknown state in 2-state");
    for (unsigned j = 0; j < bits(f); ++j) {
      const std::size_t place = i * bits(f) + j;
      const unsigned bit = code(states[i]) >> j & 1;
      bytes[place / 8] = static_cast<std::uint8_t>(bytes[place / 8] | bit << place % 8);
    }
  }
  return bytes;
}

/// The first `count` states of packed bytes; whatever follows them is ignored.
/// Domain: at least packed_bytes(count, f) bytes, else std::invalid_argument.
inline States unpack(std::span<const std::uint8_t> bytes, Format f, std::uint64_t count) {
  if (bytes.size() < packed_bytes(count, f)) throw std::invalid_argument("micromap::unpack: too few bytes");
  States states;
  for (std::uint64_t i = 0; i < count; ++i) {
    unsigned value = 0;
    for (unsigned j = 0; j < bits(f); ++j) {
      const std::uint64_t place = i * bits(f) + j;
      value |= (bytes[place / 8] >> place % 8 & 1u) << j;
    }
    states.push_back(static_cast<State>(value));
  }
  return states;
}

// ---- Special indices

/// The encoding of an index buffer's indices.  Vulkan and DirectX have the unsigned ones only, glTF all five.
enum class Encoding : std::uint8_t { u8, u16, u32, i16, i32 };
inline constexpr Encoding encodings[] = {Encoding::u8, Encoding::u16, Encoding::u32, Encoding::i16,
                                         Encoding::i32};

constexpr unsigned width(Encoding e) {
  return e == Encoding::u8 ? 8 : e == Encoding::u16 || e == Encoding::i16 ? 16 : 32;
}
constexpr bool is_signed(Encoding e) { return e == Encoding::i16 || e == Encoding::i32; }

/// The special index of a state: -1 T, -2 O, -3 UT, -4 UO.  Source: VkOpacityMicromapSpecialIndexKHR.
constexpr std::int32_t special_index(State s) { return -1 - static_cast<std::int32_t>(code(s)); }

/// The number of plain indices: 2^w - 4 for an unsigned encoding of w bits, as the last four codes are special; 2^(w-1)
/// for a signed one.
constexpr std::uint64_t index_limit(Encoding e) {
  return is_signed(e) ? std::uint64_t{1} << (width(e) - 1) : (std::uint64_t{1} << width(e)) - 4;
}

/// The meaning of a code: a state for the whole triangle, a plain index, or neither: a signed code below -4.
struct Meaning {
  enum class Kind : std::uint8_t { index, special, unknown } kind;
  std::uint32_t index = 0;  ///< for an index
  State state = State::T;   ///< for a special index
  friend constexpr bool operator==(const Meaning&, const Meaning&) = default;
};

/// The code of a special index: special_index(s) in two's complement of the width.
constexpr std::uint32_t special_code(State s, Encoding e) {
  const std::uint64_t all = (std::uint64_t{1} << width(e)) - 1;
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(special_index(s)) & all);
}

/// The meaning of a code.  Domain: code < 2^width.  Source: VkAccelerationStructureTrianglesOpacityMicromapKHR: "the
/// unsigned cast of" a special index; EXT_mesh_opacity_micromap, "Accessor Requirements", for signed codes.
constexpr Meaning meaning(std::uint32_t code, Encoding e) {
  for (const State s : {State::T, State::O, State::UT, State::UO})
    if (code == special_code(s, e)) return {Meaning::Kind::special, 0, s};
  if (code >= index_limit(e)) return {Meaning::Kind::unknown};
  return {Meaning::Kind::index, code};
}

/// The code of element t of an index buffer, little-endian, elements `stride` bytes apart.
/// Domain: t stride + width/8 <= bytes.
inline std::uint32_t code_at(std::span<const std::uint8_t> bytes, Encoding e, std::uint64_t stride,
                             std::uint64_t t) {
  std::uint32_t value = 0;
  for (unsigned j = 0; j < width(e) / 8; ++j)
    value |= static_cast<std::uint32_t>(bytes[t * stride + j]) << 8 * j;
  return value;
}

}  // namespace mmverify::spec::micromap
