// The functions of a subject of topic attribute for edge decimation.
#pragma once

#include <span>

#include "proofs/engine/law.hpp"
#include "spec/attribute/decimation.hpp"
#include "spec/fixed.hpp"

namespace mmverify::proofs::attribute {

using spec::attribute::Corners;
using spec::attribute::EdgeFlags;
using spec::attribute::Vertex;
/// A point with coordinates k / (4N) of any level.
using DyadicPoint = spec::Point<spec::Fixed64>;

/// Vertices and the weights of their values; at dyadic points the weights are exact in binary64.
struct WeightedVertices {
  Corners corners;
  std::array<double, 3> weights;
};

/// Domain: level n in 0..16, flags below 8, vertices of that level.  Batches: answer k is that of element k.
struct Decimation {
  /// The vertex that each value is read from.
  std::function<void(Level n, EdgeFlags flags, std::span<const Vertex>, std::span<Vertex>)> snapped = {};
  /// The two vertices whose mean each value is.
  std::function<void(Level n, EdgeFlags flags, std::span<const Vertex>, std::span<std::array<Vertex, 2>>)>
      averaged = {};
  /// The mean of the two values as a code.
  std::function<std::uint8_t(std::uint8_t, std::uint8_t)> mean = {};
  // The live micro-triangle at a point once vertices have snapped, with the weights there.
  std::function<WeightedVertices(Level n, EdgeFlags flags, const DyadicPoint&)> place = {};
  std::function<WeightedVertices(Level n, EdgeFlags flags, float u, float v)> place_f32 = {};
};

}  // namespace mmverify::proofs::attribute
