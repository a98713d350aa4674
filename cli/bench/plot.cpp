#include "cli/bench/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/bench/labels.hpp"

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
    case Shape::disc:
      return 7;
    case Shape::circle:
      return 6;
    case Shape::square:
      return 5;
    case Shape::open_square:
      return 4;
    case Shape::triangle:
      return 9;
    case Shape::triangle_down:
      return 11;
    case Shape::diamond:
      return 13;
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

/// Writes one panel's part of the script.
class PanelScript {
 public:
  /// size: the picture's.
  PanelScript(const Panel& panel, const Box& frame, const Box& size)
      : panel_(placed(panel, axes_of(panel, frame))), axes_(axes_of(panel, frame)), size_(size) {}

  std::string text() const {
    return frame() + ticks('x', panel_.x, axes_.x) + ticks('y', panel_.y, axes_.y) + key() + thresholds() +
           note() + labels() + series();
  }

 private:
  std::string screen(double x, double y) const {
    return fmt::format("screen {:.5f},{:.5f}", x / size_.right, 1 - y / size_.bottom);
  }

  std::string frame() const {
    const Box& f = axes_.frame;
    return fmt::format(
        "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
        "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n"
        "set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n"
        "set title {}\nset xlabel {} offset 0,0.4\nset ylabel {}\n",
        f.left / size_.right, f.right / size_.right, 1 - f.top / size_.bottom, 1 - f.bottom / size_.bottom,
        axes_.x.least, axes_.x.most, axes_.y.least, axes_.y.most, quoted(panel_.title),
        quoted(panel_.x.title), quoted(panel_.y.title));
  }

  static std::string ticks(char name, const Axis& axis, const Scale& scale) {
    std::string text = fmt::format("{0} logscale {1}\nset format {1} '{2}'\nset {1}tics {3}\n",
                                   axis.logarithmic ? "set" : "unset", name,
                                   axis.logarithmic ? "10^{%L}" : "%g", axis.whole ? "1" : "auto");
    if (scale.none == 0) return text;
    text += fmt::format("set {}tics ('none' {:.6g}", name, scale.none);
    for (double tick = scale.none * 10; tick <= scale.most; tick *= 10)
      text += fmt::format(", '10^{{{:.0f}}}' {:.6g}", std::log10(tick), tick);
    return text + ")\n";
  }

  std::string key() const {
    switch (panel_.key) {
      case Key::none:
        return "unset key\n";
      case Key::top_left:
        return "set key default\nset key top left Left reverse\n";
      case Key::top_right:
        return "set key default\nset key top right\n";
      case Key::outside:
        return fmt::format("set key default\nset key at {} left top Left reverse\n",
                           screen(axes_.frame.right + 5, axes_.frame.top));
      case Key::below_all:
        return "set key default\n" +
               fmt::format("set key at {} center center vertical Left reverse maxrows 2 width 3 samplen 1\n",
                           screen(size_.right / 2, size_.bottom - lower_key));
    }
    return "";
  }

  Box threshold_label(const bench::picture::Threshold& threshold) const {
    return label_box(threshold.label, axes_.frame.left + 8, axes_.pixel_y(threshold.y) + 10);
  }

  std::string thresholds() const {
    std::string text;
    for (const auto& threshold : panel_.thresholds) {
      const double height = axes_.pixel_y(threshold.y);
      const Box box = threshold_label(threshold);
      text += fmt::format("set arrow from {} to {} nohead dt 2 lw 1 lc rgb '{}'\n",
                          screen(axes_.frame.left, height), screen(axes_.frame.right, height),
                          bench::picture::grey);
      text += fmt::format("set label {} at {} left font ',11' tc rgb '{}'\n", quoted(threshold.label),
                          screen(box.left, (box.top + box.bottom) / 2), bench::picture::grey);
    }
    return text;
  }

  std::string note() const {
    if (panel_.note.empty()) return "";
    return fmt::format("set label {} at {} right font ',12' tc rgb '{}'\n", quoted(panel_.note),
                       screen(axes_.frame.right - 8, axes_.frame.bottom - 18), ink);
  }

  /// The box of a line across the panel, which labels avoid.
  Box across(double y) const {
    return {axes_.frame.left, axes_.frame.right, axes_.pixel_y(y) - 2, axes_.pixel_y(y) + 2};
  }

  std::string labels() const {
    std::vector<Box> taken;
    if (axes_.y.none > 0) taken.push_back(across(axes_.y.none));
    for (const auto& threshold : panel_.thresholds) {
      taken.push_back(across(threshold.y));
      taken.push_back(threshold_label(threshold));
    }
    std::string text;
    for (const PlacedLabel& label : place_labels(panel_, axes_, taken)) {
      const double middle = (label.box.top + label.box.bottom) / 2;
      text += fmt::format("set label {} at {} left font ',12' tc rgb '{}'\n", quoted(label.text),
                          screen(label.box.left, middle), label.colour);
      if (label.away)
        text += fmt::format("set arrow from {} to {} nohead lw 0.7 lc rgb '{}'\n",
                            screen(label.mark_x, label.mark_y),
                            screen(std::clamp(label.mark_x, label.box.left, label.box.right),
                                   middle < label.mark_y ? label.box.bottom - 2 : label.box.top + 2),
                            bench::picture::grey);
    }
    return text;
  }

  /// A series' style in gnuplot; the size of its marks depends on whether it has names, lines, or neither.
  static std::string look(const Series& series) {
    if (!series.marks) return fmt::format("lines lw 1 lc rgb '{}'", series.colour);
    const bool named = !series.joined && !series.points.empty() && !series.points.front().label.empty();
    return fmt::format("{} lw {} pt {} ps {} lc rgb '{}'", series.joined ? "linespoints" : "points",
                       series.joined ? 1.2 : 1.5, point_type(series.shape),
                       named           ? 1.2
                       : series.joined ? 0.7
                                       : 0.9,
                       series.colour);
  }

  std::string series() const {
    std::string data, plots;
    for (std::size_t k = 0; k < panel_.series.size(); ++k) {
      const Series& one = panel_.series[k];
      data += fmt::format("$series{} << EOD\n", k);
      for (const Point& point : one.points) data += fmt::format("{:.6g} {:.6g}\n", point.x, point.y);
      // gnuplot leaves a series without points out of the key, so it gets a NaN.
      if (one.points.empty()) data += fmt::format("{:.6g} NaN\n", axes_.x.least);
      data += "EOD\n";
      plots += fmt::format("{}$series{} using 1:2 with {} {}", k == 0 ? "" : ", ", k, look(one),
                           one.name.empty() ? "notitle" : "title " + quoted(one.name));
    }
    return data + "plot " + (plots.empty() ? "1/0 notitle" : plots) + "\nunset label\nunset arrow\n";
  }

  Panel panel_;
  Axes axes_;
  Box size_;
};

bool has_lower_key(const Picture& picture) {
  for (const auto& row : picture.rows)
    for (const Panel& panel : row)
      if (panel.key == Key::below_all) return true;
  return false;
}

}  // namespace

std::string plot_script(const Picture& picture) {
  const Box size{0, static_cast<double>(picture.width), 0, static_cast<double>(picture.height)};
  std::string script = fmt::format(
      "set terminal svg size {},{} font 'sans-serif,13' background rgb 'white'\nset multiplot\n"
      "set border lc rgb '{}'\nset tics nomirror\nset grid lc rgb '#dddddd' lw 0.5\n",
      picture.width, picture.height, ink);
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
