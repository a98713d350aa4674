#include <fmt/format.h>

#include "cli/scene/scene.hpp"

namespace mmverify::cli {
namespace {

using mmverify::scene::Footprint;

/// A curve: bytes by level.
struct Curve {
  const char* name;
  const char* colour;  // Okabe and Ito's
  int shape;
  double (*of)(const Footprint&);
};

constexpr Curve curves[] = {
    {"micromaps, 4-state", "#0072B2", 7,
     [](const Footprint& f) { return static_cast<double>(f.mode[1].data); }},
    {"micromaps, 2-state", "#0072B2", 6,
     [](const Footprint& f) { return static_cast<double>(f.mode[0].data); }},
    {"tree, 4-state", "#D55E00", 5, [](const Footprint& f) { return static_cast<double>(f.mode[1].tree); }},
    {"tree, 2-state", "#D55E00", 4, [](const Footprint& f) { return static_cast<double>(f.mode[0].tree); }},
    {"tree for random access, 4-state", "#009E73", 9,
     [](const Footprint& f) { return static_cast<double>(f.mode[1].our_tree); }},
    {"bitmask, 4-state", "#888888", 12,
     [](const Footprint& f) { return static_cast<double>(f.mode[1].bitmask); }},
    {"texture", "#444444", 13, [](const Footprint& f) { return static_cast<double>(f.texture); }},
    {"records and indices", "#CC79A7", 11,
     [](const Footprint& f) { return static_cast<double>(f.record_bytes + f.index_bytes); }},
};

}  // namespace

std::string sizes_plot_script(const SceneFigures& figures) {
  std::string script =
      "set terminal svg size 1000,900 font 'sans-serif,13' background rgb 'white'\n"
      "set border lc rgb '#444444'\nset tics nomirror\nset grid lc rgb '#dddddd' lw 0.5\nset key outside "
      "right\n"
      "set xtics 1\nset xlabel 'level of every triangle'\nset format y '10^{%L}'\n";
  std::string bytes, ratios;
  for (std::size_t k = 0; k < std::size(curves); ++k) {
    const Curve& c = curves[k];
    std::string points;
    for (const auto& at : figures.at_levels)
      if (const double y = c.of(at.sizes.footprint); y > 0) points += fmt::format("{} {:.6g}\n", at.level, y);
    if (points.empty()) continue;
    script += fmt::format("$c{} << EOD\n{}EOD\n", k, points);
    bytes += fmt::format("{}$c{} with linespoints pt {} ps 0.9 lw 1.2 lc rgb '{}' title '{}'",
                         bytes.empty() ? "" : ", ", k, c.shape, c.colour, c.name);
  }
  for (std::size_t mode = 0; mode < 2; ++mode) {
    std::string points;
    for (const auto& at : figures.at_levels)
      if (const auto& m = at.sizes.footprint.mode[mode]; m.tree != 0)
        points +=
            fmt::format("{} {:.6g}\n", at.level, static_cast<double>(m.data) / static_cast<double>(m.tree));
    if (points.empty()) continue;
    script += fmt::format("$r{} << EOD\n{}EOD\n", mode, points);
    ratios += fmt::format("{}$r{} with linespoints pt {} ps 0.9 lw 1.2 lc rgb '#D55E00' title '{} states'",
                          ratios.empty() ? "" : ", ", mode, mode == 0 ? 4 : 5, mode == 0 ? 2 : 4);
  }
  script += "set multiplot layout 2,1\n";
  if (!bytes.empty())
    script += "set logscale y\nset ylabel 'bytes'\nset title 'Memory by level'\nplot " + bytes + "\n";
  if (!ratios.empty())
    script +=
        "unset logscale y\nset format y '%g'\nset ylabel 'micromaps / tree'\nset title 'How often smaller "
        "the tree is'\nplot " +
        ratios + "\n";
  return script + "unset multiplot\n";
}

}  // namespace mmverify::cli
