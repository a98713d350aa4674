#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bench/index/tables.hpp"

namespace mmverify::bench {
namespace {

using namespace picture;

/// The look of a subject: its colour is the algorithm, its shape the numbers.
Series look_of(const IndexFigures& f) {
  Series series{.name = f.name, .colour = blue, .shape = Shape::disc, .joined = false};
  if (f.name.starts_with("step")) series.colour = vermilion;
  if (f.order == "rows") series.colour = purple;
  if (f.name.starts_with("impl") || f.name.ends_with("impl")) series.colour = green;
  if (f.numbers == "binary16") series.shape = Shape::triangle;
  if (f.numbers == "binary64") series.shape = Shape::open_square;
  if (f.numbers == "fixed point") series.shape = Shape::diamond;
  if (f.numbers == "rational") series.shape = Shape::triangle_down;
  if (f.name.ends_with("minor-impl")) series.shape = Shape::square;
  if (f.name.ends_with("batched") || f.name.ends_with("sqrt")) series.shape = Shape::circle;
  return series;
}

/// "16", or "16 (binary16: 15)" if some subjects end sooner than others.
std::string levels_text(const std::vector<IndexFigures>& figures) {
  std::uint32_t last = 0;
  for (const IndexFigures& f : figures)
    if (!f.stiff.empty()) last = std::max(last, f.stiff.back().level);
  for (const IndexFigures& f : figures)
    if (!f.stiff.empty() && f.stiff.back().level < last)
      return fmt::format("{} ({}: {})", last, f.numbers, f.stiff.back().level);
  return fmt::format("{}", last);
}

Panel error_against_time(const std::vector<IndexFigures>& figures, std::uint64_t samples) {
  std::uint64_t fewest = samples;
  Panel panel{.title = "Error against time at level " + levels_text(figures),
              .x = {.title = "ns an index, one thread", .logarithmic = true},
              .y = {.title = "mismatch rate on stiff points",
                    .logarithmic = true,
                    .least = 1.0 / static_cast<double>(samples),
                    .most = 1.5},
              .key = Key::outside};
  for (const IndexFigures& f : figures) {
    if (f.times.empty() || f.stiff.empty()) continue;
    Series series = look_of(f);
    const IndexTime& time = f.times.back();
    series.points = {{time.ns_per_index, f.stiff.back().rate(), "", Range{time.least_ns, time.most_ns}}};
    panel.series.push_back(series);
    fewest = std::min(fewest, f.stiff.back().samples);
  }
  panel.note = fmt::format("none found in {} points (rational: {})", fmt::group_digits(samples),
                           fmt::group_digits(fewest));
  return panel;
}

/// The fitted law over the levels it was fitted on.
Series law_curve(const Growth& g, const std::string& colour) {
  constexpr int steps_a_level = 8;
  Series curve{.colour = colour, .marks = false};
  if (g.law == GrowthLaw::none || g.law == GrowthLaw::too_few) return curve;
  for (std::uint32_t k = g.first * steps_a_level; k <= g.last * steps_a_level; ++k) {
    const double level = static_cast<double>(k) / steps_a_level;
    const double log = g.law == GrowthLaw::power ? g.power.intercept + g.power.slope * std::log2(level)
                                                 : g.exponential.intercept + g.exponential.slope * level;
    curve.points.push_back({level, std::exp2(log)});
  }
  return curve;
}

bool ever_wrong(const IndexFigures& f) {
  const auto wrong = [](const IndexErrors& e) { return e.mismatches > 0; };
  return std::any_of(f.stiff.begin(), f.stiff.end(), wrong) ||
         std::any_of(f.uniform.begin(), f.uniform.end(), wrong);
}

Panel rate_against_level(const std::vector<IndexFigures>& figures, bool stiff, std::uint64_t samples) {
  std::uint32_t first = 16, last = 0;
  for (const IndexFigures& f : figures)
    for (const IndexErrors& e : f.stiff) first = std::min(first, e.level), last = std::max(last, e.level);
  Panel panel{.title = fmt::format("On {} points, with the fitted laws", stiff ? "stiff" : "uniform"),
              .x = {.title = "level", .least = first - 0.5, .most = last + 0.5, .whole = true},
              .y = {.title = stiff ? "" : "mismatch rate",
                    .logarithmic = true,
                    .least = 0.5 / static_cast<double>(samples),
                    .most = 1.5},
              .key = stiff ? Key::none : Key::below_all};
  for (const IndexFigures& f : figures) {
    // Both kinds of points count, so that the panels share one key.
    if (!ever_wrong(f)) continue;
    Series series = look_of(f);
    for (const IndexErrors& e : stiff ? f.stiff : f.uniform)
      if (e.mismatches > 0) series.points.push_back({static_cast<double>(e.level), e.rate()});
    panel.series.push_back(series);
    if (Series curve = law_curve(stiff ? f.stiff_rate : f.uniform_rate, series.colour); !curve.points.empty())
      panel.series.push_back(curve);
  }
  return panel;
}

std::string without_error(const std::vector<IndexFigures>& figures) {
  std::string names;
  for (const IndexFigures& f : figures)
    if (!ever_wrong(f)) names += (names.empty() ? "" : ", ") + f.name;
  return names.empty() ? "" : "none found at any level: " + names;
}

}  // namespace

Picture index_picture(const std::vector<IndexFigures>& figures, std::uint64_t samples) {
  return {.width = 1200,
          .height = 940,
          .rows = {{error_against_time(figures, samples)},
                   {rate_against_level(figures, false, samples), rate_against_level(figures, true, samples)}},
          .note = without_error(figures)};
}

}  // namespace mmverify::bench
