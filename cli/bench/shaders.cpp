#include "cli/bench/shaders.hpp"

#include "cli/output/exit_code.hpp"
#include "subjects/shaders/compile/compile.hpp"
#include "subjects/shaders/speed/speed.hpp"

namespace mmverify::cli {

bench::ShaderFigures shader_figures(const BenchOptions& options, const proofs::Levels& levels) {
  const shaders::SpeedOptions asked{.device = options.device,
                                    .first = levels.first,
                                    .last = levels.last,
                                    .seed = options.index.seed,
                                    .progress = progress_of("shaders", options)};
  bench::ShaderFigures figures;
  figures.device = asked.device;
  figures.batch = asked.batch;
  figures.seed = asked.seed;
  try {
    const shaders::Speeds measured = shaders::speeds(asked);
    figures.about = measured.about;
    for (const shaders::Speed& s : measured.rows)
      figures.rows.push_back({.function = s.function,
                              .level = s.level ? std::optional<std::uint64_t>(*s.level) : std::nullopt,
                              .device_ns = s.device_ns,
                              .cpu_ns = s.cpu_ns,
                              .differing = s.differing});
  } catch (const shaders::NotAvailable& why) {
    throw EnvironmentError(std::string("bench shaders: ") + why.what());
  } catch (const shaders::BadShader& why) {
    throw EnvironmentError(std::string("bench shaders: ") + why.what());
  }
  return figures;
}

}  // namespace mmverify::cli
