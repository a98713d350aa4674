#include "cli/bench/index.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/index/times.hpp"
#include "cli/arguments.hpp"
#include "cli/bench/plot.hpp"
#include "cli/tool.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/progress.hpp"

namespace mmverify::cli {
namespace {

using bench::Growth;
using bench::GrowthLaw;
using bench::IndexErrors;
using bench::IndexFigures;
using bench::IndexTime;
using Json = nlohmann::ordered_json;

std::string rate(const IndexErrors& e) {
  return e.mismatches == 0 ? "none" : fmt::format("{:.2e}", e.rate());
}

/// The worst distance; where every mismatch left the grid there is none to give.
std::string worst(const IndexErrors& e, double distance) {
  return e.mismatches == e.off_grid ? "-" : fmt::format("{:.3g}", distance);
}

bool fitted(const Growth& g) { return g.law != GrowthLaw::none && g.law != GrowthLaw::too_few; }

/// "doubles  0.98 (0.17) 1..10": the law, its slope, its residual, the levels.
std::string growth(const Growth& g) {
  if (!fitted(g)) return to_string(g);
  std::string law = to_string(g);
  law = g.law == GrowthLaw::power ? "power" : law.substr(0, law.find(' '));
  const bench::Line& line = g.law == GrowthLaw::power ? g.power : g.exponential;
  return fmt::format("{:<7} {:>5.2f} ({:.2f}) {}..{}", law, line.slope, line.residual, g.first, g.last);
}

void print_errors(std::FILE* out, const std::vector<IndexFigures>& figures) {
  fmt::print(out, "{:<18} {:>5} {:>9} {:>9} {:>9} {:>9} {:>9} {:>10} {:>15}\n", "subject", "level", "uniform",
             "hard", "heights", "ulp", "off grid", "ns/index", "/ reference-f32");
  for (const IndexFigures& f : figures) {
    if (f.hard.empty()) continue;
    const IndexErrors &u = f.uniform.back(), &h = f.hard.back();
    const IndexTime& t = f.times.back();
    fmt::print(out, "{:<18} {:>5} {:>9} {:>9} {:>9} {:>9} {:>9} {:>10.2f} {:>15.2f}\n", f.name, h.level,
               rate(u), rate(h), worst(h, h.worst_heights), worst(h, h.worst_ulp),
               h.off_grid == 0 ? "-" : grouped(h.off_grid), t.ns_per_index, t.ratio_to_reference_f32);
  }
}

void print_growth(std::FILE* out, const std::vector<IndexFigures>& figures) {
  fmt::print(out, "{:<18} {:<29} {:<29} {}\n", "subject", "rate, uniform", "rate, hard",
             "worst heights, hard");
  for (const IndexFigures& f : figures)
    fmt::print(out, "{:<18} {:<29} {:<29} {}\n", f.name, growth(f.uniform_rate), growth(f.hard_rate),
               growth(f.hard_heights));
}

void print_times(std::FILE* out, const std::vector<IndexFigures>& figures) {
  const std::vector<IndexTime>* widest = nullptr;
  for (const IndexFigures& f : figures)
    if (widest == nullptr || f.times.size() > widest->size()) widest = &f.times;
  fmt::print(out, "{:<18}", "level");
  for (const IndexTime& t : *widest) fmt::print(out, " {:>10}", t.level);
  for (const IndexTime& t : *widest) fmt::print(out, " {:>10}", t.level);
  fmt::print(out, "\n");
  for (const IndexFigures& f : figures) {
    const auto row = [&](double IndexTime::*figure) {
      for (const IndexTime& level : *widest) {
        const IndexTime* found = nullptr;
        for (const IndexTime& t : f.times)
          if (t.level == level.level) found = &t;
        fmt::print(out, " {:>10}", found == nullptr ? "-" : fmt::format("{:.2f}", found->*figure));
      }
    };
    fmt::print(out, "{:<18}", f.name);
    row(&IndexTime::ns_per_index);
    row(&IndexTime::ratio_to_reference_f32);
    fmt::print(out, "\n");
  }
}

Json index_json(const bench::Line& line) {
  return {{"slope", line.slope}, {"intercept", line.intercept}, {"residual", line.residual}};
}

Json index_json(const Growth& g) {
  Json j{{"law", to_string(g)}, {"levels", g.levels}};
  if (!fitted(g)) return j;
  j["first"] = g.first;
  j["last"] = g.last;
  j["exponential"] = index_json(g.exponential);
  j["power"] = index_json(g.power);
  return j;
}

Json index_json(const IndexErrors& e, bool hard) {
  Json j{{"level", e.level},        {"inputs", hard ? "hard" : "uniform"},
         {"samples", e.samples},    {"mismatches", e.mismatches},
         {"off_grid", e.off_grid},  {"worst_heights", e.worst_heights},
         {"worst_ulp", e.worst_ulp}};
  if (hard)
    for (std::size_t k = 0; k < bench::hard_kinds; ++k)
      j["by_kind"][std::string(to_string(static_cast<bench::HardKind>(k)))] = e.by_kind[k];
  return j;
}

Json index_json(const std::vector<IndexFigures>& figures, const bench::IndexBenchOptions& options) {
  Json j{{"schema", "mmverify.bench/1"},
         {"topic", "index"},
         {"tool", tool({{"seed", options.seed}, {"samples", options.samples}})},
         {"rows", Json::array()},
         {"subjects", Json::array()}};
  for (const IndexFigures& f : figures) {
    for (const IndexTime& t : f.times)
      j["rows"].push_back({{"subject", f.name},
                           {"level", t.level},
                           {"ns_per_index", t.ns_per_index},
                           {"ratio_to_reference_f32", t.ratio_to_reference_f32}});
    Json subject{{"subject", f.name},
                 {"numbers", f.numbers},
                 {"order", f.order},
                 {"max_level", f.max_level},
                 {"errors", Json::array()}};
    for (const IndexErrors& e : f.uniform) subject["errors"].push_back(index_json(e, false));
    for (const IndexErrors& e : f.hard) subject["errors"].push_back(index_json(e, true));
    subject["growth"] = {{"uniform_rate", index_json(f.uniform_rate)},
                         {"hard_rate", index_json(f.hard_rate)},
                         {"hard_worst_heights", index_json(f.hard_heights)}};
    j["subjects"].push_back(subject);
  }
  return j;
}

std::vector<IndexFigures> measured(bench::IndexBenchOptions options, bool quiet) {
  std::vector<IndexFigures> figures;
  {
    proofs::Progress progress(index_points(options), !quiet);
    progress.now("bench index");
    options.progress = [&progress](std::uint64_t points) {
      if (proofs::interrupted()) throw proofs::Interrupted();
      progress.add(points);
    };
    figures = index_errors(options);
  }
  // Nothing else runs while the clock does.
  add_index_times(options, figures);
  if (proofs::interrupted()) throw proofs::Interrupted();
  return figures;
}

}  // namespace

BenchOutput bench_index(const bench::IndexBenchOptions& options, bool quiet, std::FILE* out) {
  const std::vector<IndexFigures> figures = measured(options, quiet);
  fmt::print(
      out,
      "index, levels {}..{}, seed {}, {} uniform and {} hard points a level (rationals: a 256th).\n"
      "A sample is checked, never proved: 'none' is none found.\n\n"
      "Mismatch rates at the highest level; the worst distance of a hard point from the micro-triangle "
      "returned;\ntime on uniform points, one thread\n",
      options.first, options.last, options.seed, grouped(options.samples), grouped(options.samples));
  print_errors(out, figures);
  fmt::print(
      out,
      "\nGrowth from level to level: the law, its slope (log2 a level; a power law's is the power), (its "
      "residual)\nin log2, and the levels that it was fitted on\n");
  print_growth(out, figures);
  fmt::print(out, "\nTime: ns an index, then the ratio to reference-f32\n");
  print_times(out, figures);

  return {index_json(figures, options).dump(1) + "\n", index_plot_script(figures, options.samples)};
}

}  // namespace mmverify::cli
