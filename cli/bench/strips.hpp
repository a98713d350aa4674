// Formats a table as columns of text.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "bench/table.hpp"

namespace mmverify::cli {

/// A printed column with its cells, a line each.
struct Strip {
  std::string group, heading, unit;
  bool leads = false, left = false;
  std::vector<std::string> cells = {};

  std::size_t width() const {
    std::size_t width = std::max(heading.size(), unit.size());
    for (const std::string& cell : cells) width = std::max(width, cell.size());
    return width;
  }
};

/// A value in print.
std::string text_of(const bench::Column& column, const bench::Value& value);

/// The column's unit in print.
std::string printed_unit(const bench::Column& column);

/// The printed columns of a table, those of a group next to one another. Inner tables become lines below one
/// another, or columns side by side under the names of their rows.
std::vector<Strip> strips_of(const bench::Table& table);

}  // namespace mmverify::cli
