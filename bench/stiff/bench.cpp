#include "bench/stiff/bench.hpp"

#include <cmath>
#include <stdexcept>

#include "bench/stiff/parts.hpp"

namespace mmverify::bench {

float stiff::subnormal(Random& random) {
  return std::ldexp(static_cast<float>(random() % (std::uint64_t{1} << (1 + below(random, 23)))), -149);
}

std::vector<StiffFigure> stiff_figures(const StiffBenchOptions& options) {
  if (options.samples == 0 || options.rounds == 0)
    throw std::invalid_argument("stiff bench: a sample and a round at least");
  std::vector<StiffFigure> figures;
  stiff::add_points(options, figures);
  stiff::add_triangles(options, figures);
  stiff::add_texels(options, figures);
  stiff::add_weights(options, figures);
  return figures;
}

}  // namespace mmverify::bench
