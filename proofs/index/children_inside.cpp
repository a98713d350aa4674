#include "proofs/index/children_inside.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

#include "proofs/index/known_orders.hpp"

namespace mmverify::proofs::index {
namespace {

constexpr std::uint32_t unasked = 4;

/// A node of the curve: the digits on the way to it, the highest first.
using Node = std::vector<std::uint32_t>;
using ChildrenOf = std::map<Node, Permutation>;

/// The permutation at each node; nothing if a micro-triangle's digit does not follow from its digits on the curve.
std::optional<ChildrenOf> children_of_nodes(Level n, std::span<const Renumbered> all) {
  ChildrenOf nodes;
  for (const Renumbered& one : all) {
    if (one.got >= triangle_count(n)) return std::nullopt;
    Node node;
    for (Level depth = 0; depth < n; ++depth) {
      const Level shift = 2 * (n - 1 - depth);
      const std::uint32_t child = one.right >> shift & 3, got = one.got >> shift & 3;
      std::uint32_t& to =
          nodes.try_emplace(node, Permutation{unasked, unasked, unasked, unasked}).first->second[child];
      if (to == unasked) to = got;
      if (to != got) return std::nullopt;
      node.push_back(child);
    }
  }
  for (auto [node, p] : nodes) {
    std::sort(p.begin(), p.end());
    if (p != identity) return std::nullopt;
  }
  return nodes;
}

/// The permutation of the nodes that a rule selects, if all others keep their order.
std::optional<Permutation> permuted_where(const ChildrenOf& nodes,
                                          const std::function<bool(const Node&)>& is_meant) {
  std::optional<Permutation> found;
  for (const auto& [node, p] : nodes) {
    if (!is_meant(node)) {
      if (p != identity) return std::nullopt;
      continue;
    }
    if (found && *found != p) return std::nullopt;
    found = p;
  }
  return found && *found != identity ? found : std::nullopt;
}

}  // namespace

std::string name_children_inside(Level n, std::span<const Renumbered> all) {
  const auto nodes = children_of_nodes(n, all);
  if (!nodes) return {};
  for (std::uint32_t child = 0; child < 4; ++child) {
    const auto times = [child](const Node& node) { return std::count(node.begin(), node.end(), child); };
    const std::pair<const char*, std::function<bool(const Node&)>> rules[] = {
        {"inside each child", [&](const Node& node) { return times(node) != 0; }},
        {"directly inside each child",
         [&](const Node& node) { return !node.empty() && node.back() == child; }},
        {"inside an odd number of children", [&](const Node& node) { return times(node) % 2 == 1; }},
    };
    for (const auto& [words, is_meant] : rules)
      if (const auto p = permuted_where(*nodes, is_meant))
        return fmt::format("{} {} {}{}", text_of_children(*p), words, child,
                           child == 1 ? ", the middle triangle" : "");
  }
  return {};
}

}  // namespace mmverify::proofs::index
