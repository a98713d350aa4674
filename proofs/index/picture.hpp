// A counterexample as a picture.
#pragma once

#include "proofs/index/points.hpp"

namespace mmverify::proofs::index {

/// Which of the two orders an index belongs to.
enum class Order { curve, rows };

/// An SVG: the grid, the point, the micro-triangle expected and the one returned, with their indices.
/// A grid finer than can be drawn is cut to the neighbourhood of the point.
std::string picture(Level n, const RationalPoint& p, std::uint32_t expected, std::uint32_t got, Order order);

}  // namespace mmverify::proofs::index
