// The whole library: indices, maps and arrays of them, trees, graphs, square maps, attribute maps, bakers, the
// decisions of traversal, and other shapes.  Installed as <mmverify/mmverify.hpp>.
#pragma once

#if __cplusplus < 202002L && !defined(_MSVC_LANG)
#error "mmverify needs C++20: pass -std=c++20"
#else

#include "impl/array/api.hpp"
#include "impl/array/build.hpp"
#include "impl/array/change.hpp"
#include "impl/array/container.hpp"
#include "impl/array/lookup.hpp"
#include "impl/array/structs.hpp"
#include "impl/attribute/bake.hpp"
#include "impl/attribute/compress.hpp"
#include "impl/attribute/container.hpp"
#include "impl/attribute/decimation.hpp"
#include "impl/attribute/error.hpp"
#include "impl/attribute/lookup.hpp"
#include "impl/attribute/mip.hpp"
#include "impl/attribute/order.hpp"
#include "impl/attribute/plan.hpp"
#include "impl/bake/bake.hpp"
#include "impl/bake/blocks/blocks.hpp"
#include "impl/bake/level.hpp"
#include "impl/bake/mesh.hpp"
#include "impl/bake/square/map.hpp"
#include "impl/bake/triangles.hpp"
#include "impl/dag/container.hpp"
#include "impl/dag/dag.hpp"
#include "impl/index/index.hpp"
#include "impl/index/wide.hpp"
#include "impl/micromap/array.hpp"
#include "impl/micromap/level.hpp"
#include "impl/micromap/micromap.hpp"
#include "impl/micromap/reorder.hpp"
#include "impl/micromap/validate.hpp"
#include "impl/subdivision/subdivision.hpp"
#include "impl/traverse/blend.hpp"
#include "impl/traverse/decision.hpp"
#include "impl/tree/container.hpp"
#include "impl/tree/stream.hpp"
#include "impl/tree/tree.hpp"
#include "impl/vq/vq.hpp"

#endif
