// Blocks of square opacity maps, the states that they encode, and the parts of a block.

#include "delivery/vectors/binary32.hpp"
#include "delivery/vectors/builder.hpp"
#include "delivery/vectors/families/all.hpp"
#include "spec/vq/block.hpp"

namespace mmverify::vectors::vq {
namespace {

using namespace spec::vq;

const Column why{"about", Kind::about, "why the vector is there"};

template <class States>
Bytes digits(const States& states) {
  Bytes all;
  for (const State s : states) all.push_back(static_cast<std::uint8_t>(s));
  return all;
}

/// Fills the codebook with different entries: no two parts are alike under any transform.
void fill(Vq2& block) {
  for (std::uint8_t k = 0; k < 3; ++k) block.shared[k] = static_cast<std::uint8_t>(1 + 5 * k);
  for (std::uint8_t q = 0; q < 4; ++q)
    block.own[q] = {static_cast<std::uint8_t>(16 + 3 * q), static_cast<std::uint8_t>(2 + 7 * q)};
}
void fill(Vq4& block) {
  for (std::uint32_t index = 3; index < 16; ++index)
    block.codebook[index - 3] = 0x3a6c1u * index & ((1u << bits_of(Vq4::code_of(index))) - 1);
}

template <class Block>
void add_blocks(Builder& out) {
  const auto add = [&](const char* about, const Block& block) {
    const BlockBytes<Block> all = bytes(block);
    out.add({about, Bytes(all.begin(), all.end()), digits(decode(block))});
  };
  const auto filled = [](auto index_of) {
    Block block;
    fill(block);
    for (std::uint32_t k = 0; k < 64; ++k) block.indices[k] = static_cast<std::uint8_t>(index_of(k));
    return block;
  };
  constexpr std::uint32_t last = (1u << Block::index_bits) - 1;
  add("zeros: all is transparent", Block{});
  add("uniform vectors: the indices 0, 1 and 2", filled([](std::uint32_t k) { return k % 3; }));
  add("each index in turn", filled([](std::uint32_t k) { return k & last; }));
  add("one vector apart: the first", filled([](std::uint32_t k) { return k == 0 ? last : 0; }));
  add("one vector apart: the last", filled([](std::uint32_t k) { return k == 63 ? last : 2; }));
  for (std::uint32_t t = 0; t < 8; ++t) {
    Block block = filled([](std::uint32_t k) { return 3 + k % (last - 2); });
    for (std::uint32_t q = 1; q < 4; ++q) block.transforms[q] = Transform::of((t + 3 * (q - 1)) % 8);
    add("transforms: each number in each quadrant that has one", block);
  }
  BlockBytes<Block> any{};
  any.fill(0xff);
  add("ones: every bit set", from_bytes<Block>(any));
  Mixed mixed(Block::bits);
  for (unsigned k = 0; k < 6; ++k) {
    for (std::uint8_t& byte : any) byte = static_cast<std::uint8_t>(mixed.bits(8));
    add("any bits: every block is one", from_bytes<Block>(any));
  }
}

template <std::size_t side>
void add_transforms(Builder& out) {
  for (std::uint32_t t = 0; t < 8; ++t)
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t x = 0; x < side; ++x) {
        const Region to = moved<side>(Transform::of(t), {x, y});
        out.add({"each region under each transform", static_cast<std::uint32_t>(side), t, x, y, to.x, to.y});
      }
}

void add_codes(Builder& out) {
  for (std::uint32_t code = 0; code < 32; ++code)
    out.add({"each code of a 2x2 vector", 0u, code, digits(decode_mini(code))});
  for (const Code4 how : {Code4::simple, Code4::vertical, Code4::horizontal, Code4::generic}) {
    const std::uint32_t bits = bits_of(how), row = 1 + static_cast<std::uint32_t>(how);
    const auto add = [&](const char* about, std::uint32_t code) {
      out.add({about, row, code, digits(decode_vector(how, code))});
    };
    for (std::uint32_t k = 0; k < bits; ++k) add("one bit set", 1u << k);
    add("every bit set", (1u << bits) - 1);
    Mixed mixed(row);
    for (unsigned k = 0; k < 4; ++k) add("any bits", mixed.bits(bits));
  }
}

template <std::size_t side>
void add_hits(Builder& out) {
  constexpr unsigned bits = side == 16 ? 4 : 5;
  const auto add = [&](const char* about, std::uint32_t u, std::uint32_t v) {
    const Rational x = exactly(u), y = exactly(v);
    if (x + y > 1) return;
    for (const Half half : {Half::lower, Half::upper}) {
      const Region r = region_of<side>(half, x, y);
      out.add({about, static_cast<std::uint32_t>(side), static_cast<std::uint32_t>(half), u, v, r.x, r.y});
    }
  };
  const auto add_beside = [&](std::uint32_t u, std::uint32_t v) {
    add("on a border of regions", u, v);
    for (const int d : {-1, 1}) {
      if (u != 0) add("one float from a border", stepped(u, d), v);
      if (v != 0) add("one float from a border", u, stepped(v, d));
    }
  };
  const std::uint32_t one = bits_of(1);
  add("a corner", 0, 0);
  add("a corner", one, 0);
  add("a corner", 0, one);
  add("a hair from a far edge", one - 1, 0);
  add("a hair from a near edge", 1, one - 1);
  for (std::uint32_t k = 1; k < side; k += 3) {
    add_beside(dyadic(k, bits), dyadic(1, bits + 1));
    add_beside(dyadic(1, bits + 1), dyadic(k, bits));
    add("on the edge that both triangles share", dyadic(2 * k + 1, bits + 1),
        dyadic(2 * static_cast<std::uint32_t>(side) - 2 * k - 1, bits + 1));
  }
  Mixed mixed(side);
  for (unsigned k = 0; k < 8; ++k) {
    // Two statements: the order in which a call evaluates its arguments is unspecified.
    const auto v = dyadic(mixed.bits(23), 24);
    add("anywhere", dyadic(mixed.bits(23), 24), v);
  }
}

}  // namespace

Family family() {
  Builder out("vq", 1, "square maps of a pair of triangles in blocks; x from the left, y from the bottom");
  const std::vector<Column> blocks{
      why,
      {"bytes", Kind::bytes, "the block"},
      {"map", Kind::digits, "regions row by row from the bottom: T 0, C 1, O 2"}};
  out.table("vq2", "Blocks of 256 bits, 16x16 regions.", blocks);
  add_blocks<Vq2>(out);
  out.table("vq4", "Blocks of 512 bits, 32x32 regions.", blocks);
  add_blocks<Vq4>(out);
  out.table("transforms", "Where a transform takes a region of a vector.",
            {why,
             {"side", Kind::number, "regions along a side of the vector"},
             {"number", Kind::number, "4 reflect left and right, 2 top and bottom, 1 rotate first"},
             {"x", Kind::number, "the region"},
             {"y", Kind::number, "the region"},
             {"to_x", Kind::number, "where it goes"},
             {"to_y", Kind::number, "where it goes"}});
  add_transforms<2>(out);
  add_transforms<4>(out);
  out.table(
      "codes", "Code words of vectors.",
      {why,
       {"how", Kind::name, "how it is written", {"mini", "simple", "vertical", "horizontal", "generic"}},
       {"code", Kind::number, "its 5, 17, 18, 18 or 20 bits"},
       {"vector", Kind::digits, "its regions row by row: T 0, C 1, O 2"}});
  add_codes(out);
  out.table("hits", "The region that a hit falls in.",
            {why,
             {"side", Kind::number, "regions along a side of the map"},
             {"half", Kind::name, "which triangle of the pair", {"lower", "upper"}},
             {"u", Kind::binary32, "barycentric of the second vertex"},
             {"v", Kind::binary32, "barycentric of the third vertex"},
             {"x", Kind::number, "the region"},
             {"y", Kind::number, "the region"}});
  add_hits<16>(out);
  add_hits<32>(out);
  return out.take();
}

}  // namespace mmverify::vectors::vq
