// The corners of micro-triangles by their index: the inverse of the index function.
#include <set>
#include <string>

#include "delivery/vectors/binary32.hpp"
#include "delivery/vectors/builder.hpp"
#include "delivery/vectors/families/all.hpp"
#include "spec/index/index.hpp"

namespace mmverify::vectors::corners {
namespace {

using spec::Level;

std::vector<Column> corner_columns(std::vector<Column> first) {
  for (const char* corner : {"0", "1", "2"})
    for (const char* axis : {"i", "j"})
      first.push_back(
          {std::string(axis) + corner, Kind::number,
           "corner " + std::string(corner) + ", steps of 1/N along " + (*axis == 'i' ? "u" : "v")});
  return first;
}

void add_curve(Builder& out) {
  std::set<std::pair<Level, std::uint32_t>> seen;
  const auto add = [&](const char* about, Level n, std::uint32_t index) {
    if (!seen.emplace(n, index).second) return;
    const spec::index::Corners c = spec::index::corners(index, n);
    out.add({about, n, index, c[0].i, c[0].j, c[1].i, c[1].j, c[2].i, c[2].j});
  };
  for (Level n = 0; n <= 4; ++n)
    for (std::uint32_t index = 0; index < 1u << 2 * n; ++index) add("whole level", n, index);
  for (Level n = 5; n <= 16; ++n) {
    const auto last = static_cast<std::uint32_t>((std::uint64_t{1} << 2 * n) - 1);
    add("first", n, 0);
    add("last", n, last);
    add("digits 1 alone: each child turns the triangle", n, 0x55555555u & last);
    add("digits 2 alone", n, 0xaaaaaaaau & last);
    add("first digit 1: upside down", n, 1u << 2 * (n - 1));
    add("first digit 3: flipped", n, 3u << 2 * (n - 1));
    add("digits 1 and 3 in turn: every flip", n, 0x77777777u & last);
    add("digits 3 and 1 in turn: every flip", n, 0xddddddddu & last);
    add("digits 0, 1, 2, 3 in turn", n, 0x1b1b1b1bu & last);
    Mixed mixed(n);
    for (unsigned k = 0; k < 6; ++k) add("anywhere", n, (mixed.bits(16) << 16 | mixed.bits(16)) & last);
  }
}

void add_rows(Builder& out) {
  std::set<std::uint32_t> seen;
  const auto add = [&](const char* about, std::uint64_t index) {
    const auto x = static_cast<std::uint32_t>(index);
    if (!seen.insert(x).second) return;
    const spec::index::Corners c = spec::index::w_minor_corners(x);
    out.add({about, x, c[0].i, c[0].j, c[1].i, c[1].j, c[2].i, c[2].j});
  };
  for (std::uint32_t index = 0; index < 256; ++index) add("first rows", index);
  for (const std::uint64_t row :
       {32ull, 255ull, 256ull, 2047ull, 4096ull, 4097ull, 5000ull, 32768ull, 46341ull, 65535ull}) {
    const char* of_root = row > 4096 ? "row's end: a binary32 root may be off by one" : "row's end";
    add(of_root, row * row - 2);
    add(of_root, row * row - 1);
    add("row's begin", row * row);
    add("row's begin", row * row + 1);
    add("middle of a row", row * row + row);
  }
  add("last of level 16", 0xffffffffu);
}

}  // namespace

Family family() {
  Builder out("corners", 1, "the three corners of a micro-triangle, by its index");
  out.table("curve",
            "On the curve of the Vulkan specification; corners of children 0, 2 and 3, in this order.",
            corner_columns({{"about", Kind::about, "why the vector is there"},
                            {"level", Kind::number, "n; N = 2^n"},
                            {"index", Kind::number, "below 4^n"}}));
  add_curve(out);
  out.table("rows", "In row order, in the order v0, v1, v2 of figure 4; the level does not enter.",
            corner_columns({{"about", Kind::about, "why the vector is there"},
                            {"index", Kind::number, "of row order"}}));
  add_rows(out);
  return out.take();
}

}  // namespace mmverify::vectors::corners
