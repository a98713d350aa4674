#include <map>

#include "bench/stiff/tables.hpp"

namespace mmverify::bench {
namespace {

using namespace picture;

const char* colour_of_stiff(const StiffFigure& f) {
  if (f.is_ours) return green;
  if (f.method.ends_with("rational")) return purple;
  if (f.method.ends_with("f64") || f.method.ends_with("binary64")) return blue;
  return f.method.ends_with("samples") || f.method.ends_with("sample") ? orange : vermilion;
}

/// A line from a method's figures on ordinary inputs, an open mark, to those on stiff ones.
void add_method(const StiffFigure& f, Panel& panel) {
  const double ordinary_ns = f.ns / f.ratio;
  panel.series.push_back({.colour = colour_of_stiff(f),
                          .marks = false,
                          .points = {{ordinary_ns, f.ordinary_share()}, {f.ns, f.share()}}});
  panel.series.push_back({.colour = colour_of_stiff(f),
                          .shape = Shape::circle,
                          .joined = false,
                          .points = {{ordinary_ns, f.ordinary_share()}}});
  panel.series.push_back(
      {.colour = colour_of_stiff(f), .joined = false, .points = {{f.ns, f.share(), f.method}}});
}

}  // namespace

Picture stiff_picture(const std::vector<StiffFigure>& figures) {
  std::vector<Panel> panels;
  for (const StiffFigure& f : figures) {
    if (panels.empty() || panels.back().title != f.kind)
      panels.push_back({.title = f.kind,
                        .x = {.title = "ns an answer", .logarithmic = true},
                        .y = {.title = "share wrong", .logarithmic = true, .most = 2}});
    add_method(f, panels.back());
  }
  Picture drawn{.width = 1200,
                .height = static_cast<int>(320 * ((panels.size() + 1) / 2)),
                .note = "open: ordinary inputs; filled: stiff ones; green: ours"};
  for (std::size_t k = 0; k < panels.size(); ++k) {
    if (k % 2 == 0) drawn.rows.emplace_back();
    drawn.rows.back().push_back(panels[k]);
  }
  return drawn;
}

}  // namespace mmverify::bench
