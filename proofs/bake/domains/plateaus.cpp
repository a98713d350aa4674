#include "proofs/bake/domains/plateaus.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "proofs/bake/domains/draw_name.hpp"
#include "proofs/bake/domains/threshold.hpp"

namespace mmverify::proofs::bake {
namespace {

constexpr std::uint64_t plateau_stream = 0x706c6174;

/// A texel that differs from the plateau.
struct Odd {
  std::uint32_t i, j;
};

void draw_sides(Random& random, Case& one) {
  constexpr std::uint32_t least = 12, most = 64, texels = 1024;
  const auto up_to = [&](std::uint32_t side) {
    return static_cast<std::uint32_t>(random.between(least, std::min(most, side)));
  };
  one.width = up_to(most);
  one.height = up_to(texels / one.width);
  if (random.below(2) != 0) std::swap(one.width, one.height);
}

/// Fills the texture with the plateau, and some of it with other texels; returns the place of one of these.
Odd draw_texels(Random& random, Case& one, std::uint32_t at) {
  const auto step = random.below(4) == 0 ? random.between(-1, 1) : 0;
  const std::uint32_t plateau = step == 0 ? at : stepped(one.texel, at, static_cast<int>(step));
  const std::uint32_t others[] = {lowest(one.texel), highest(one.texel), stepped(one.texel, at, -1),
                                  stepped(one.texel, at, 1)};
  // Half of the textures differ by a texel below the cutoff.
  const std::uint32_t other =
      others[random.below(2) != 0 ? 2 * random.below(2) : random.below(std::size(others))];
  one.alpha.assign(std::size_t{one.width} * one.height, plateau);
  const auto any = [&] {
    return Odd{static_cast<std::uint32_t>(random.below(one.width)),
               static_cast<std::uint32_t>(random.below(one.height))};
  };
  const Odd p = any(), q = any();
  const auto fill = [&](auto differs) {
    for (std::uint32_t j = 0; j < one.height; ++j)
      for (std::uint32_t i = 0; i < one.width; ++i)
        if (differs(i, j)) one.alpha[i + std::size_t{one.width} * j] = other;
  };
  const auto [left, right] = std::minmax(p.i, q.i);
  const auto [top, bottom] = std::minmax(p.j, q.j);
  switch (random.below(4)) {
    case 0:  // texels that stand alone
      for (std::uint64_t k = 1 + random.below(6); k > 0; --k) {
        const Odd lone = any();
        one.alpha[lone.i + std::size_t{one.width} * lone.j] = others[random.below(std::size(others))];
      }
      one.alpha[p.i + std::size_t{one.width} * p.j] = other;
      break;
    case 1:  // a block
      fill([&, l = left, r = right, t = top, b = bottom](auto i, auto j) {
        return l <= i && i <= r && t <= j && j <= b;
      });
      break;
    case 2:  // rows
      fill([&, t = top, b = bottom](auto, auto j) { return t <= j && j <= std::min(b, t + 3); });
      return {p.i, top};
    default: {  // a half plane beside p
      const std::int64_t a = random.between(-3, 3), b = a == 0 ? 1 : random.between(-3, 3),
                         c = a * p.i + b * p.j;
      fill([&](std::int64_t i, std::int64_t j) { return a * i + b * j >= c; });
    }
  }
  return p;
}

/// A coordinate in texels, as binary32's coordinate of the texture: as it is, or at the nearest line, or a step beside it.
float beside_a_line(Random& random, double texels, std::uint32_t size) {
  const std::uint64_t kind = random.below(4);
  if (kind == 0) return static_cast<float>(texels / size);
  const auto line = static_cast<float>(std::nearbyint(2 * texels) / (2.0 * size));
  if (kind == 1) return line;
  return std::nextafter(line, (kind == 2 ? 1.0f : -1.0f) * std::numeric_limits<float>::infinity());
}

void place_triangle(Random& random, Case& one, Level n, const Odd& differs) {
  constexpr std::array<std::int64_t, 4> most_rows{40, 24, 16, 12};
  const std::int64_t side = std::int64_t{1} << n, most = most_rows[std::min<std::size_t>(n, 3)];
  const auto extent = [&] {
    return static_cast<double>(side * random.between(6, most)) * (random.below(2) != 0 ? 1 : -1);
  };
  const auto sixteenths = [&](std::int64_t size) {
    return static_cast<double>(random.between(0, 16 * size)) / 16;
  };
  // The first corner lies on the texel that differs, about it, or anywhere.
  const bool anywhere = random.below(4) == 0;
  const double x = anywhere ? sixteenths(one.width) : differs.i + sixteenths(1) + 0.25,
               y = anywhere ? sixteenths(one.height) : differs.j + sixteenths(1) + 0.25;
  const double across = extent(), down = extent(), lean_x = sixteenths(1), lean_y = sixteenths(1);
  const std::array<std::array<double, 2>, 3> corners{
      {{x, y}, {x + across * lean_x, y + down}, {x + across, y + down * lean_y}}};
  const std::size_t turn = random.below(3);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& corner = corners[(k + turn) % corners.size()];
    one.uv[2 * k] = beside_a_line(random, corner[0], one.width);
    one.uv[2 * k + 1] = beside_a_line(random, corner[1], one.height);
  }
}

}  // namespace

Case plateau_sample(std::uint64_t seed, Level n, std::uint64_t k) {
  Random random(seed, plateau_stream + n, k);
  Case one;
  draw_sides(random, one);
  one.texel = static_cast<Texel>(random.below(3));
  one.filter = random.below(16) == 0 ? Filter::nearest : Filter::bilinear;
  one.wrap_u = static_cast<Wrap>(random.below(5));
  one.wrap_v = static_cast<Wrap>(random.below(5));
  const auto factor = [&] { return static_cast<std::uint8_t>(random.below(2) * random.below(5)); };
  const std::uint8_t of_texture = factor();
  set_factors(one, of_texture, factor(), random);
  const std::uint32_t at = set_cutoff(one, static_cast<std::uint8_t>(random.below(cutoff_kinds)), random);
  const std::uint32_t borders[] = {lowest(one.texel), highest(one.texel), at};
  one.border = borders[random.below(std::size(borders))];
  place_triangle(random, one, n, draw_texels(random, one, at));
  one.drawn = fmt::format("{}{}-{}-{}", plateau_begins, seed, n, k);
  return one;
}

Case plateau_named(const std::string& name) { return case_named(name, plateau_begins, plateau_sample); }

const char* plateau_samples_text() {
  return "textures of 12 to 64 columns and rows of one alpha, at the cutoff or a step beside it, but for a "
         "few texels, a "
         "block, rows or a half plane; 8 and 16 bits and binary32, both filters, all addressing, MASK and "
         "BLEND, factors; "
         "micro-triangles of 4 to 40 rows, corners at lines of texels, an ulp beside them, or anywhere; up "
         "to 24 "
         "micro-triangles of each";
}

}  // namespace mmverify::proofs::bake
