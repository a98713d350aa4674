#include "bench/papers/item.hpp"

#include <algorithm>

namespace mmverify::bench::papers {

const char* to_string(Status status) {
  switch (status) {
    case Status::ok: return "ok";
    case Status::differs: return "differs";
    case Status::not_here: break;
  }
  return "not here";
}

const std::vector<Paper>& all() {
  static const std::vector<Paper> papers{
      {"som", "Succinct Opacity Micromaps (2024)", succinct_micromaps()},
      {"com", "Compressed Opacity Maps for Ray Tracing (2023)", compressed_maps()},
      {"cam", "Color and Attribute Micromaps (2025)", attribute_micromaps()},
      {"khr", "Vulkan's Opacity Micromaps (slides, 2026)", khr_slides()},
      {"csm", "Common Subtree Merging Compressed Opacity Micromaps (2026; its abstract alone was read)",
       common_subtrees()}};
  return papers;
}

std::vector<Item> joined(const std::vector<std::vector<Item>>& parts) {
  std::vector<Item> all;
  for (const std::vector<Item>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

double ratio(const Number& number, double ours) {
  const auto [least, most] = std::minmax_element(number.theirs.begin(), number.theirs.end());
  return ours < *least ? ours / *least : ours > *most ? ours / *most : 1;
}

}  // namespace mmverify::bench::papers
