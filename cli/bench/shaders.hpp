// mmverify bench shaders.
#pragma once

#include "bench/shaders/tables.hpp"
#include "cli/bench/topics.hpp"

namespace mmverify::cli {

/// Errors: EnvironmentError if this machine cannot compile, run or time shaders; shaders::WrongAnswer.
bench::ShaderFigures shader_figures(const BenchOptions& options, const proofs::Levels& levels);

}  // namespace mmverify::cli
