#include "bench/stiff/tables.hpp"

namespace mmverify::bench {
namespace {

using namespace picture;

bool has(const StiffFigure& f, const char* word) { return f.method.find(word) != std::string::npos; }

/// The colour is the arithmetic's, the shape sets methods of one colour apart.
Series look_of_stiff(const StiffFigure& f) {
  Series series{.name = f.method, .colour = vermilion, .joined = false};
  if (f.is_ours) series.colour = green;
  if (has(f, "64")) series.colour = blue;
  if (has(f, "sample")) series.colour = orange;
  if (has(f, "rational")) series.colour = purple;
  if (has(f, "step") || has(f, "corner") || has(f, "equations")) series.shape = Shape::triangle;
  if (has(f, "batched") || has(f, "faces") || has(f, "16")) series.shape = Shape::square;
  if (has(f, "pattern")) series.shape = Shape::diamond;
  return series;
}

/// A line from a method's figures on ordinary inputs, an open circle, to those on stiff ones.
void add_method(const StiffFigure& f, Panel& panel) {
  const Point ordinary{f.ns / f.ratio, f.ordinary_share()},
      stiff{f.ns, f.share(), "",
            f.least_ns && f.most_ns ? std::optional(Range{*f.least_ns, *f.most_ns}) : std::nullopt};
  Series marks = look_of_stiff(f);
  panel.series.push_back({.colour = marks.colour, .marks = false, .points = {ordinary, {f.ns, f.share()}}});
  panel.series.push_back(
      {.colour = marks.colour, .shape = Shape::circle, .joined = false, .points = {ordinary}});
  marks.points = {stiff};
  panel.series.push_back(marks);
}

}  // namespace

Picture stiff_picture(const std::vector<StiffFigure>& figures) {
  constexpr int row_height = 250;
  std::vector<Panel> panels;
  for (const StiffFigure& f : figures) {
    if (panels.empty() || panels.back().title != f.kind)
      panels.push_back({.title = f.kind,
                        .x = {.title = "ns an answer", .logarithmic = true},
                        .y = {.title = "share wrong", .logarithmic = true, .most = 2},
                        .key = Key::outside});
    add_method(f, panels.back());
  }
  Picture drawn{.width = 1300,
                .height = row_height * static_cast<int>((panels.size() + 1) / 2),
                .note = "open circles: ordinary inputs; filled marks: stiff ones"};
  for (std::size_t k = 0; k < panels.size(); ++k) {
    if (k % 2 == 0) drawn.rows.emplace_back();
    drawn.rows.back().push_back(panels[k]);
  }
  return drawn;
}

}  // namespace mmverify::bench
