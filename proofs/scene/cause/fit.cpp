#include "proofs/scene/cause/fit.hpp"

namespace mmverify::proofs::scene {

using impl::micromap::State;

States states_of(const mmverify::scene::BakedTriangle& map) {
  States states(impl::micromap::micro_triangles(map.level));
  if (map.uniform)
    states.assign(states.size(), *map.uniform);
  else
    impl::micromap::unpack(map.map, map.format, states);
  return states;
}

Fit& Fit::operator+=(const Fit& more) {
  wrong += more.wrong;
  needless += more.needless;
  side += more.side;
  equal += more.equal;
  same += more.same;
  return *this;
}

Fit fit(std::span<const State> stored, std::span<const State> expected) {
  Fit all;
  for (std::size_t k = 0; k < stored.size(); ++k) {
    const bool known = stored[k] == State::T || stored[k] == State::O;
    const bool known_there = expected[k] == State::T || expected[k] == State::O;
    if (known)
      ++(stored[k] == expected[k] ? all.equal : all.wrong);
    else if (known_there)
      ++all.needless;
    else
      ++(stored[k] == expected[k] ? all.same : all.side);
  }
  return all;
}

}  // namespace mmverify::proofs::scene
