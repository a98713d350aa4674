#include "bench/tree/cache.hpp"

#include <bit>
#include <cstring>
#include <set>

#include "impl/tree/layout.hpp"

namespace mmverify::bench {

using impl::tree::Level;
using impl::tree::Stream;
using impl::tree::Tree;

StreamReads stream_reads(Level n, const Stream& s, std::uint64_t index) {
  const auto internal = [&s](std::uint64_t t) { return (s.tree[t / 8] >> (t % 8) & 1) != 0; };
  std::uint64_t t = 0;
  for (std::uint32_t shift = 2 * n; internal(t);) {
    shift -= 2;
    ++t;
    for (std::uint64_t left = index >> shift & 3; left > 0; --left, ++t) {
      if (internal(t)) left += 4;
    }
  }
  // The lookup reads all bits up to t, and then one state.
  const auto tree_lines = static_cast<std::size_t>(t / 512 + 1);
  return {t + 1, tree_lines + 1};
}

std::size_t tree_lines(const Tree& tree, std::uint64_t index) {
  const std::uint8_t* const memory = tree.memory();
  const auto word = [memory](std::uint64_t at) {
    std::uint64_t w;
    std::memcpy(&w, memory + at / 8, sizeof w);
    return w;
  };
  const auto layout = impl::tree::detail::Layout::of(memory);
  std::set<std::uint64_t> lines{0};
  std::uint32_t shift = layout.below_top;
  std::uint64_t p = index >> shift;
  while (true) {
    const std::uint64_t in_word = layout.word_of(p), node = p - in_word * layout.per_word();
    lines.insert((layout.nodes_at + 8 * in_word) / 64);
    const std::uint64_t flags = word(8 * layout.nodes_at + 64 * in_word);
    const std::uint64_t ones =
        (flags >> layout.per_word()) +
        static_cast<std::uint64_t>(std::popcount(flags & ((std::uint64_t{1} << node) - 1)));
    if ((flags >> node & 1) == 0) {
      lines.insert((layout.leaves_at() + (p - ones) * layout.b) / 512);
      return lines.size();
    }
    if (shift == layout.in_block) {
      const std::uint64_t inside = index & ((std::uint64_t{1} << shift) - 1);
      const std::uint64_t place = ((ones - layout.parents) << shift) + inside;
      lines.insert((8 * layout.blocks_at() + place * layout.b) / 512);
      return lines.size();
    }
    shift -= 2;
    p = layout.first_children() + 4 * ones + (index >> shift & 3);
  }
}

}  // namespace mmverify::bench
