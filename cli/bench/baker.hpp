// bench bake --subject: another baker on a scene or a folder of textures, compared with ours.
#pragma once

#include "bench/baker/tables.hpp"
#include "cli/bench/topics.hpp"

namespace mmverify::cli {

/// Bakes all triangles of the scene at each level, one after the other.
/// Throws UsageError if the subject has no baker, EnvironmentError if it breaks or a level does not fit into
/// memory, scene::BadScene, proofs::Interrupted.
bench::BakerFigures baker_figures(const BenchOptions& options, const proofs::Levels& levels);

}  // namespace mmverify::cli
