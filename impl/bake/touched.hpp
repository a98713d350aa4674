// The nodes of a base triangle that read changed texels.  Internal to impl/bake.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "impl/bake/triangles.hpp"

namespace mmverify::impl::bake::detail {

/// A node of 4^height micro-triangles, the first of them at `index`.
struct Node {
  std::uint32_t index, height;
};

/// A rectangle of texture coordinates.
struct UvBox {
  double left, right, top, bottom;
};

/// The nodes that `touched` accepts, in order and without overlap, of at most 16 micro-triangles, or of more if all of
/// these are accepted.  The rectangle of a node is that of its corners, without the triangle's movement.
std::vector<Node> touched_nodes(const BaseTriangle& uv, std::uint32_t level,
                                const std::function<bool(const UvBox&)>& touched);

}  // namespace mmverify::impl::bake::detail
