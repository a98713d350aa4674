// Where a panel's axes are, and where a value is between them.
#pragma once

#include <vector>

#include "bench/picture.hpp"

namespace mmverify::cli {

/// A rectangle of the picture in pixels, from its upper left corner.
struct Box {
  double left, right, top, bottom;

  bool meets(const Box& b) const {
    return left < b.right && b.left < right && top < b.bottom && b.top < bottom;
  }
};

/// One axis: from a value to a place between 0 and 1, and back.
struct Scale {
  double least, most;
  bool logarithmic;
  double none = 0;  ///< where a logarithmic axis shows points at 0; 0: it has none

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

/// Scales that hold all points of the panel and its thresholds; logarithmic ones from power of ten to power of ten
/// where nothing else is asked for.
Axes axes_of(const bench::picture::Panel& panel, const Box& frame);

/// The panel's points where they are drawn: those at 0 of a logarithmic axis on a line of their own, where marks that
/// would hide one another are stacked.
bench::picture::Panel placed(bench::picture::Panel panel, const Axes& axes);

}  // namespace mmverify::cli
