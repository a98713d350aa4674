// What a subject of topic attribute may have of edge decimation.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>

#include "proofs/engine/law.hpp"
#include "spec/attribute/decimation.hpp"
#include "spec/fixed.hpp"

namespace mmverify::proofs::attribute {

using spec::attribute::Corners;
using spec::attribute::EdgeFlags;
using spec::attribute::Vertex;
/// Coordinates k / (4N) of any level, as they are.
using DyadicPoint = spec::Point<spec::Fixed64>;

/// Vertices, and the weights of their values; on dyadic points these are numbers of binary64.
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
  /// That mean in a code.
  std::function<std::uint8_t(std::uint8_t, std::uint8_t)> mean = {};
  // What is interpolated at a point, once vertices have snapped.
  std::function<WeightedVertices(Level n, EdgeFlags flags, const DyadicPoint&)> place = {};
  std::function<WeightedVertices(Level n, EdgeFlags flags, float u, float v)> place_f32 = {};
};

}  // namespace mmverify::proofs::attribute
