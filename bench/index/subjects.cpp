#include "bench/index/subjects.hpp"

#include <cmath>
#include <cstddef>

#include "bench/exact.hpp"
#include "impl/index/index.hpp"

namespace mmverify::bench {
namespace {

using impl::Binary16;
using spec::Fixed64;
using spec::Level;
using spec::Point;
using spec::Rational;
using spec::index::Corners;

// Never inlined into the harness, so that each compiles as the loop it would be in a program.

template <class Q>
[[gnu::noinline]] void reference(std::span<const Q> u, std::span<const Q> v, Level n,
                                 std::span<std::uint32_t> out) {
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = spec::index::reference(Point<Q>{u[k], v[k]}, n);
}

template <class Q>
[[gnu::noinline]] void step(std::span<const Q> u, std::span<const Q> v, Level n,
                            std::span<std::uint32_t> out) {
  for (std::size_t k = 0; k < out.size(); ++k)
    out[k] = spec::index::step<spec::index::Reading::printed>(Point<Q>{u[k], v[k]}, n);
}

[[gnu::noinline]] void impl_scalar(std::span<const float> u, std::span<const float> v, Level n,
                                   std::span<std::uint32_t> out) {
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = impl::index::from_barycentrics(u[k], v[k], n);
}

void impl_batched(std::span<const float> u, std::span<const float> v, Level n, std::span<std::uint32_t> out) {
  impl::index::from_barycentrics(u, v, n, out);
}

[[gnu::noinline]] void impl_rows(std::span<const float> u, std::span<const float> v, Level n,
                                 std::span<std::uint32_t> out) {
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = impl::index::w_minor(u[k], v[k], n);
}

[[gnu::noinline]] void rows(std::span<const float> u, std::span<const float> v, Level n,
                            std::span<std::uint32_t> out) {
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = spec::index::w_minor(Point<float>{u[k], v[k]}, n);
}

/// The triangle of a row-order index with the row from a binary32 root: Color and Attribute Micromaps, figure
/// 4, wminor_uv2vertex_index.  Words wrap if the root rounds up.
Corners rooted_triangle(std::uint32_t index, Level) {
  const auto row = static_cast<std::uint32_t>(std::sqrt(static_cast<float>(index)));
  const std::uint32_t col = index - row * row, c = col / 2, odd = col % 2, i = row - c;
  return {spec::index::Vertex{i, c}, {i + 1 - odd, c + odd}, {i - odd, c + 1}};
}

/// The whole of figure 4.  Only the sum of the three micro-vertex numbers r(r+1)/2 + c is stored, to write
/// one word a point; it needs the whole computation.
[[gnu::noinline]] void rows_to_vertices(std::span<const float> u, std::span<const float> v, Level n,
                                        std::span<std::uint32_t> out) {
  for (std::size_t k = 0; k < out.size(); ++k) {
    const Corners corners = rooted_triangle(spec::index::w_minor(Point<float>{u[k], v[k]}, n), n);
    std::uint32_t sum = 0;
    for (const auto& [i, j] : corners) sum += (i + j) * (i + j + 1) / 2 + j;
    out[k] = sum;
  }
}

Corners curve_triangle(std::uint32_t index, Level n) { return spec::index::corners(index, n); }
Corners row_triangle(std::uint32_t index, Level) { return spec::index::w_minor_corners(index); }

template <class Q>
std::vector<IndexSubject<Q>> both(std::string_view reference_name, std::string_view step_name,
                                  Level max_level = 16) {
  return {{reference_name, Order::curve, max_level, reference<Q>, curve_triangle, reference<Q>},
          {step_name, Order::curve, max_level, step<Q>, curve_triangle, step<Q>}};
}

}  // namespace

Triangle exact_triangle(Order order) { return order == Order::curve ? curve_triangle : row_triangle; }

template <>
std::vector<IndexSubject<Binary16>> index_subjects<Binary16>() {
  return both<Binary16>("reference-f16", "step-f16", 15);  // N = 2^16 is infinite in binary16
}
template <>
std::vector<IndexSubject<float>> index_subjects<float>() {
  std::vector<IndexSubject<float>> all = both<float>("reference-f32", "step-f32");
  all.push_back({"impl-scalar", Order::curve, 16, impl_scalar, curve_triangle, impl_scalar});
  all.push_back({"impl-batched", Order::curve, 16, impl_batched, curve_triangle, impl_batched});
  all.push_back({"w-minor-f32", Order::rows, 16, rows, row_triangle, rows});
  all.push_back({"w-minor-f32-sqrt", Order::rows, 16, rows, rooted_triangle, rows_to_vertices});
  all.push_back({"w-minor-impl", Order::rows, 16, impl_rows, row_triangle, impl_rows});
  return all;
}
template <>
std::vector<IndexSubject<double>> index_subjects<double>() {
  return both<double>("reference-f64", "step-f64");
}
template <>
std::vector<IndexSubject<Fixed64>> index_subjects<Fixed64>() {
  return both<Fixed64>("reference-fixed", "step-fixed");
}
template <>
std::vector<IndexSubject<Rational>> index_subjects<Rational>() {
  return both<Rational>("reference-rational", "step-rational");
}

template <>
Binary16 received<Binary16>(double x) {
  return Binary16(x);
}
template <>
float received<float>(double x) {
  return static_cast<float>(x);
}
template <>
double received<double>(double x) {
  return x;
}
template <>
Fixed64 received<Fixed64>(double x) {
  return Fixed64::from_raw(
      static_cast<std::int64_t>(std::ldexp(x, static_cast<int>(Fixed64::fraction_bits))));
}
template <>
Rational received<Rational>(double x) {
  return exact_rational(x);
}

}  // namespace mmverify::bench
