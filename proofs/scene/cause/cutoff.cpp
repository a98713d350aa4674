#include "proofs/scene/cause/cutoff.hpp"

#include <functional>

namespace mmverify::proofs::scene {
namespace {

using impl::micromap::State;

constexpr unsigned steps = 1u << 16;

bool is_o(State s) { return s == State::O; }
bool is_t(State s) { return s == State::T; }
bool is_unknown(State s) { return s == State::UT || s == State::UO; }

class CutoffSearch {
 public:
  CutoffSearch(const Judged& judged, const std::vector<std::size_t>& triangles,
               const std::vector<States>& stored)
      : judged_(judged), triangles_(triangles), stored_(stored), inputs_(inputs_of(judged)) {}

  /// The greatest step without such a micro-triangle, if 0 has none.  Domain: their number grows with the cutoff.
  std::optional<unsigned> greatest(bool (*has)(State), bool (*clashes)(State)) const {
    if (any(has, clashes, 0)) return {};
    unsigned low = 0, high = steps + 1;
    while (high - low > 1) {
      const unsigned middle = (low + high) / 2;
      (any(has, clashes, middle) ? high : low) = middle;
    }
    return low;
  }
  /// The least step without one, if the last has none.  Domain: their number falls as the cutoff grows.
  std::optional<unsigned> least(bool (*has)(State), bool (*clashes)(State)) const {
    if (any(has, clashes, steps + 1)) return {};
    unsigned low = 0, high = steps + 1;
    if (!any(has, clashes, 0)) return 0;
    while (high - low > 1) {
      const unsigned middle = (low + high) / 2;
      (any(has, clashes, middle) ? low : high) = middle;
    }
    return high;
  }

 private:
  bool any(bool (*has)(State), bool (*clashes)(State), unsigned step) const {
    const std::vector<States> right =
        expected(judged_, with_cutoff(inputs_, static_cast<double>(step) / steps), triangles_);
    for (std::size_t t = 0; t < right.size(); ++t)
      for (std::size_t k = 0; k < right[t].size(); ++k)
        if (has(stored_[t][k]) && clashes(right[t][k])) return true;
    return false;
  }

  const Judged& judged_;
  const std::vector<std::size_t>& triangles_;
  const std::vector<States>& stored_;
  const Inputs inputs_;
};

std::optional<CutoffRange> range_of(std::optional<unsigned> least, std::optional<unsigned> greatest) {
  if (!least || !greatest || *least > *greatest) return {};
  return CutoffRange{static_cast<double>(*least) / steps, static_cast<double>(*greatest) / steps};
}

}  // namespace

Inputs with_cutoff(Inputs inputs, double cutoff) {
  for (auto& surface : inputs.surfaces) {
    surface.mode = mmverify::scene::AlphaMode::mask;
    surface.cutoff = static_cast<float>(cutoff);
  }
  return inputs;
}

std::optional<CutoffRange> cutoffs(const Judged& judged, const std::vector<std::size_t>& triangles,
                                   const std::vector<States>& stored) {
  const CutoffSearch search(judged, triangles, stored);
  const auto not_o = [](State s) { return s != State::O; };
  const auto not_t = [](State s) { return s != State::T; };
  const std::optional<unsigned> o = search.greatest(is_o, not_o), t = search.least(is_t, not_t);
  const std::optional<CutoffRange> conservative = range_of(t, o);
  if (!conservative) return {};
  const std::optional<unsigned> above = search.least(is_unknown, is_o),
                                below = search.greatest(is_unknown, is_t);
  if (!above || !below) return conservative;
  const std::optional<CutoffRange> tight = range_of(std::max(*t, *above), std::min(*o, *below));
  return tight ? tight : conservative;
}

}  // namespace mmverify::proofs::scene
