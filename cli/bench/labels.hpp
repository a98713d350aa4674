// Places labels beside marks so that they do not overlap.
#pragma once

#include <string>
#include <vector>

#include "cli/bench/axes.hpp"

namespace mmverify::cli {

/// A placed label.
struct PlacedLabel {
  std::string text, colour;
  Box box;
  double mark_x, mark_y;  ///< pixels
  bool away = false;      ///< it had to move away: a thin line leads to the mark
};

/// The box of a label in pixels, for a font of 12.
Box label_box(const std::string& text, double left, double middle);

/// Places the labels of a panel clear of its marks, its lines, one another and the boxes `taken`.
std::vector<PlacedLabel> place_labels(const bench::picture::Panel& panel, const Axes& axes,
                                      std::vector<Box> taken);

}  // namespace mmverify::cli
