// The claims that laws of baking make about a stored state.
#pragma once

#include "scene/bake/bake.hpp"
#include "spec/bake/bake.hpp"

namespace mmverify::proofs::scene {

/// The 4-state code of a micro-triangle.  Domain: index below 4^level.
inline unsigned state_code(const mmverify::scene::BakedTriangle& t, std::uint32_t index) {
  if (t.uniform) return static_cast<unsigned>(*t.uniform);
  const unsigned b = impl::micromap::bits(t.format);
  return t.map[std::size_t{index} * b / 8] >> (index * b % 8) & ((1u << b) - 1);
}

/// Whether a code is that of a known state, T or O.
constexpr bool is_known(unsigned code) { return code < 2; }

/// A law's claim: the codes that it is about, and the true state that denies them.
struct Claim {
  const char* id;
  const char* says;
  enum About { known, unknown, forced } what;
  const char* states;  ///< the states that it is about, in words

  /// Whether the law is about none of a map's states: of one by bounds only known states are judged.
  bool passes_over(const mmverify::scene::BakedTriangle& t) const { return t.by_bounds && what != known; }
  bool about(unsigned code) const { return what == forced || is_known(code) == (what == known); }
  /// Whether a code agrees with the true state.  `leans`: whether alpha at the centroid is rather opaque.  Domain: a
  /// code that the law is about.
  bool holds(unsigned code, spec::bake::State truly, bool leans) const {
    using spec::bake::State;
    if (what == unknown) return truly == State::C;
    if (what == forced && truly == State::C) return code == (leans ? 1u : 0u);
    return truly == (code == 1 ? State::O : State::T);
  }
  /// The number of micro-triangles of a map that the law is about.
  std::uint64_t count(const mmverify::scene::BakedTriangle& t) const {
    if (passes_over(t)) return 0;
    return (what == unknown ? 0 : t.states[0] + t.states[1]) +
           (what == known ? 0 : t.states[2] + t.states[3]);
  }
};

}  // namespace mmverify::proofs::scene
