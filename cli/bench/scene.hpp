// bench --scene: how fast a scene's own triangles are baked.
#pragma once

#include <cstdio>
#include <string>

#include "proofs/engine/law.hpp"

namespace mmverify::cli {

/// Prints the figures of one glTF file; returns them as JSON text.  EnvironmentError for a scene that cannot
/// be read or has nothing to bake.
std::string bench_scene(const std::string& file, const proofs::Levels& levels, bool quiet, std::FILE* out);

}  // namespace mmverify::cli
