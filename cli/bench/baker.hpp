// bench bake --subject: somebody's baker on a scene or a folder of textures, beside ours.
#pragma once

#include "bench/baker/tables.hpp"
#include "cli/bench/topics.hpp"

namespace mmverify::cli {

/// All triangles of the scene at each level, one after the other.
/// Throws UsageError where the subject has no baker, EnvironmentError where it breaks or a level does not fit into
/// memory, scene::BadScene, proofs::Interrupted.
bench::BakerFigures baker_figures(const BenchOptions& options, const proofs::Levels& levels);

}  // namespace mmverify::cli
