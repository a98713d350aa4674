// A picture of figures: panels of series, as plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mmverify::bench::picture {

/// Okabe and Ito's colours, safe for the colour-blind.
inline constexpr char grey[] = "#888888", orange[] = "#E69F00", vermilion[] = "#D55E00", blue[] = "#0072B2",
                      green[] = "#009E73", purple[] = "#AA4488";

enum class Shape : std::uint8_t { disc, circle, square, open_square, triangle, triangle_down, diamond };

/// The least and the most of repeats.
struct Range {
  double least, most;
};

struct Point {
  double x, y;
  std::string label = {};             ///< beside the mark, apart from the other marks and labels of the panel
  std::optional<Range> repeats = {};  ///< of x: an error bar
};

struct Series {
  std::string name = {};  ///< in the key; empty: not in it
  std::string colour = {};
  Shape shape = Shape::disc;
  bool marks = true, joined = true;
  std::vector<Point> points = {};
};

/// A logarithmic axis has no 0: points there lie on a line of their own, its tick "none", below all others.
struct Axis {
  std::string title = {};
  bool logarithmic = false;
  std::optional<double> least = {}, most = {};  ///< from the points if not given
  bool whole = false;                           ///< a tick at each whole number
};

/// A dashed line across the panel.
struct Threshold {
  double y;
  std::string label;
};

enum class Key : std::uint8_t { none, top_left, top_right, outside, below_all };

struct Panel {
  std::string title = {};
  Axis x = {}, y = {};
  std::vector<Series> series = {};
  Key key = Key::none;  ///< below_all: one key for the whole picture
  std::vector<Threshold> thresholds = {};
  std::string note = {};  ///< in the lower right corner
};

struct Picture {
  int width, height;                          ///< pixels
  std::vector<std::vector<Panel>> rows = {};  ///< from the top; panels of a row share its width
  std::string note = {};                      ///< below all
};

}  // namespace mmverify::bench::picture
