// How fast a scene's own triangles are baked, as tables.
#pragma once

#include "bench/result.hpp"
#include "bench/scene/bake.hpp"

namespace mmverify::bench {

/// Domain: figures of at least one triangle.
Result scene_bake_tables(const SceneBakeFigures& figures, const SceneBakeOptions& options);

}  // namespace mmverify::bench
