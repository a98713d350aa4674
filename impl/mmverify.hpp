// The whole library: indices, maps, trees, square maps and the baker.  Installed as <mmverify/mmverify.hpp>.
#pragma once

#include "impl/bake/bake.hpp"
#include "impl/bake/square/map.hpp"
#include "impl/bake/triangles.hpp"
#include "impl/index/index.hpp"
#include "impl/index/wide.hpp"
#include "impl/micromap/array.hpp"
#include "impl/micromap/level.hpp"
#include "impl/micromap/micromap.hpp"
#include "impl/micromap/reorder.hpp"
#include "impl/micromap/validate.hpp"
#include "impl/tree/container.hpp"
#include "impl/tree/stream.hpp"
#include "impl/tree/tree.hpp"
#include "impl/vq/vq.hpp"
