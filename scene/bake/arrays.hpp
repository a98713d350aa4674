// The scene's micromap array, and each primitive's indices into it.
#pragma once

#include <cstdint>
#include <vector>

#include "impl/micromap/append.hpp"
#include "scene/bake/bake.hpp"

namespace mmverify::scene {

/// The indices of one planned primitive: a code a triangle.
struct PrimitiveIndices {
  std::size_t primitive = 0;  ///< number in Scene::primitives
  impl::micromap::Geometry geometry;
};

struct SceneArrays {
  impl::micromap::Array array;
  /// u16 or u32: the narrowest encoding that fits every primitive's codes and is in all specifications.
  impl::micromap::Encoding encoding = impl::micromap::Encoding::u16;
  std::vector<PrimitiveIndices> primitives;  ///< by Plan::primitives
  std::uint64_t special = 0;                 ///< triangles with a special index
  std::uint64_t reordered = 0;               ///< records made by reordering another's micro-triangles
};

/// One record for each distinct map and order of its vertices, in the order of the triangles; equal bytes
/// share a record.  Uniform maps are special indices.
/// Errors: std::length_error for data beyond 2^32 bytes.
SceneArrays arrays(const Plan& plan, const Baked& baked);

}  // namespace mmverify::scene
