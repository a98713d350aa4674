// The maps of many triangles in one call, on the caller's threads.
#pragma once

#include <functional>

#include "impl/bake/triangles.hpp"
#include "impl/micromap/array.hpp"

namespace mmverify::impl::bake {

/// The caller's threads: calls job(k) once for each k below count, from any threads, and returns when all have ended.
/// The jobs throw nothing.
using Parallel = std::function<void(std::size_t count, const std::function<void(std::size_t)>& job)>;

/// Packed 4-state maps; `maps` are views into `bytes`, for array::build().
struct MeshMaps {
  std::vector<std::uint8_t> bytes;
  std::vector<micromap::PackedMap> maps;
  BakeCounts counts;

  MeshMaps() = default;
  MeshMaps(MeshMaps&&) noexcept = default;
  MeshMaps& operator=(MeshMaps&&) noexcept = default;
};

/// Bakes a map for each triangle, as TriangleBaker::bake(); without `parallel` on this thread.  The result is the same
/// for any number of threads.
/// Memory: one block for all maps is allocated before the first job; with several mip levels each job allocates a map.
/// Domain: a level for each triangle.
/// Errors: std::invalid_argument for another number of levels, or of TriangleBaker::bake(), naming the first triangle at
/// fault.
/// Test: impl_bake_engine_test
MeshMaps bake_mesh(const TriangleBaker& baker, std::span<const BaseTriangle> triangles,
                   std::span<const std::uint32_t> levels, const Parallel& parallel = {});

}  // namespace mmverify::impl::bake
