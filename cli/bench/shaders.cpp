#include "cli/bench/shaders.hpp"

#include "cli/output/exit_code.hpp"
#include "subjects/shaders/compile/compile.hpp"
#include "subjects/shaders/speed/on_device.hpp"
#include "subjects/shaders/speed/speed.hpp"

namespace mmverify::cli {
namespace {

bench::KernelSpeed figures_of(const shaders::Speed& s) {
  const auto word_of = [](shaders::Order order) {
    return order == shaders::Order::coherent ? "coherent" : "shuffled";
  };
  return {.kernel = s.kernel,
          .level = s.level ? std::optional<std::uint64_t>(*s.level) : std::nullopt,
          .hits = s.hits,
          .order = s.order ? word_of(*s.order) : "",
          .bytes_in = s.bytes_in,
          .bytes_out = s.bytes_out,
          .ns = s.ns,
          .spread = s.spread,
          .share_of_copy = s.share_of_copy,
          .checked = s.checked};
}

}  // namespace

bench::ShaderFigures shader_figures(const BenchOptions& options, const proofs::Levels& levels) {
  const shaders::SpeedOptions asked{.device = options.device,
                                    .first = levels.first,
                                    .last = levels.last,
                                    .hits = options.hits,
                                    .progress = progress_of("shaders", options)};
  try {
    const shaders::Speeds measured = shaders::speeds(asked);
    bench::ShaderFigures figures{.device = asked.device,
                                 .hits = measured.hits,
                                 .runs = measured.runs,
                                 .is_processor = measured.is_processor,
                                 .bounded_by = measured.bounded_by,
                                 .bandwidth = measured.bandwidth,
                                 .about = measured.about,
                                 .rows = {}};
    for (const shaders::Speed& s : measured.rows) figures.rows.push_back(figures_of(s));
    return figures;
  } catch (const shaders::NotAvailable& why) {
    throw EnvironmentError(std::string("bench shaders: ") + why.what());
  } catch (const shaders::BadShader& why) {
    throw EnvironmentError(std::string("bench shaders: ") + why.what());
  } catch (const shaders::DeviceFailed& why) {
    throw EnvironmentError(std::string("bench shaders: ") + why.what());
  }
}

}  // namespace mmverify::cli
