#include "impl/bake/touched.hpp"

#include <algorithm>

#include "impl/bake/plane/points.hpp"

namespace mmverify::impl::bake::detail {
namespace {

constexpr std::uint32_t leaf_height = 2;

UvBox box_of(const Triangle& p) {
  const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
  return {left, right, top, bottom};
}

class Walk {
 public:
  explicit Walk(const std::function<bool(const UvBox&)>& touched) : touched_(touched) {}

  void node(const Triangle& p, Node n) {
    if (!touched_(box_of(p))) return;
    if (n.height <= leaf_height) {
      nodes.push_back(n);
      return;
    }
    const std::size_t before = nodes.size();
    const std::uint32_t height = n.height - 1, child = std::uint32_t{1} << (2 * height);
    std::uint32_t index = n.index;
    for (const Triangle& q : children(p)) {
      node(q, {index, height});
      index += child;
    }
    const auto is_child = [height](const Node& one) { return one.height == height; };
    if (nodes.size() != before + 4 || !std::all_of(nodes.end() - 4, nodes.end(), is_child)) return;
    nodes.resize(before);
    nodes.push_back(n);
  }

  std::vector<Node> nodes;

 private:
  const std::function<bool(const UvBox&)>& touched_;
};

}  // namespace

std::vector<Node> touched_nodes(const BaseTriangle& uv, std::uint32_t level,
                                const std::function<bool(const UvBox&)>& touched) {
  Triangle p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = {double{uv[k].u}, double{uv[k].v}};
  Walk walk(touched);
  walk.node(p, {0, level});
  return std::move(walk.nodes);
}

}  // namespace mmverify::impl::bake::detail
