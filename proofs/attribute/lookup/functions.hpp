// The functions of a subject of topic attribute for lookups: a point's micro-triangle, triplet and weights, and
// values between vertices.
#pragma once

#include "proofs/attribute/orders/functions.hpp"
#include "proofs/points/point.hpp"
#include "spec/attribute/lookup.hpp"

namespace mmverify::proofs::attribute {

using points::GridPoint;
using points::RationalPoint;
using spec::Fixed64;
using spec::attribute::Ties;

/// The ways of remapping that the paper names.
enum class Remap : std::uint32_t { pattern, two, cramer };
inline constexpr std::array remaps{Remap::pattern, Remap::two, Remap::cramer};

using FixedWeights = spec::attribute::Weights<Fixed64>;
using FloatWeights = spec::attribute::Weights<float>;
using RationalWeights = spec::attribute::Weights<spec::Rational>;

/// Points of the grid k / (4N), exact in binary32 as well.
using Points = std::span<const GridPoint>;
/// Points of binary32 numbers, u and v in arrays of their own.
struct FloatPoints {
  std::span<const float> u, v;
};

/// Batches: answer k is that of point k.  Domain: level n in 0..16, points of the closed triangle.
struct Lookup {
  std::function<void(VertexOrder, Level n, Points, std::span<Triplet>)> triplet = {};
  std::function<void(Level n, Points, std::span<FixedWeights>)> weights = {};
  /// The micro-triangle that holds a point, by either tie rule.
  std::function<void(Ties, Level n, Points, std::span<MicroTriangle>)> holder = {};
  /// The exact weights of any point on any micro-triangle.
  std::function<RationalWeights(Remap, Level n, const MicroTriangle&, const RationalPoint&)> remap = {};

  std::function<void(VertexOrder, Level n, FloatPoints, std::span<Triplet>)> triplet_of_floats = {};
  std::function<void(Level n, FloatPoints, std::span<FloatWeights>)> weights_of_floats = {};
  /// RGBA8 values of a vertex map in an order, r in the low byte.
  std::function<void(VertexOrder, Level n, std::span<const std::uint32_t> map, FloatPoints,
                     std::span<std::uint32_t>)>
      rgba8 = {};
};

}  // namespace mmverify::proofs::attribute
