#include "cli/bench/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "bench/picture.hpp"

namespace mmverify::cli {
namespace {

using bench::picture::Axis;
using bench::picture::Key;
using bench::picture::Panel;
using bench::picture::Picture;
using bench::picture::Point;
using bench::picture::Series;
using bench::picture::Shape;

// Room around the axes of each panel and for a key, in pixels.
constexpr double left = 80, right = 30, top = 45, bottom = 55;
constexpr double outer_key = 220, lower_key = 65, lower_note = 30;
constexpr char ink[] = "#444444";

/// gnuplot's point types.
int point_type(Shape shape) {
  switch (shape) {
    case Shape::disc: return 7;
    case Shape::circle: return 6;
    case Shape::square: return 5;
    case Shape::open_square: return 4;
    case Shape::triangle: return 9;
    case Shape::triangle_down: return 11;
    case Shape::diamond: return 13;
  }
  return 7;
}

/// The text in gnuplot's single quotes, with gnuplot's markup escaped.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (std::string("_^{}@&~\\").find(c) != std::string::npos) out += '\\';
    out += c;
    if (c == '\'') out += c;
  }
  return out + "'";
}

/// A rectangle of the picture, in pixels from the upper left corner.
struct Box {
  double left, right, top, bottom;
};

/// The place of 0 on a logarithmic y axis: a decade below all other values; 0 if no point is there.
double place_of_none(const Panel& panel) {
  double least = panel.y.least.value_or(std::numeric_limits<double>::infinity());
  bool zero = false;
  for (const Series& series : panel.series)
    for (const Point& point : series.points) {
      zero = zero || point.y == 0;
      if (point.y > 0) least = std::min(least, point.y);
    }
  if (!panel.y.logarithmic || !zero) return 0;
  return std::isinf(least) ? 0.1 : std::pow(10, std::floor(std::log10(least)) - 1);
}

/// Writes one panel's part of the script.
class PanelScript {
 public:
  /// size: the picture's.
  PanelScript(const Panel& panel, const Box& frame, const Box& size)
      : panel_(panel), frame_(frame), size_(size), none_(place_of_none(panel)) {}

  std::string text() const {
    // Scales come before ranges: gnuplot misreads a range from 0 while the last panel's axis is logarithmic.
    return ticks('x', panel_.x) + ticks('y', panel_.y) + frame() + key() + texts() + series();
  }

 private:
  std::string screen(double x, double y) const {
    return fmt::format("screen {:.5f},{:.5f}", x / size_.right, 1 - y / size_.bottom);
  }

  static std::string end(std::optional<double> value) { return value ? fmt::format("{:.6g}", *value) : "*"; }

  std::string frame() const {
    const Box& f = frame_;
    return fmt::format(
        "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
        "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n"
        "set xrange [{}:{}]\nset yrange [{}:{}]\nset offsets {}, {}\n"
        "set title {}\nset xlabel {} offset 0,0.4\nset ylabel {}\n",
        f.left / size_.right, f.right / size_.right, 1 - f.top / size_.bottom, 1 - f.bottom / size_.bottom,
        end(panel_.x.least), end(panel_.x.most), none_ > 0 ? end(none_ / 10) : end(panel_.y.least),
        end(panel_.y.most), panel_.x.logarithmic ? "0, 0" : "graph 0.05, graph 0.05",
        panel_.y.logarithmic ? "0, 0" : "graph 0.05, graph 0.05", quoted(panel_.title),
        quoted(panel_.x.title), quoted(panel_.y.title));
  }

  std::string ticks(char name, const Axis& axis) const {
    std::string text = fmt::format("{0} logscale {1}\nset format {1} '{2}'\nset {1}tics {3}\n",
                                   axis.logarithmic ? "set" : "unset", name,
                                   axis.logarithmic ? "10^{%L}" : "%g", axis.whole ? "1" : "auto");
    if (name == 'y' && none_ > 0)
      text += fmt::format("set ytics {:.6g}, 10\nset ytics add ('none' {:.6g})\n", none_ * 10, none_);
    return text;
  }

  std::string key() const {
    switch (panel_.key) {
      case Key::none: return "unset key\n";
      case Key::top_left: return "set key default\nset key top left Left reverse\n";
      case Key::top_right: return "set key default\nset key top right\n";
      case Key::outside:
        return fmt::format("set key default\nset key at {} left top Left reverse\n",
                           screen(frame_.right + 5, frame_.top));
      case Key::below_all:
        return "set key default\n" +
               fmt::format("set key at {} center center vertical Left reverse maxrows 2 width 3 samplen 1\n",
                           screen(size_.right / 2, size_.bottom - lower_key));
    }
    return "";
  }

  /// The names of thresholds, and the note.
  std::string texts() const {
    std::string text;
    for (const auto& threshold : panel_.thresholds)
      text +=
          fmt::format("set label {} at graph 0.03, first {:.6g} left offset 0,-0.7 font ',11' tc rgb '{}'\n",
                      quoted(threshold.label), threshold.y, bench::picture::grey);
    if (panel_.note.empty()) return text;
    return text + fmt::format("set label {} at graph 0.99, graph 0.04 right font ',12' tc rgb '{}'\n",
                              quoted(panel_.note), ink);
  }

  /// A series' style in gnuplot; the size of its marks depends on whether it has names, lines, or neither.
  static std::string look(const Series& series) {
    if (!series.marks) return fmt::format("lines lw 1 lc rgb '{}'", series.colour);
    return fmt::format("{} lw {} pt {} ps {} lc rgb '{}'", series.joined ? "linespoints" : "points",
                       series.joined ? 1.2 : 1.5, point_type(series.shape),
                       has_labels(series) && !series.joined ? 1.2
                       : series.joined                      ? 0.7
                                                            : 0.9,
                       series.colour);
  }

  static bool has_labels(const Series& series) {
    return std::any_of(series.points.begin(), series.points.end(),
                       [](const Point& p) { return !p.label.empty(); });
  }

  static bool has_repeats(const Series& series) {
    return std::any_of(series.points.begin(), series.points.end(),
                       [](const Point& p) { return p.repeats.has_value(); });
  }

  std::string series() const {
    // Labels of marks that lie upon one another go to different sides; those of zeros, which share a line, rise.
    constexpr const char* sides[] = {"left offset 1,0", "right offset -1,0"};
    std::string data, plots;
    for (std::size_t k = 0; k < panel_.series.size(); ++k) {
      const Series& one = panel_.series[k];
      data += fmt::format("$series{} << EOD\n", k);
      bool zero = false;
      for (const Point& point : one.points) {
        zero = point.y == 0 && none_ > 0;
        data += fmt::format("{:.6g} {:.6g} \"{}\"", point.x, zero ? none_ : point.y, point.label);
        data += point.repeats ? fmt::format(" {:.6g} {:.6g}\n", point.repeats->least, point.repeats->most)
                : has_repeats(one) ? " NaN NaN\n"
                                   : "\n";
      }
      // gnuplot leaves a series without points out of the key, so it gets a NaN.
      if (one.points.empty()) data += "1 NaN\n";
      data += "EOD\n";
      plots += fmt::format(", $series{} using 1:2 with {} {}", k, look(one),
                           one.name.empty() ? "notitle" : "title " + quoted(one.name));
      if (has_repeats(one))
        plots += fmt::format(", $series{} using 1:2:4:5 with xerrorbars pt 0 lw 1 lc rgb '{}' notitle", k,
                             one.colour);
      if (has_labels(one))
        plots +=
            fmt::format(", $series{} using 1:2:3 with labels noenhanced {} font ',12' tc rgb '{}' notitle", k,
                        zero         ? fmt::format("left rotate by {} offset 0,1", 15 + 20 * (k % 4))
                        : one.joined ? "left offset 0.7,0.5"
                                     : sides[k % 2],
                        one.colour);
    }
    for (const auto& threshold : panel_.thresholds)
      plots +=
          fmt::format(", {:.6g} with lines dt 2 lw 1 lc rgb '{}' notitle", threshold.y, bench::picture::grey);
    return data + "plot " + (plots.empty() ? "1/0 notitle" : plots.substr(2)) + "\nunset label\n";
  }

  const Panel& panel_;
  Box frame_, size_;
  double none_;
};

bool has_lower_key(const Picture& picture) {
  for (const auto& row : picture.rows)
    for (const Panel& panel : row)
      if (panel.key == Key::below_all) return true;
  return false;
}

std::string terminal(const Picture& picture, PlotFormat format) {
  if (format == PlotFormat::svg)
    return fmt::format("set terminal svg size {},{} font 'sans-serif,13' background rgb 'white'\n",
                       picture.width, picture.height);
  // Cairo's fonts are in points of 4/3 pixels.
  return fmt::format(
      "set terminal pngcairo size {},{} font 'sans-serif,10' fontscale 2 linewidth 2 pointscale 2 background "
      "rgb 'white'\n",
      2 * picture.width, 2 * picture.height);
}

}  // namespace

std::string plot_script(const Picture& picture, PlotFormat format) {
  const Box size{0, static_cast<double>(picture.width), 0, static_cast<double>(picture.height)};
  std::string script = terminal(picture, format) + "set multiplot\n";
  script += fmt::format("set border lc rgb '{}'\nset tics nomirror\nset grid lc rgb '#dddddd' lw 0.5\n", ink);
  const double below = has_lower_key(picture) ? lower_key + 30 : picture.note.empty() ? 0 : lower_note;
  const double height = (size.bottom - below) / static_cast<double>(picture.rows.size());
  if (!picture.note.empty())
    script += fmt::format("set label {} at screen 0.5,{:.5f} center font ',12' tc rgb '{}'\n",
                          quoted(picture.note), 25 / size.bottom, ink);
  for (std::size_t row = 0; row < picture.rows.size(); ++row) {
    const auto& panels = picture.rows[row];
    const double width = size.right / static_cast<double>(panels.size());
    for (std::size_t k = 0; k < panels.size(); ++k) {
      const double x = width * static_cast<double>(k), y = height * static_cast<double>(row);
      const double beside = panels[k].key == Key::outside ? outer_key : right;
      script +=
          PanelScript(panels[k], {x + left, x + width - beside, y + top, y + height - bottom}, size).text();
    }
  }
  return script + "unset multiplot\n";
}

}  // namespace mmverify::cli
