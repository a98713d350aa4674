// A specification algorithm in rounded arithmetic, as a subject: the same text, another number type.
#pragma once

#include <cmath>

#include "impl/common/binary16.hpp"
#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// What a number type is called and how an exact value becomes one, rounded once to nearest.
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

/// The grid coordinate as a double: exact, Fixed64 points of the triangle have at most 31 bits.
inline double as_double(const Fixed64& q) {
  return std::ldexp(static_cast<double>(q.raw()), -static_cast<int>(Fixed64::fraction_bits));
}

template <class Algorithm, class F>
class RoundedSubject : public IndexSubject {
 public:
  RoundedSubject(std::string name, std::string about, Level max_level = 16)
      : IndexSubject(std::move(name), std::move(about), Rounding<F>::arithmetic, max_level) {}

  bool has(Entry e) const override { return e == Entry::index; }

  void receive(std::span<GridPoint> points) const override {
    if constexpr (std::is_same_v<F, impl::Binary16>)
      for (GridPoint& p : points) p = {rounded(p.u), rounded(p.v)};
  }
  void receive(std::span<float> u, std::span<float> v) const override {
    if constexpr (std::is_same_v<F, impl::Binary16>)
      for (std::size_t t = 0; t < u.size(); ++t) {
        u[t] = static_cast<float>(impl::Binary16(u[t]));
        v[t] = static_cast<float>(impl::Binary16(v[t]));
      }
  }
  RationalPoint receive(const RationalPoint& p) const override { return {rounded(p.u), rounded(p.v)}; }

  void index(Level n, Batch batch, std::span<std::uint32_t> out) const override {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = at(n, as_double(batch.points[t].u), as_double(batch.points[t].v));
  }
  void index(Level n, FloatBatch batch, std::span<std::uint32_t> out) const override {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = at(n, static_cast<double>(batch.u[t]), static_cast<double>(batch.v[t]));
  }
  void index(Level n, DoubleBatch batch, std::span<std::uint32_t> out) const override {
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = at(n, batch.u[t], batch.v[t]);
  }
  std::uint32_t index(Level n, const RationalPoint& p) const override {
    return at(n, nearest(p.u), nearest(p.v));
  }

 private:
  static std::uint32_t at(Level n, double u, double v) {
    return Algorithm::at(spec::Point<F>{Rounding<F>::from(u), Rounding<F>::from(v)}, n);
  }
  static Fixed64 rounded(const Fixed64& q) {
    const auto x = static_cast<double>(static_cast<float>(Rounding<F>::from(as_double(q))));
    return Fixed64::from_raw(
        static_cast<std::int64_t>(std::ldexp(x, static_cast<int>(Fixed64::fraction_bits))));
  }
  static Rational rounded(const Rational& q) {
    if constexpr (std::is_same_v<F, double>)
      return rational(nearest(q));
    else
      return rational(static_cast<float>(Rounding<F>::from(nearest(q))));
  }
};

}  // namespace mmverify::proofs::index
