// Tables of the hits of rays from a random path through a scene, by every form of its micromaps.
#pragma once

#include <string>

#include "bench/result.hpp"
#include "display/render/scene/path.hpp"

namespace mmverify::bench {

struct PathFigures {
  std::string file;
  std::uint64_t tested = 0, tested_placed = 0;  ///< triangles that get micromaps
  std::uint32_t width = 0, height = 0;
  std::uint64_t seed = 0, threads = 0;
  bool shadows = true;
  unsigned ambient = 0;  ///< rays of ambient occlusion from each hit
  std::string embree;
  const render::Path* path = nullptr;
};

/// The tables of a path.  Domain: a path of at least one camera.
Result path_tables(const PathFigures& figures);

}  // namespace mmverify::bench
