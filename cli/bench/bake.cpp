#include "cli/bench/bake.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/arguments.hpp"
#include "cli/exit_code.hpp"
#include "cli/tool.hpp"
#include "proofs/engine/interrupt.hpp"

namespace mmverify::cli {
namespace {

using bench::BakeBenchOptions;
using bench::BakeFigure;
using bench::BakeFigures;
using bench::BakeLevel;
using bench::Baker;
using Json = nlohmann::ordered_json;

constexpr Baker all_bakers[] = {Baker::centre,     Baker::corners, Baker::sixteen,
                                Baker::rasterised, Baker::ours,    Baker::rational};

void print_levels(std::FILE* out, const BakeFigures& figures) {
  fmt::print(out, "{:<6}{:<16}{:>14}{:>14}{:>14}{:>12}{:>10}\n", "level", "baker", "states", "wrong/10^6",
             "needless/10^6", "ns a state", "x ours");
  for (const BakeLevel& level : figures.levels) {
    for (const Baker b : all_bakers) {
      const BakeFigure& f = level.of(b);
      fmt::print(out, "{:<6}{:<16}{:>14}{:>14.1f}{:>14.1f}{:>12.2f}{:>10.2f}\n",
                 b == Baker::centre ? fmt::format("{}", level.level) : "", bench::to_string(b),
                 grouped(f.micro_triangles), f.wrong_per_million(), f.needless_per_million(), f.ns,
                 f.ns / level.of(Baker::ours).ns);
    }
    fmt::print(out, "      {:.2f} % unknown; whole numbers took {:.4f} % of our leaves\n",
               100 * level.unknown, 100 * level.exact);
  }
}

void print_sizes(std::FILE* out, const BakeFigures& figures) {
  fmt::print(out, "\nTextures by size, level 6\n{:>8}{:>14}{:>14}{:>10}{:>20}\n", "texels", "ours, ns",
             "binary64, ns", "ratio", "made ready in, ms");
  for (const bench::BakeSize& s : figures.sizes)
    fmt::print(out, "{:>8}{:>14.2f}{:>14.2f}{:>10.1f}{:>20.2f}\n", s.size, s.ns, s.ns_rasterised,
               s.ns_rasterised / s.ns, s.ready_ms);
}

void print_margins(std::FILE* out, const BakeFigures& figures) {
  fmt::print(
      out, "\nMargins, level 6; 1/512 is half a step of a filter's 8-bit weights\n{:>10}{:>12}{:>14}{:>12}\n",
      "texels", "unknown, %", "x no margin", "ours, ns");
  for (const bench::BakeMargin& m : figures.margins)
    fmt::print(out, "{:>10.5f}{:>12.3f}{:>14.4f}{:>12.2f}\n", m.texels, 100 * m.unknown,
               figures.margins.front().unknown > 0 ? m.unknown / figures.margins.front().unknown : 0, m.ns);
}

Json bake_json(const BakeLevel& level) {
  Json j{
      {"level", level.level}, {"unknown", level.unknown}, {"exact", level.exact}, {"bakers", Json::array()}};
  for (const Baker b : all_bakers) {
    const BakeFigure& f = level.of(b);
    j["bakers"].push_back({{"baker", bench::to_string(b)},
                           {"states", f.micro_triangles},
                           {"wrong", f.wrong},
                           {"needless", f.needless},
                           {"wrong_per_million", f.wrong_per_million()},
                           {"needless_per_million", f.needless_per_million()},
                           {"ns", f.ns},
                           {"times_ours", f.ns / level.of(Baker::ours).ns}});
  }
  return j;
}

Json bake_json(const BakeFigures& figures, const BakeBenchOptions& options) {
  Json j{{"schema", "mmverify.bench/1"},
         {"topic", "bake"},
         {"tool", tool({{"seed", options.seed},
                        {"rounds", options.rounds},
                        {"maps", options.textures.empty() ? "generated" : "textures"}})},
         {"textures", figures.textures.size()},
         {"compared", figures.compared},
         {"rows", Json::array()},
         {"sizes", Json::array()},
         {"margins", Json::array()}};
  for (const BakeLevel& level : figures.levels) j["rows"].push_back(bake_json(level));
  for (const bench::BakeSize& s : figures.sizes)
    j["sizes"].push_back(
        {{"texels", s.size}, {"ns", s.ns}, {"binary64_ns", s.ns_rasterised}, {"ready_ms", s.ready_ms}});
  for (const bench::BakeMargin& m : figures.margins)
    j["margins"].push_back({{"texels", m.texels}, {"unknown", m.unknown}, {"ns", m.ns}});
  return j;
}

}  // namespace

BenchOutput bench_bake(const BakeBenchOptions& given, bool quiet, std::FILE* out) {
  BakeBenchOptions options = given;
  options.progress = [quiet](const std::string& what) {
    if (proofs::interrupted()) throw proofs::Interrupted();
    if (!quiet) fmt::print(stderr, "bench bake: {}\n", what);
  };
  BakeFigures figures;
  try {
    figures = bake_figures(options);
  } catch (const std::invalid_argument&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw EnvironmentError(error.what());
  }
  if (proofs::interrupted()) throw proofs::Interrupted();
  fmt::print(
      out,
      "bake, both halves of {} {}, repeated, bilinear, cutoff 1/2, one thread\n\n"
      "wrong: O or T, and not so on all of it; needless: unknown, and O or T on all of it. Judged by ours, "
      "of "
      "which\n{} states, half of them unknown where there are as many, are the specification's as well\n\n",
      figures.textures.size(),
      options.textures.empty() ? fmt::format("textures generated from seed {}", options.seed)
                               : "alpha textures",
      grouped(figures.compared));
  print_levels(out, figures);
  print_sizes(out, figures);
  print_margins(out, figures);
  return {bake_json(figures, options).dump(1) + "\n", bake_plot_script(figures)};
}

}  // namespace mmverify::cli
