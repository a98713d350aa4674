// Subjects that run a specification algorithm in rounded arithmetic: the same text, another number type.
#pragma once

#include <cmath>

#include "impl/common/binary16.hpp"
#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// The name of a number type, and the conversion of an exact value, rounded once to nearest.
template <class F>
struct Rounding;

template <>
struct Rounding<float> {
  static constexpr Arithmetic arithmetic = Arithmetic::binary32;
  static float from(double x) { return static_cast<float>(x); }
};
template <>
struct Rounding<double> {
  static constexpr Arithmetic arithmetic = Arithmetic::binary64;
  static double from(double x) { return x; }
};
template <>
struct Rounding<impl::Binary16> {
  static constexpr Arithmetic arithmetic = Arithmetic::binary16;
  static impl::Binary16 from(double x) { return impl::Binary16(x); }
};

/// The grid coordinate as a double: exact, since Fixed64 points of the triangle have at most 31 bits.
inline double as_double(const Fixed64& q) {
  return std::ldexp(static_cast<double>(q.raw()), -static_cast<int>(Fixed64::fraction_bits));
}

template <class F>
Fixed64 rounded(const Fixed64& q) {
  const auto x = static_cast<double>(static_cast<float>(Rounding<F>::from(as_double(q))));
  return Fixed64::from_raw(
      static_cast<std::int64_t>(std::ldexp(x, static_cast<int>(Fixed64::fraction_bits))));
}

template <class F>
Rational rounded(const Rational& q) {
  if constexpr (std::is_same_v<F, double>)
    return rational(nearest(q));
  else
    return rational(static_cast<float>(Rounding<F>::from(nearest(q))));
}

template <class Algorithm, class F>
Functions roundedly(Level max_level = 16) {
  constexpr auto at = [](Level n, double u, double v) -> std::uint32_t {
    return Algorithm::at(spec::Point<F>{Rounding<F>::from(u), Rounding<F>::from(v)}, n);
  };
  Functions f;
  f.arithmetic = Rounding<F>::arithmetic;
  f.max_level = max_level;
  if constexpr (std::is_same_v<F, impl::Binary16>) {
    f.receive = [](std::span<GridPoint> points) {
      for (GridPoint& p : points) p = {rounded<F>(p.u), rounded<F>(p.v)};
    };
    f.receive_floats = [](std::span<float> u, std::span<float> v) {
      for (std::size_t t = 0; t < u.size(); ++t) {
        u[t] = static_cast<float>(impl::Binary16(u[t]));
        v[t] = static_cast<float>(impl::Binary16(v[t]));
      }
    };
  }
  f.receive_at = [](const RationalPoint& p) -> RationalPoint { return {rounded<F>(p.u), rounded<F>(p.v)}; };
  f.index = [at](Level n, Batch batch, std::span<std::uint32_t> out) {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = at(n, as_double(batch.points[t].u), as_double(batch.points[t].v));
  };
  f.index_floats = [at](Level n, FloatBatch batch, std::span<std::uint32_t> out) {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = at(n, static_cast<double>(batch.u[t]), static_cast<double>(batch.v[t]));
  };
  f.index_doubles = [at](Level n, DoubleBatch batch, std::span<std::uint32_t> out) {
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = at(n, batch.u[t], batch.v[t]);
  };
  f.index_at = [at](Level n, const RationalPoint& p) { return at(n, nearest(p.u), nearest(p.v)); };
  return f;
}

}  // namespace mmverify::proofs::index
