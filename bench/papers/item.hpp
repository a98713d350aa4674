// The items of the papers: each figure, table, algorithm, equation and numbered claim, with what is here.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/papers/measured.hpp"

namespace mmverify::bench::papers {

enum class Status : std::uint8_t {
  ok,        ///< it is here, and a number of ours lies within the paper's or is the same
  differs,   ///< it is here with other numbers or another reading; the item has the reason
  not_here,  ///< the item has the reason
};
const char* to_string(Status status);

/// Numbers of the paper, and ours.
struct Number {
  std::string what = {};
  std::vector<double> theirs = {};  ///< several stand for their range; none: the paper has a picture alone
  std::string unit = {};
  /// A number for each scene, or one.  Empty: nothing here can be measured.
  std::function<std::vector<double>(Measured&)> ours = {};
  std::string printed = {};  ///< the paper's numbers as text, if they are ranges
};

/// A table of a page, as texts.
struct Grid {
  std::vector<std::string> heading = {};
  std::vector<std::vector<std::string>> rows = {};
};

struct Item {
  std::string id = {};    ///< "figure 5"; for a claim its section and a letter, "6.2 b"
  std::string what = {};  ///< the item in a few words
  Status status = Status::ok;
  std::string show = {};  ///< commands without `mmverify`, between semicolons
  std::string why = {};   ///< the place of what is here, or the reason why it differs or is not here
  std::vector<Number> numbers = {};
  std::function<Grid(Measured&)> grid = {};  ///< of its page
  std::function<Grid(Measured&)> on_this_machine =
      {};  ///< times, of its page; no rows where none can be measured
};

struct Paper {
  std::string id = {}, title = {};
  std::vector<Item> items = {};
};

/// All papers, in the order of the documents.
const std::vector<Paper>& all();

/// The items of all parts of a paper, in order.
std::vector<Item> joined(const std::vector<std::vector<Item>>& parts);

std::vector<Item> succinct_micromaps();
std::vector<Item> compressed_maps();
std::vector<Item> attribute_micromaps();
std::vector<Item> khr_slides();
std::vector<Item> common_subtrees();

/// Ours over theirs.  Of a range: 1 within it, else over its nearest end.  Domain: theirs is not empty.
double ratio(const Number& number, double ours);

}  // namespace mmverify::bench::papers
