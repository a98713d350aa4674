// The time to bake a scene's own triangles, as tables.
#pragma once

#include "bench/result.hpp"
#include "bench/scene/bake.hpp"

namespace mmverify::bench {

/// The tables of a scene's bakes.  Domain: figures of at least one triangle.
Result scene_bake_tables(const SceneBakeFigures& figures, const SceneBakeOptions& options);

}  // namespace mmverify::bench
