#include "proofs/bake/cases/lone_texel.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "proofs/engine/random.hpp"

namespace mmverify::proofs::bake {
namespace {

constexpr std::uint64_t lone_stream = 0x6c6f6e65;

struct Sides {
  std::uint32_t width, height;
};
/// Shapes of 2^16 texels, around it, and up to 2^20.  Their number, 13, is odd, so that all shapes meet all four
/// kinds of texture.
constexpr std::array<Sides, 13> shapes{{{256, 256},
                                        {512, 128},
                                        {257, 255},
                                        {128, 512},
                                        {255, 257},
                                        {512, 512},
                                        {1000, 1000},
                                        {16384, 4},
                                        {4, 16384},
                                        {8192, 8},
                                        {4096, 16},
                                        {16, 4096},
                                        {1024, 1024}}};

/// The shape of one case, of level 3: more texels than binary32 counts.
constexpr Sides above_2_to_24{8192, 2049};
constexpr Level level_of_largest = 3;

/// The bits of alpha 1.
std::uint32_t full(Texel texel) {
  return texel == Texel::unorm8 ? 0xff : texel == Texel::unorm16 ? 0xffff : 0x3f800000;
}

/// The width of a block of columns in which bakers process a texture; the last columns may fill no block.
constexpr std::uint32_t block = 16;
/// A column or row moved into the incomplete last block, if there is one.
std::uint32_t after_the_last_block(std::uint32_t i, std::uint32_t side) {
  const std::uint32_t rest = side % block;
  return rest == 0 ? i : side - 1 - i % rest;
}

using Coordinates = std::array<float, 6>;

Coordinates somewhere(Random& random) {
  constexpr std::int64_t steps = 64;  // to a repeat
  for (;;) {
    Coordinates uv{};
    for (float& x : uv)
      x = static_cast<float>(random.between(-steps / 4, steps + steps / 4)) / static_cast<float>(steps);
    const float area = (uv[2] - uv[0]) * (uv[5] - uv[1]) - (uv[3] - uv[1]) * (uv[4] - uv[0]);
    if (std::fabs(area) > 0.5f) return uv;
  }
}

/// Moves a triangle to columns, or rows, whose numbers need more than 32 bits before they are clamped: sides of 4096
/// texels and more, and half a million repeats or more.
constexpr std::uint32_t long_side = 4096;
void move_far_away(Case& one, std::size_t axis, Random& random) {
  (axis == 0 ? one.wrap_u : one.wrap_v) = Wrap::clamp_to_edge;
  for (std::size_t k = axis; k < 6; k += 2) one.uv[k] = 0x1p+19f + static_cast<float>(random.below(16)) / 8;
}

void put(Case& one, const LoneTexel& texel) {
  one.alpha = texels(texel, one.width, one.height);
  one.drawn = text_of(texel);
}

}  // namespace

std::string text_of(const LoneTexel& texel) {
  return fmt::format("lone-{:x}-{:x}-{}-{}", texel.all, texel.lone, texel.i, texel.j);
}

LoneTexel lone_texel(const std::string& text) {
  LoneTexel texel;
  if (std::sscanf(text.c_str(), "lone-%x-%x-%u-%u", &texel.all, &texel.lone, &texel.i, &texel.j) != 4 ||
      text_of(texel) != text)
    throw BadCase(fmt::format("'{:.60}': write lone-ALL-TEXEL-COLUMN-ROW, alpha in hexadecimal", text));
  return texel;
}

std::vector<std::uint32_t> texels(const LoneTexel& texel, std::uint32_t width, std::uint32_t height) {
  std::vector<std::uint32_t> alpha(std::size_t{width} * height, texel.all);
  if (texel.i < width && texel.j < height) alpha[texel.i + std::size_t{texel.j} * width] = texel.lone;
  return alpha;
}

Case case_with_lone_texel(const Support& support, Level n, std::uint64_t k, std::uint64_t seed) {
  Random random(seed, lone_stream + n, k);
  Case one;
  const bool is_largest = n == level_of_largest && k == shapes.size();
  const Sides shape = is_largest ? above_2_to_24 : shapes[k % shapes.size()];
  one.width = shape.width;
  one.height = shape.height;
  one.texel = k % 2 == 0 || is_largest ? Texel::unorm8 : static_cast<Texel>(random.below(3));
  one.filter = k % 5 == 4 ? Filter::nearest : Filter::bilinear;
  one.wrap_u = k % 3 == 0 ? Wrap::clamp_to_edge : static_cast<Wrap>(random.below(5));
  one.wrap_v = k % 3 == 0 ? Wrap::clamp_to_edge : static_cast<Wrap>(random.below(5));

  const std::uint64_t kind = (k + n) % 4;
  const bool opaque = kind < 2, with_one = kind % 2 != 0 || is_largest;
  const std::uint64_t part = is_largest ? 1 : (k / 2 + n) % 3;
  one.uv = part == 0   ? Coordinates{0, 0, 1, 0, 0, 1}
           : part == 1 ? Coordinates{0, 0, 2, 0, 0, 2}
                       : somewhere(random);
  if (random.below(2) != 0) {
    std::swap(one.uv[2], one.uv[4]);
    std::swap(one.uv[3], one.uv[5]);
  }

  // Far away, clamping leads to the last texel.
  const bool far = std::max(one.width, one.height) >= long_side && !is_largest && random.below(2) != 0;
  const std::size_t far_axis = one.width > one.height ? 0 : 1;
  if (far) move_far_away(one, far_axis, random);

  LoneTexel texel;
  const auto draw = [&] {
    texel.all = opaque ? full(one.texel) : 0;
    texel.lone = opaque == with_one ? 0 : full(one.texel);
    texel.i = static_cast<std::uint32_t>(random.below(one.width));
    texel.j = static_cast<std::uint32_t>(random.below(one.height));
    if (one.width % block + one.height % block != 0 && k % 2 != 0) {
      texel.i = after_the_last_block(texel.i, one.width);
      texel.j = after_the_last_block(texel.j, one.height);
    }
    // Moves the texel into the half of the texture that the first triangle covers.
    if (std::uint64_t{texel.i} * one.height + std::uint64_t{texel.j} * one.width >=
        std::uint64_t{one.width} * one.height) {
      texel.i = one.width - 1 - texel.i;
      texel.j = one.height - 1 - texel.j;
    }
    if (is_largest)
      texel.i |= 1, texel.j = one.height - 1;  // the texel's number is odd, which binary32 cannot hold
    if (far) (far_axis == 0 ? texel.i : texel.j) = (far_axis == 0 ? one.width : one.height) - 1;
    one.border = texel.all;
    put(one, texel);
  };
  draw();
  const auto [width, height, stored] = std::tuple(one.width, one.height, one.texel);
  one = fitted(support, std::move(one), k);
  if (one.width != width || one.height != height || one.texel != stored) {
    draw();
    one = fitted(support, std::move(one), k);
  }
  return one;
}

}  // namespace mmverify::proofs::bake
