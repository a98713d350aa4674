#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "bench/vq/encoders.hpp"
#include "bench/vq/tables.hpp"

namespace mmverify::bench {
namespace {

using namespace picture;

struct SavingsLine {
  const char* name;
  const char* colour;
  Shape shape;
  std::function<double(const VqRow&)> savings;
};

/// A panel of savings in per cent, the maps in ascending order of the first line.
Panel savings_panel(const std::string& title, std::vector<VqRow> rows,
                    const std::vector<SavingsLine>& lines) {
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const VqRow& a, const VqRow& b) { return lines[0].savings(a) < lines[0].savings(b); });
  Panel panel{.title = title,
              .x = {.title = "maps, in order of the source",
                    .least = 0.5,
                    .most = static_cast<double>(rows.size()) + 0.5},
              .y = {.title = "savings, %", .least = 0, .most = 100},
              .key = Key::top_left};
  for (const SavingsLine& line : lines) {
    Series series{.name = line.name, .colour = line.colour, .shape = line.shape};
    for (std::size_t k = 0; k < rows.size(); ++k)
      series.points.push_back({static_cast<double>(k + 1), per_cent * line.savings(rows[k])});
    panel.series.push_back(series);
  }
  return panel;
}

template <class Encoder>
Series mark(const std::vector<VqRow>& rows, const std::string& codec, Encoder e, const char* colour) {
  const double lost = sum_over(rows, [e](const VqRow& r) { return r.by(e).substitutions; });
  const double states = sum_over(rows, [e](const VqRow& r) { return states_of(r, e); });
  const auto mean = [&](double VqEncoded::*ms) {
    return mean_over(rows, [e, ms](const VqRow& r) { return r.by(e).*ms; });
  };
  return {.colour = colour,
          .joined = false,
          .points = {{mean(&VqEncoded::ms), per_cent_of(lost, states), codec + " " + to_string(e),
                      Range{mean(&VqEncoded::least_ms), mean(&VqEncoded::most_ms)}}}};
}

/// A panel of the share of O and T that is lost, over the time of a map.
Panel error_against_time(const std::vector<VqRow>& rows) {
  const double least = sum_over(rows, [](const VqRow& r) { return r.least; });
  const double states = sum_over(rows, [](const VqRow& r) { return r.states_32; });
  Panel panel{.title = "O and T lost, against the time of a map",
              .x = {.title = "ms a map, one thread", .logarithmic = true},
              .y = {.title = "lost, % of O and T", .least = 0},
              .thresholds = {{per_cent_of(least, states), "no block of VQ4 loses less"}}};
  for (const Vq2Encoder e : all_vq2)
    panel.series.push_back(mark(rows, "VQ2", e, e == Vq2Encoder::optimal ? green : vermilion));
  for (const Vq4Encoder e : all_vq4)
    panel.series.push_back(mark(rows, "VQ4", e,
                                e == Vq4Encoder::paper || e == Vq4Encoder::paper_free_c ? vermilion
                                : e == Vq4Encoder::proved                               ? purple
                                                                                        : blue));
  return panel;
}

}  // namespace

std::vector<Panel> vq_savings_panels(const std::vector<VqRow>& rows) {
  using R = VqRow;
  const Panel vq2 = savings_panel(
      "VQ2: 16x16 regions in 256 bits", rows,
      {{"source", grey, Shape::disc, [](const R& r) { return r.savings_16; }},
       {"VQ2 optimal", green, Shape::square, [](const R& r) { return r.savings(Vq2Encoder::optimal); }},
       {"Algorithm 1", vermilion, Shape::triangle, [](const R& r) { return r.savings(Vq2Encoder::paper); }},
       {"two of 64 sub-triangles, 2 bits each", blue, Shape::diamond,
        [](const R& r) { return r.savings_64x2; }}});
  const Panel vq4 = savings_panel(
      "VQ4: 32x32 regions in 512 bits", rows,
      {{"source", grey, Shape::disc, [](const R& r) { return r.savings_32; }},
       {"VQ4 balanced", green, Shape::square, [](const R& r) { return r.savings(Vq4Encoder::balanced); }},
       {"Algorithm 2", vermilion, Shape::triangle, [](const R& r) { return r.savings(Vq4Encoder::paper); }},
       {"16x16, 2 bits each", blue, Shape::diamond, [](const R& r) { return r.savings_16; }}});
  const Panel sources =
      savings_panel("Sources: resolution", rows,
                    {{"32x32", green, Shape::square, [](const R& r) { return r.savings_32; }},
                     {"16x16", blue, Shape::diamond, [](const R& r) { return r.savings_16; }},
                     {"8x8", vermilion, Shape::triangle, [](const R& r) { return r.savings_8; }}});
  return {vq2, vq4, sources};
}

Picture vq_picture(const VqFigures& figures) {
  const std::vector<Panel> panels = vq_savings_panels(figures.rows);
  return {.width = 1200,
          .height = 960,
          .rows = {{panels[0], panels[1]}, {panels[2], error_against_time(figures.rows)}}};
}

}  // namespace mmverify::bench
