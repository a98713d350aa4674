#include "impl/tree/tree.hpp"

#include <algorithm>
#include <stdexcept>

#include "impl/index/index.hpp"
#include "impl/tree/form.hpp"
#include "impl/tree/layout.hpp"
#include "impl/tree/lookup.hpp"
#include "impl/tree/pyramid.hpp"

namespace mmverify::impl::tree {

using detail::Layout;

Tree Tree::encode(Level n, Format b, std::span<const std::uint8_t> map) {
  detail::require_map(n, b, map.size());
  return Tree(detail::encode_form(n, b, map, {}));
}

Tree Tree::encode(Level n, Format b, std::span<const std::uint8_t> map, Depths depths) {
  detail::require_map(n, b, map.size());
  if (depths.top > depths.block || depths.block >= std::max<Level>(n, 1))
    throw std::invalid_argument("tree: no such depths");
  return Tree(detail::encode_form(n, b, map, depths));
}

std::uint8_t Tree::operator[](std::uint64_t index) const noexcept {
  return detail::find(memory_.get(), index);
}

void Tree::lookup(std::span<const std::uint32_t> index, std::span<std::uint8_t> state) const {
  if (index.size() != state.size()) throw std::invalid_argument("tree: index and state differ in length");
  detail::find_each(memory_.get(), index.data(), state.data(), index.size());
}

std::uint8_t Tree::at(float u, float v) const noexcept {
  return (*this)[index::from_barycentrics(u, v, level())];
}

void Tree::decode(std::span<std::uint8_t> map) const {
  detail::require_map(level(), format(), map.size());
  detail::decode_form(memory_.get(), map);
}

std::uint64_t Tree::bits() const noexcept { return 8 * Layout::of(memory_.get()).size(); }

Level Tree::level() const noexcept { return Layout::of(memory_.get()).level(); }

Format Tree::format() const noexcept {
  return Layout::of(memory_.get()).b == 1 ? Format::two_state : Format::four_state;
}

void lookup(std::span<const Tree* const> trees, std::span<const std::uint32_t> which,
            std::span<const std::uint32_t> index, std::span<std::uint8_t> state) {
  if (which.size() != state.size() || index.size() != state.size())
    throw std::invalid_argument("tree: which, index and state differ in length");
  std::uint32_t greatest = 0;
  for (const std::uint32_t tree : which) greatest = std::max(greatest, tree);
  if (!which.empty() && greatest >= trees.size())
    throw std::invalid_argument("tree: which names a tree beyond the last");
  detail::find_in_many(trees.data(), which.data(), index.data(), state.data(), state.size());
}

}  // namespace mmverify::impl::tree
