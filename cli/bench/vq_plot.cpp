#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "cli/bench/vq.hpp"

namespace mmverify::cli {
namespace {

using bench::Vq2Encoder;
using bench::Vq4Encoder;
using bench::VqFigures;
using bench::VqRow;

// Okabe and Ito's colours.
constexpr const char *grey = "#888888", *vermilion = "#D55E00", *green = "#009E73", *blue = "#0072B2",
                     *purple = "#AA4488";

struct Line {
  const char* name;
  const char* colour;
  int shape;
  std::function<double(const VqRow&)> savings;
};

/// Savings in per cent, the maps in ascending order of the first line's.
std::string savings_panel(const std::string& title, std::vector<VqRow> rows, const std::vector<Line>& lines,
                          int& blocks) {
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const VqRow& a, const VqRow& b) { return lines[0].savings(a) < lines[0].savings(b); });
  std::string data, plot;
  for (const Line& line : lines) {
    const std::string block = fmt::format("$panel{}", blocks++);
    data += block + " << EOD\n";
    for (std::size_t k = 0; k < rows.size(); ++k)
      data += fmt::format("{} {:.4f}\n", k + 1, 100 * line.savings(rows[k]));
    data += "EOD\n";
    plot += fmt::format("{}{} using 1:2 with linespoints pt {} ps 0.6 lw 1.2 lc rgb '{}' title '{}'",
                        plot.empty() ? "" : ", ", block, line.shape, line.colour, line.name);
  }
  return data + fmt::format(
                    "set title '{}'\nset xlabel 'maps, in order of the source'\nset ylabel 'savings, "
                    "%'\nset yrange [0:100]\nset xrange [0.5:{}.5]\nset key top left Left reverse\nplot {}\n",
                    title, rows.size(), plot);
}

struct SavingsMark {
  std::string name;
  const char* colour;
  double ms, lost;
};

template <class Encoder>
SavingsMark mark(const VqFigures& figures, Encoder encoder, const char* codec, const char* colour) {
  SavingsMark m{fmt::format("{} {}", codec, bench::to_string(encoder)), colour, 0, 0};
  double states = 0, lost = 0;
  for (const VqRow& row : figures.rows) {
    m.ms += row.by(encoder).ms;
    lost += row.by(encoder).substitutions;
    states += codec[2] == '2' ? row.states_16 : row.states_32;
  }
  m.ms /= static_cast<double>(figures.rows.size());
  m.lost = states > 0 ? 100 * lost / states : 0;
  return m;
}

/// The share of O and T that is lost, over the time of a map.
std::string error_against_time_of_vq(const VqFigures& figures) {
  std::vector<SavingsMark> marks;
  for (std::size_t k = 0; k < bench::vq2_encoders; ++k) {
    const auto e = static_cast<Vq2Encoder>(k);
    marks.push_back(mark(figures, e, "VQ2", e == Vq2Encoder::optimal ? green : vermilion));
  }
  for (std::size_t k = 0; k < bench::vq4_encoders; ++k) {
    const auto e = static_cast<Vq4Encoder>(k);
    marks.push_back(mark(figures, e, "VQ4", k < 2 ? vermilion : e == Vq4Encoder::proved ? purple : blue));
  }
  double least = 0, states = 0;
  for (const VqRow& row : figures.rows) least += row.least, states += row.states_32;
  const double bound = states > 0 ? 100 * least / states : 0;
  double slowest = 0, most = 0;
  std::string data = "$marks << EOD\n";
  for (const SavingsMark& m : marks) {
    data +=
        fmt::format("{:.6g} {:.6g} {} \"{}\"\n", m.ms, m.lost, std::stoul(m.colour + 1, nullptr, 16), m.name);
    slowest = std::max(slowest, m.ms);
    most = std::max(most, m.lost);
  }
  data += "EOD\n";
  // Thorough is as good as balanced most often: its label goes below.
  return data +
         fmt::format(
             "set title 'O and T lost, against the time of a map'\nset xlabel 'ms a map, one thread'\nset "
             "ylabel "
             "'lost, % of O and T'\nset logscale x\nset xrange [*:{:.4g}]\nset yrange [0:{:.4g}]\nunset key\n"
             "set label 'no block of VQ4 loses less' at graph 0.02, first {:.6g} offset 0,-0.8 font ',11' tc "
             "rgb "
             "'{}'\n"
             "plot {:.6g} with lines dt 2 lw 1 lc rgb '{}' notitle, $marks using 1:2:3 with points pt 7 ps "
             "0.9 lc "
             "rgb variable notitle, $marks using ($0 != 7 ? $1 : 1/0):2:4:3 with labels left offset 0.8,0.6 "
             "font "
             "',11' tc rgb variable notitle, $marks using ($0 == 7 ? $1 : 1/0):2:4:3 with labels left offset "
             "0.8,-0.8 font ',11' tc rgb variable notitle\nunset logscale x\nunset label\n",
             std::max(slowest * 12, 1.0), std::max(most * 1.15, 1.0), bound, grey, bound, grey);
}

}  // namespace

std::string vq_plot_script(const VqFigures& figures) {
  int blocks = 0;
  std::string script =
      "set terminal svg size 1200,960 font 'sans-serif,13' background rgb 'white'\n"
      "set border lc rgb '#444444'\nset tics nomirror\nset grid lc rgb '#dddddd' lw 0.5\n"
      "set multiplot layout 2,2\n";
  script += savings_panel(
      "VQ2: 16x16 regions in 256 bits", figures.rows,
      {{"source", grey, 7, [](const VqRow& r) { return r.savings_16; }},
       {"VQ2 optimal", green, 5, [](const VqRow& r) { return r.savings(Vq2Encoder::optimal); }},
       {"Algorithm 1", vermilion, 9, [](const VqRow& r) { return r.savings(Vq2Encoder::paper); }},
       {"two of 64 sub-triangles, 2 bits each", blue, 13, [](const VqRow& r) { return r.savings_64x2; }}},
      blocks);
  script += savings_panel(
      "VQ4: 32x32 regions in 512 bits", figures.rows,
      {{"source", grey, 7, [](const VqRow& r) { return r.savings_32; }},
       {"VQ4 balanced", green, 5, [](const VqRow& r) { return r.savings(Vq4Encoder::balanced); }},
       {"Algorithm 2", vermilion, 9, [](const VqRow& r) { return r.savings(Vq4Encoder::paper); }},
       {"16x16, 2 bits each", blue, 13, [](const VqRow& r) { return r.savings_16; }}},
      blocks);
  script += savings_panel("Sources: resolution", figures.rows,
                          {{"32x32", green, 5, [](const VqRow& r) { return r.savings_32; }},
                           {"16x16", blue, 13, [](const VqRow& r) { return r.savings_16; }},
                           {"8x8", vermilion, 9, [](const VqRow& r) { return r.savings_8; }}},
                          blocks);
  return script + error_against_time_of_vq(figures) + "unset multiplot\n";
}

}  // namespace mmverify::cli
