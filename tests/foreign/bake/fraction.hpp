// Fractions, where a line meets the lines of a grid.
#pragma once

namespace mmverify::tests::foreign::bake {

template <class E>
struct Fraction {
  E n, d;  // d > 0
};
template <class E>
bool less(const Fraction<E>& a, const Fraction<E>& b) {
  return a.n * b.d < b.n * a.d;
}

template <class E>
void clip(const E& at, const E& by, bool has_low, const E& low, bool has_high, const E& high, Fraction<E>& t0,
          Fraction<E>& t1) {
  if (by == 0) {
    if ((has_low && at < low) || (has_high && at > high)) t1 = {E(-1), E(1)};
    return;
  }
  const bool up = by > 0;
  const auto where = [&](const E& line) {
    return up ? Fraction<E>{line - at, by} : Fraction<E>{at - line, -by};
  };
  if (up ? has_low : has_high) {
    const auto t = where(up ? low : high);
    if (less(t0, t)) t0 = t;
  }
  if (up ? has_high : has_low) {
    const auto t = where(up ? high : low);
    if (less(t, t1)) t1 = t;
  }
}

}  // namespace mmverify::tests::foreign::bake
