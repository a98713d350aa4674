// Labels beside marks, none upon another.
#pragma once

#include <string>
#include <vector>

#include "cli/bench/axes.hpp"

namespace mmverify::cli {

/// A label, and whether it had to move away from its mark.
struct PlacedLabel {
  std::string text, colour;
  Box box;
  double mark_x, mark_y;  ///< pixels
  bool away = false;      ///< a thin line leads to the mark
};

/// The pixels that a label takes, of a font of 12.
Box label_box(const std::string& text, double left, double middle);

/// The labels of a panel, off its marks and lines, one another and the boxes that are taken.
std::vector<PlacedLabel> place_labels(const bench::picture::Panel& panel, const Axes& axes,
                                      std::vector<Box> taken);

}  // namespace mmverify::cli
