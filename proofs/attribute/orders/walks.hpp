// The orders by walking them: counted, in the place of closed forms.
#pragma once

#include <memory>
#include <vector>

#include "proofs/attribute/subject.hpp"

namespace mmverify::proofs::attribute {

/// The index of each vertex of a level in the three orders, as a walk meets them:
///   W-minor   row after row from the w-corner, each from the edge w-u on
///   U-major   column after column from the edge w-v, each from v = 0 on
///   Bird      the corners w, u, v; then, level by level, along the curve of the level before, the middles of the edges
///             w-v, u-v and w-u of each micro-triangle that stands upright
/// Source: Color and Attribute Micromaps, 3.1.  Domain: n in 0..13, as a table is made of Bird.
class VertexWalks {
 public:
  explicit VertexWalks(Level n);
  std::uint32_t index(VertexOrder order, const Vertex& at) const;

 private:
  std::vector<std::uint32_t> rows_, columns_;  ///< number of the first vertex of each
  std::vector<std::uint32_t> bird_;            ///< by number in U-major
};

/// That of a level, made once.
std::shared_ptr<const VertexWalks> vertex_walks(Level n);

}  // namespace mmverify::proofs::attribute
