// Square opacity maps of pairs.
#pragma once

#include <span>
#include <vector>

#include "impl/vq/vq.hpp"
#include "scene/bake/bake.hpp"
#include "scene/plan/pairs.hpp"

namespace mmverify::scene {

/// The map of N x N regions of a pair, N = 2^level, region (x, y) at x + N y.  A region is two
/// micro-triangles of that level, of one triangle or, on the diagonal, one of each: T if both are T, O if
/// both are O, else C.
///   lower (x, y): the upright one at (x, y) for x + y < N, and the turned one for x + y < N - 1
///   upper (x, y): those at (N-1-x, N-1-y) for the rest
/// Exact, since the closed region is the union of the two.
/// Domain: 4-state maps of the level, in the pair's order of vertices; states.size() = 4^level; level
/// in 1..8; else std::invalid_argument.
void square_map(std::span<const std::uint8_t> lower, std::span<const std::uint8_t> upper, unsigned level,
                std::span<impl::vq::State> states);

/// The maps of all distinct pairs, by Pairs::distinct.
struct SquareMaps {
  std::vector<impl::vq::Map2> vq2;  ///< 16 x 16
  std::vector<impl::vq::Map4> vq4;  ///< 32 x 32
};

/// Bakes the triangles of pairs at levels 4 and 5, with the threads and the margin of the options.  Domain
/// and errors as of bake().
SquareMaps square_maps(const Scene& scene, const Plan& plan, const Pairs& pairs,
                       const BakeOptions& options = {});

}  // namespace mmverify::scene
