// The items as text: lines for a terminal, and pages in Markdown.
#pragma once

#include <string>
#include <vector>

#include "bench/papers/item.hpp"

namespace mmverify::bench::papers {

/// An item as lines for a terminal: its numbers beside ours, the reason, the commands.
std::string lines(const Paper& paper, const Item& item, Measured& measured);

/// The table of all items of a paper; `linked`: names of documents are links, as in docs/.
std::string table(const Paper& paper, Measured& measured, bool linked);

/// docs/PAPERS.md.
std::string index(Measured& measured);

/// A picture of a page, by its file's name.
struct PictureLink {
  std::string item, file, caption;
};

/// A paper's page: its table, then the tables and pictures of its items.
std::string page(const Paper& paper, Measured& measured, const std::vector<PictureLink>& pictures);

}  // namespace mmverify::bench::papers
