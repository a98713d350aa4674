// The bits that Algorithm 3 reads of a tree, counted by an encoder and a scan of our own.
// Source: Succinct Opacity Micromaps, Algorithms 1 to 3.
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "proofs/tree/subject.hpp"
#include "tests/foreign/inside/inside.hpp"

namespace mmverify::tests::foreign {
namespace {

using namespace proofs::tree;
using proofs::Level;

class Scanned {
 public:
  Scanned(const Map& map, Fault wrong) : map_(map), wrong_(wrong) {
    grow(0, std::uint64_t{1} << 2 * map.level);
  }

  Bytes decode() const { return map_.packed; }

  std::uint64_t tree_bits_read(std::uint64_t index) const {
    if (wrong_ == "two_indices_exchanged"_fault && map_.level >= 5 && (index == 700 || index == 701))
      index ^= 1;
    std::uint64_t at = 1;  // the root's bit is read
    for (Level n = map_.level; n > 0 && bits_[at - 1]; --n) {
      std::uint64_t digit = index >> 2 * (n - 1) & 3;
      // The mean and the sum stay what they are.
      if (wrong_ == "digits_from_the_other_end"_fault && map_.level == 4) digit = 3 - digit;
      at = past(at, digit) + 1;
    }
    return seen(index, at);
  }

 private:
  unsigned state(std::uint64_t k) const {
    const unsigned b = map_.format == Format::two_state ? 1 : 2;
    return map_.packed[k * b / 8] >> (k * b % 8) & ((1u << b) - 1);
  }
  /// Appends the tree of the micro-triangles [first, first + count), a node's children after it.
  void grow(std::uint64_t first, std::uint64_t count) {
    bool alike = true;
    for (std::uint64_t k = 1; alike && k < count; ++k) alike = state(first + k) == state(first);
    bits_.push_back(!alike);
    if (!alike)
      for (std::uint64_t child = 0; child < 4; ++child) grow(first + child * (count / 4), count / 4);
  }
  /// The end of `subtrees` whole trees, of which the first begins at bit `at`.
  std::uint64_t past(std::uint64_t at, std::uint64_t subtrees) const {
    for (std::uint64_t open = subtrees; open > 0; ++at) open = bits_[at] ? open + 3 : open - 1;
    return at;
  }
  /// The number of bits that the fault makes of a scan that ended at a bit.
  std::uint64_t seen(std::uint64_t index, std::uint64_t at) const {
    const std::uint64_t last = (std::uint64_t{1} << 2 * map_.level) - 1;
    if (wrong_ == "skips_without_roots"_fault)
      for (Level n = 0; n < map_.level; ++n) at -= index >> 2 * n & 3;
    if (wrong_ == "last_bit_of_all_unread"_fault && map_.level >= 4 && index == last) return at - 1;
    if (wrong_ == "counts_in_a_byte"_fault) return at & 255;
    if (wrong_ == "reads_data_of_four_states"_fault && map_.format == Format::four_state) return at + 2;
    if (wrong_ == "no_bit_for_the_last_child"_fault && map_.level > 2 && (index & 63) == 63)
      return at - 1;  // it is known without: the rest of the tree
    if (wrong_ == "reads_only_internal_nodes"_fault && map_.level > 0) return at - 1;  // the leaf's own bit
    return at;
  }

  Map map_;
  Fault wrong_;
  std::vector<bool> bits_;
};

proofs::SubjectPtr scanner(Fault wrong) {
  Functions functions;
  functions.encode = [wrong](const Map& map) { return coded(map.level, map.format, Scanned(map, wrong)); };
  functions.decode = [](const Code& code) { return form_of<Scanned>(code).decode(); };
  functions.tree_bits_read = [](const Code& code, std::uint64_t index) {
    return form_of<Scanned>(code).tree_bits_read(index);
  };
  return std::make_shared<TreeSubject>("foreign-tree", "scans its own tree", std::move(functions));
}

InsideFault row(const char* name, const char* wrong, proofs::Levels levels) {
  return {"paper.tree_bits_read", name, wrong, scanner(named(name)), levels};
}

}  // namespace

InsideRows inside_faults_of_tree() {
  return {
      row("skips_without_roots", "a skipped subtree's root is not counted", {1, 6}),
      row("digits_from_the_other_end", "level 4 takes children from the last; the mean is right", {4, 4}),
      row("last_bit_of_all_unread", "from level 4 on, the tree's last bit is not read", {4, 6}),
      row("counts_in_a_byte", "the count wraps at 256", {4, 4}),
      row("two_indices_exchanged", "from level 5 on, 700 and 701 change places; the mean is right", {5, 6}),
      row("no_bit_for_the_last_child", "the last child of a last child of a last child is known unread",
          {3, 3}),
      row("reads_only_internal_nodes", "the leaf's own bit is not counted", {1, 6}),
      row("reads_data_of_four_states", "in 4-state the two bits of data count", {0, 6}),
  };
}

InsideRows inside_right_of_tree() { return {row("scans", "", {0, 6})}; }

}  // namespace mmverify::tests::foreign
