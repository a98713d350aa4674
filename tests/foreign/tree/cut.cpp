// A code's tree, cut into nodes.
#include "tests/foreign/tree/cut.hpp"

namespace mmverify::tests::foreign::tree {

bool cut(Tree& tree, std::size_t code_size) {
  std::vector<std::uint32_t> open;  // how many children of each node on the path are still to come
  std::vector<std::uint32_t> path;
  std::size_t t = 0;
  for (;;) {
    if (t >= 8 * code_size) return false;
    tree.end.push_back(0);
    tree.before.push_back(static_cast<std::uint32_t>(tree.leaves));
    if (tree.is_internal(t)) {
      bool too_deep = path.size() >= tree.level;
      if (has(decode_takes_deeper_trees) && tree.level >= 3 && path.size() == tree.level) too_deep = false;
      if (too_deep) return false;
      path.push_back(static_cast<std::uint32_t>(t));
      open.push_back(4);
      ++t;
      continue;
    }
    ++tree.leaves;
    ++t;
    tree.end[t - 1] = static_cast<std::uint32_t>(t);
    while (!open.empty() && --open.back() == 0) {
      tree.end[path.back()] = static_cast<std::uint32_t>(t);
      path.pop_back();
      open.pop_back();
    }
    if (open.empty()) break;
  }
  tree.size = t;
  tree.data = data_begins(tree.size, tree.level);
  return true;
}

}  // namespace mmverify::tests::foreign::tree
