// The axes of a panel, and the places of values on them.
#pragma once

#include <vector>

#include "bench/picture.hpp"

namespace mmverify::cli {

/// A rectangle in the picture, in pixels from the upper left corner.
struct Box {
  double left, right, top, bottom;

  bool meets(const Box& b) const {
    return left < b.right && b.left < right && top < b.bottom && b.top < bottom;
  }
};

/// An axis: maps values to places between 0 and 1, and back.
struct Scale {
  double least, most;
  bool logarithmic;
  double none = 0;  ///< the place of value 0 on a logarithmic axis; 0 if the panel has no such point

  double place(double value) const;
  double value(double place) const;
};

/// A panel's frame and scales.
struct Axes {
  Box frame;
  Scale x, y;

  double pixel_x(double value) const { return frame.left + x.place(value) * (frame.right - frame.left); }
  double pixel_y(double value) const { return frame.bottom - y.place(value) * (frame.bottom - frame.top); }
};

/// Axes that contain all points of the panel and its thresholds. Logarithmic ones go from power of ten to
/// power of ten unless the panel sets other ends.
Axes axes_of(const bench::picture::Panel& panel, const Box& frame);

/// The panel's points at their drawn places. Points at 0 of a logarithmic axis get a line of their own, on
/// which marks that would cover one another are stacked.
bench::picture::Panel placed(bench::picture::Panel panel, const Axes& axes);

}  // namespace mmverify::cli
