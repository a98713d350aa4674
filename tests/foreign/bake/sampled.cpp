// Micro-vertices and centroids in a mip, and the sign at a centroid.
#include "tests/foreign/bake/sampled.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "tests/foreign/bake/placed.hpp"

namespace mmverify::tests::foreign::bake {

template <class T>
Sampled<T>::Sampled(const mmverify_bake_case_t& c, const Mip& mip, unsigned number, bool nearest)
    : case_(c), mip_(mip), number_(number), nearest_(nearest) {
  const Placed p = place(c, mip.width, mip.height, number, nearest);
  for (std::size_t a = 0; a < 2; ++a) {
    start_[a] = to<T>(p.start[a]);
    along_u_[a] = to<T>(p.along_u[a]);
    along_v_[a] = to<T>(p.along_v[a]);
    margin_[a] = to<T>(p.margin[a]);
    origin_[a] = p.origin[a];
  }
  unit_ = to<T>(p.unit);
  unit_real_ = real(unit_);
  place_bits_ = p.size_bits;
  wrap_u_ = c.wrap_u;
  wrap_v_ = c.wrap_v;
  if (has(wrap_v_is_u) || (has(wrap_v_is_u_when_tall) && mip.height > mip.width && mip.height > 8) ||
      (has(mips_wrap_u) && number > 0))
    wrap_v_ = wrap_u_;
  const Range x = distinct(mip.width, wrap_u_, nearest), y = distinct(mip.height, wrap_v_, nearest);
  columns_ = local(x, 0);
  rows_ = local(y, 1);
  along_all_ = period(mip.width, wrap_u_);
  down_all_ = period(mip.height, wrap_v_);
}

template <class T>
int Sampled<T>::centroid_sign(const Node& node, const Field& f) const {
  Point<T> sum{T(0), T(0)};
  T unit = unit_ * 3;
  if (has(centroid_is_vertex)) {
    const Point<T> p = vertex(node.corners[0]);
    sum = {p.x * 3, p.y * 3};
  } else {
    for (const auto& k : node.corners) {
      const Point<T> p = vertex(k);
      sum.x += p.x;
      sum.y += p.y;
    }
  }
  if (has(centroid_in_float) || has(centroid_in_double)) {
    // rounded in texture coordinates, as a program that has them in such numbers would
    const T scale = T(1 << 20);
    for (int a = 0; a < 2; ++a) {
      T& s = a == 0 ? sum.x : sum.y;
      const double size = static_cast<double>(a == 0 ? mip_.width : mip_.height);
      const double half = nearest_ ? 0 : 0.5, base = static_cast<double>(origin_[a]);
      double x = (real(s) / (3 * unit_real_) + base + half) / size;
      if (has(centroid_in_float)) x = static_cast<double>(static_cast<float>(x));
      x = x * size - half - base;
      (void)scale;
      s = to<T>(rounded(std::ldexp(x, 40), unit_ * 3));
    }
  }
  const Index i = index_of(floor_div(sum.x, unit)), j = index_of(floor_div(sum.y, unit));
  if (nearest_ || has(centroid_nearest) || (has(two_state_nearest) && case_.format == MMVERIFY_2_STATE)) {
    if (nearest_) return sign_of(f, texel(i, j));
    const Index ii = index_of(floor_div(T(2 * sum.x + unit), T(2 * unit))),
                jj = index_of(floor_div(T(2 * sum.y + unit), T(2 * unit)));
    return sign_of(f, texel(ii, jj));
  }
  const T x = sum.x - unit * T(i), y = sum.y - unit * T(j);
  // first in binary64: a mean of numbers within -1..1
  const double p = real(x) / real(unit), q = real(y) / real(unit);
  const std::size_t k[4] = {texel(i, j), texel(i + 1, j), texel(i, j + 1), texel(i + 1, j + 1)};
  const auto& g = f.approximate;
  const double top = g[k[0]] + p * (g[k[1]] - g[k[0]]), bottom = g[k[2]] + p * (g[k[3]] - g[k[2]]);
  const double mean = top + q * (bottom - top);
  if (std::abs(mean) > 0x1p-44) return mean < 0 ? -1 : 1;
  const auto exactly = [&]<class E>() {
    const E e = to<E>(unit), u = to<E>(x), v = to<E>(y);
    return sign((e - v) * ((e - u) * f.value<E>(k[0]) + u * f.value<E>(k[1])) +
                v * ((e - u) * f.value<E>(k[2]) + u * f.value<E>(k[3])));
  };
  if (f.fits && f.size_bits + 2 * bits(to<Big>(unit)) + 4 <= 120) return exactly.template operator()<Wide>();
  return exactly.template operator()<Big>();
}

template <class T>
Big Sampled<T>::rounded(double x, const T& unit) {  // x 2^-40 in units
  const Dyadic d = dyadic(x);
  Big whole = d.mantissa * to<Big>(unit);
  const int e = d.exponent - 40;
  return e >= 0 ? Big(whole << static_cast<unsigned>(e)) : Big(whole >> static_cast<unsigned>(-e));
}

template <class T>
Point<T> Sampled<T>::vertex(const std::array<std::uint32_t, 2>& k) const {
  const T a = T(static_cast<Index>(k[0])), b = T(static_cast<Index>(k[1]));
  Point<T> p{start_[0] + a * along_u_[0] + b * along_v_[0], start_[1] + a * along_u_[1] + b * along_v_[1]};
  if (has(vertices_in_float)) {
    for (int axis = 0; axis < 2; ++axis) {
      T& s = axis == 0 ? p.x : p.y;
      const double size = static_cast<double>(axis == 0 ? mip_.width : mip_.height);
      const double half = nearest_ ? 0 : 0.5, base = static_cast<double>(origin_[axis]);
      double x = (real(s) / unit_real_ + base + half) / size;
      x = static_cast<double>(static_cast<float>(x));
      s = to<T>(rounded(std::ldexp(x * size - half - base, 40), unit_));
    }
  }
  if (has(vertices_in_256ths_always) || (has(vertices_in_256ths) && case_.level >= 6)) {
    const T step = unit_ / 256;
    if (step > 0) p = {floor_div(T(p.x + step / 2), step) * step, floor_div(T(p.y + step / 2), step) * step};
  }
  return p;
}

template <class T>
std::vector<Point<T>> Sampled<T>::polygon_of(const Node& node) const {
  std::vector<Point<T>> all;
  const bool none = margin_[0] == 0 && margin_[1] == 0;
  const bool diamond = has(margin_diamond) || (has(margin_diamond_when_wide) && margin_[0] > unit_);
  for (const auto& k : node.corners) {
    const Point<T> p = vertex(k);
    if (none) {
      all.push_back(p);
    } else if (diamond) {
      all.push_back({p.x - margin_[0], p.y});
      all.push_back({p.x + margin_[0], p.y});
      all.push_back({p.x, p.y - margin_[1]});
      all.push_back({p.x, p.y + margin_[1]});
    } else {
      for (int a = -1; a <= 1; a += 2)
        for (int b = has(margin_one_sided) ? 0 : -1; b <= 1; b += has(margin_one_sided) ? 1 : 2)
          all.push_back({p.x + T(a) * margin_[0], p.y + T(b) * margin_[1]});
    }
  }
  return hull(std::move(all));
}

template Sampled<Wide>::Sampled(const mmverify_bake_case_t&, const Mip&, unsigned, bool);
template Sampled<Big>::Sampled(const mmverify_bake_case_t&, const Mip&, unsigned, bool);
template int Sampled<Wide>::centroid_sign(const Node&, const Field&) const;
template int Sampled<Big>::centroid_sign(const Node&, const Field&) const;
template Point<Wide> Sampled<Wide>::vertex(const std::array<std::uint32_t, 2>&) const;
template Point<Big> Sampled<Big>::vertex(const std::array<std::uint32_t, 2>&) const;
template std::vector<Point<Wide>> Sampled<Wide>::polygon_of(const Node&) const;
template std::vector<Point<Big>> Sampled<Big>::polygon_of(const Node&) const;

}  // namespace mmverify::tests::foreign::bake
