// One level up and one level down, and the 1-bit modes that are not 2-state.
#pragma once

#include "spec/micromap/micromap.hpp"

namespace mmverify::spec::micromap {

/// Copies each state to its four children.  Micro-triangle i of level n has the children 4i .. 4i+3 of level n+1.
inline States up(std::span<const State> states) {
  States out;
  for (const State s : states) out.insert(out.end(), 4, s);
  return out;
}

/// The state of a parent: T for four T, O for four O, else unknown, since T and O are promises.
/// The unknown state is UO if at least two of four are opaque under force-2-state, else UT.
/// So force-2-state of the parent is the children's majority, a tie being opaque: a shadow ray meets the same area, and
/// foliage does not thin out level by level.
/// It is not the majority of all descendants: majorities do not nest.
constexpr State merged(State a, State b, State c, State d) {
  const State children[] = {a, b, c, d};
  unsigned transparent = 0, opaque = 0, forced_opaque = 0;
  for (const State s : children) {
    transparent += s == State::T;
    opaque += s == State::O;
    forced_opaque += force2(s) == State::O;
  }
  if (transparent == 4) return State::T;
  if (opaque == 4) return State::O;
  return forced_opaque >= 2 ? State::UO : State::UT;
}

/// The 4-state map one level down.  It is conservative: a T or O of it was T or O in all four children.
/// Domain: a map of level 1 or more, else std::invalid_argument.
inline States down(std::span<const State> states) {
  if (states.size() < 4 || states.size() % 4 != 0)
    throw std::invalid_argument("micromap::down: no level below");
  States out;
  for (std::size_t i = 0; i < states.size(); i += 4)
    out.push_back(merged(states[i], states[i + 1], states[i + 2], states[i + 3]));
  return out;
}

/// The 2-state map one level down: force-2-state of down().  It is not conservative, and nothing in 2-state can be: if
/// children differ, T or O is wrong for some of them, and there is no third code.  Callers who need every promise kept
/// must take the 4-state map of down().
/// Domain: T and O only; a map of level 1 or more, else std::invalid_argument.
inline States down_two_state(std::span<const State> states) { return force2(down(states)); }

// ---- Further 1-bit modes

/// The two states that one bit tells apart.  The paper's formats have T/O; T/C keeps the states that let rays pass, O/C
/// the ones that stop them.  C is unknown.
enum class Mode : std::uint8_t { T_O, T_C, O_C };

/// The bit of a state.  T/O: force-2-state; T/C: 0 for T; O/C: 0 for O.
constexpr bool bit_of(State s, Mode mode) {
  if (mode == Mode::T_O) return force2(s) == State::O;
  return mode == Mode::T_C ? s != State::T : s != State::O;
}

/// The state of a bit.  C is UO in T/C and UT in O/C: the other promise than the mode keeps, so that force-2-state
/// still tells both bits apart.
constexpr State from_bit(bool bit, Mode mode) {
  if (mode == Mode::T_O) return bit ? State::O : State::T;
  if (mode == Mode::T_C) return bit ? State::UO : State::T;
  return bit ? State::UT : State::O;
}

/// A map through a mode and back.  T/C and O/C are allowed lossy substitutions (spec/micromap/lossy.hpp), T/O
/// is not one.
inline States through(std::span<const State> states, Mode mode) {
  States out;
  for (const State s : states) out.push_back(from_bit(bit_of(s, mode), mode));
  return out;
}

}  // namespace mmverify::spec::micromap
