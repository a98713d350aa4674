#include <fmt/format.h>

#include <algorithm>

#include "cli/bench/bake.hpp"

namespace mmverify::cli {
namespace {

using bench::BakeFigure;
using bench::BakeFigures;
using bench::BakeLevel;
using bench::Baker;

// Okabe and Ito's colours.
constexpr const char* colours[] = {"#888888", "#E69F00", "#D55E00", "#0072B2", "#009E73", "#AA4488"};
constexpr std::size_t count = bench::bakers;

/// A logarithmic axis has no 0: where none is wrong, a mark lies on the axis.
constexpr double none = 0.1;

std::string error_against_time_of_bake(const BakeLevel& level) {
  std::string data = "$marks << EOD\n";
  double slowest = 1;
  for (std::size_t k = 0; k < count; ++k) {
    const BakeFigure& f = level.by[k];
    slowest = std::max(slowest, f.ns);
    data += fmt::format("{:.6g} {:.6g} {} \"{}\"\n", f.ns,
                        std::max(none, f.wrong_per_million() + f.needless_per_million()),
                        std::stoul(colours[k] + 1, nullptr, 16), bench::to_string(static_cast<Baker>(k)));
  }
  return data +
         fmt::format(
             "EOD\nset title 'Wrong and needless states, against the time of one, level {}'\n"
             "set xlabel 'ns a micro-triangle, one thread'\nset ylabel 'a million; on the axis: none'\n"
             "set logscale xy\nset xrange [*:{:.4g}]\nset yrange [{}:2e6]\nunset key\n"
             "plot $marks using 1:2:3 with points pt 7 ps 0.9 lc rgb variable, $marks using 1:2:4:3 with "
             "labels left offset 0.6,0.7 font ',11' tc rgb variable\nset key top right\nset autoscale\n",
             level.level, slowest * 30, none);
}

std::string time_against_level(const BakeFigures& figures) {
  std::string data, plot;
  for (std::size_t k = 0; k < count; ++k) {
    data += fmt::format("$baker{} << EOD\n", k);
    for (const BakeLevel& level : figures.levels)
      data += fmt::format("{} {:.6g}\n", level.level, level.by[k].ns);
    data += "EOD\n";
    plot += fmt::format("{}$baker{} using 1:2 with linespoints pt 7 ps 0.6 lw 1.2 lc rgb '{}' title '{}'",
                        plot.empty() ? "" : ", ", k, colours[k], bench::to_string(static_cast<Baker>(k)));
  }
  return data +
         "unset logscale\nset logscale y\nset title 'Time, by level'\nset xlabel 'level'\nset ylabel 'ns a "
         "micro-triangle'\nset format y '10^{%L}'\nplot " +
         plot + "\nset format y\n";
}

std::string time_against_size(const BakeFigures& figures) {
  std::string data = "$sizes << EOD\n";
  for (const bench::BakeSize& s : figures.sizes)
    data += fmt::format("{} {:.6g} {:.6g}\n", s.size, s.ns, s.ns_rasterised);
  return data +
         "EOD\nset logscale xy\nset title 'Time, by texture size, level 6'\nset xlabel 'texels along a "
         "side'\n" +
         fmt::format(
             "plot $sizes using 1:2 with linespoints pt 7 ps 0.6 lw 1.2 lc rgb '{}' title '{}', $sizes using "
             "1:3 with linespoints pt 7 ps 0.6 lw 1.2 lc rgb '{}' title '{}'\n",
             colours[4], bench::to_string(Baker::ours), colours[3], bench::to_string(Baker::rasterised));
}

std::string unknown_against_margin(const BakeFigures& figures) {
  std::string data = "$margins << EOD\n";
  for (const bench::BakeMargin& m : figures.margins)
    data += fmt::format("{:.6g} {:.6g}\n", m.texels, 100 * m.unknown);
  return data +
         fmt::format(
             "EOD\nunset logscale\nset title 'Unknown states, by margin, level 6'\nset xlabel 'texels'\nset "
             "ylabel '%'\nset yrange [0:*]\nplot $margins using 1:2 with linespoints pt 7 ps 0.6 lw 1.2 lc "
             "rgb "
             "'{}' notitle\n",
             colours[4]);
}

}  // namespace

std::string bake_plot_script(const BakeFigures& figures) {
  return "set terminal svg size 1200,960 font 'sans-serif,13' background rgb 'white'\n"
         "set border lc rgb '#444444'\nset tics nomirror\nset grid lc rgb '#dddddd' lw 0.5\n"
         "set multiplot layout 2,2\n" +
         error_against_time_of_bake(figures.levels[figures.levels.size() / 2]) + time_against_level(figures) +
         time_against_size(figures) + unknown_against_margin(figures) + "unset multiplot\n";
}

}  // namespace mmverify::cli
