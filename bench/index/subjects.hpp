// The index functions that are measured, each as the loop that it would be in a program.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "bench/number_type.hpp"
#include "impl/common/binary16.hpp"
#include "spec/fixed.hpp"
#include "spec/index/index.hpp"
#include "spec/rational.hpp"

namespace mmverify::bench {

/// out[k] = index of (u[k], v[k]).  The spans have one length.
template <class Q>
using IndexLoop = void (*)(std::span<const Q> u, std::span<const Q> v, spec::Level n,
                           std::span<std::uint32_t> out);

/// The micro-triangle that a subject takes for an index of its order.
using Triangle = spec::index::Corners (*)(std::uint32_t index, spec::Level n);

enum class Order : std::uint8_t { curve, rows };

template <class Q>
struct IndexSubject {
  std::string_view name;
  Order order;
  spec::Level max_level;
  IndexLoop<Q> index;
  Triangle triangle;
  /// The timed loop: `index`, except for a subject whose way from index to triangle belongs to it.
  IndexLoop<Q> timed;
};

/// The specification's triangles in an order.
Triangle exact_triangle(Order order);

/// The subjects that receive numbers of type Q.  Q: Binary16, float, double, Fixed64, Rational.
template <class Q>
std::vector<IndexSubject<Q>> index_subjects();

/// The number type to which points are rounded before a subject over Q receives them.  Rationals take
/// binary32's points.
template <class Q>
inline constexpr NumberType received_by = binary32;
template <>
inline constexpr NumberType received_by<impl::Binary16> = binary16;
template <>
inline constexpr NumberType received_by<double> = binary64;
template <>
inline constexpr NumberType received_by<spec::Fixed64> = fixed64;

/// x as a Q.  Domain: x representable in received_by<Q>.
template <class Q>
Q received(double x);

/// Whether a subject over Q takes microseconds an index, and so gets a small part of the samples.
template <class Q>
inline constexpr bool slow = std::same_as<Q, spec::Rational>;

/// The name of Q in tables.
template <class Q>
inline constexpr std::string_view number_name = received_by<Q>.name;
template <>
inline constexpr std::string_view number_name<spec::Rational> = "rational";

}  // namespace mmverify::bench
