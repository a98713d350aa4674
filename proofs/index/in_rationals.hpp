// A specification algorithm at a rational point, in 63 bits where they hold all numbers on the way.
#pragma once

#include "proofs/index/points.hpp"
#include "proofs/points/narrow.hpp"

namespace mmverify::proofs::index {

/// f(p), in rationals of 63 bits where they hold all numbers on the way, else in those without bounds, by which a law takes
/// five times as long.
template <class F>
auto in_rationals(const RationalPoint& p, F f) {
  return in_first_of<Rational64, Rational>([&]<class Q>() {
    using Whole = typename Q::int_type;
    const auto as = [](const Rational& q) { return Q(Whole(q.numerator()), Whole(q.denominator())); };
    return f(spec::Point<Q>{as(p.u), as(p.v)});
  });
}

}  // namespace mmverify::proofs::index
