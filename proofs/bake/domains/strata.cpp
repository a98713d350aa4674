#include "proofs/bake/domains/strata.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "proofs/bake/domains/draw_name.hpp"
#include "proofs/bake/domains/threshold.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::bake {
namespace {

constexpr std::uint64_t strata_stream = 0x73747261;
constexpr Level large_level = 7;  ///< maps have 16,384 states or more from here on

// ---- The design

/// The pairs of values that rows of the design contain.
class Pairs {
 public:
  bool& operator()(std::size_t d, std::size_t a, std::size_t e, std::size_t b) {
    return met_[(d * most + a) * dimensions * most + e * most + b];
  }

 private:
  static constexpr std::size_t most = 22;
  std::unique_ptr<bool[]> met_ = std::make_unique<bool[]>(dimensions * most * dimensions * most);
};

std::vector<Row> designed() {
  const auto& values = values_of();
  const std::size_t count = sides().size();
  Pairs met;
  std::vector<Row> rows;
  for (std::size_t r = 0; r < count * count; ++r) {
    Random random(1, strata_stream, r);
    Row row{};
    // Any 22 consecutive rows have all widths and all heights.
    row[width_of] = static_cast<std::uint8_t>(r % count);
    row[height_of] = static_cast<std::uint8_t>((7 * (r % count) + r / count) % count);
    std::vector<std::size_t> set{width_of, height_of}, rest;
    for (std::size_t d = mips_of; d < dimensions; ++d) rest.push_back(d);
    for (std::size_t k = rest.size(); k > 1; --k) std::swap(rest[k - 1], rest[random.below(k)]);
    for (const std::size_t d : rest) {
      std::size_t best = 0, most = 0;
      const std::size_t first = random.below(values[d]);
      for (std::size_t k = 0; k < values[d]; ++k) {
        const std::size_t value = (first + k) % values[d];
        std::size_t gain = 1;
        for (const std::size_t e : set) gain += met(d, value, e, row[e]) ? 0 : 1;
        if (gain > most) most = gain, best = value;
      }
      row[d] = static_cast<std::uint8_t>(best);
      for (const std::size_t e : set) met(d, best, e, row[e]) = met(e, row[e], d, best) = true;
      set.push_back(d);
    }
    rows.push_back(row);
  }
  return rows;
}

// ---- Texels

std::uint64_t scattered(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
  std::uint64_t x =
      a * 0x9E3779B97F4A7C15u ^ (b + 0x7F4A7C15u) * 0xBF58476D1CE4E5B9u ^ c * 0x94D049BB133111EBu;
  x = (x ^ x >> 31) * 0xD6E8FEB86659FD93u;
  return x ^ x >> 29;
}

/// The values of texels below the cutoff, and of those at or above it.
struct Palette {
  std::vector<std::uint32_t> below, above;

  std::uint32_t pick(bool high, std::uint64_t hash) const {
    const auto& from = high ? above : below;
    return from[(hash >> 8) % from.size()];
  }
};

Palette palette_of_kind(std::uint8_t kind, Texel texel, Level n, std::uint32_t at, Random& random) {
  const std::uint32_t none = lowest(texel), all = highest(texel), under = stepped(texel, at, -1),
                      over = stepped(texel, at, 1);
  const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
  switch (kind) {
    case 0:  // the two extremes
      return {{none}, {all}};
    case 1:  // steps around the cutoff
      return {{under, stepped(texel, at, -2)}, {at, over}};
    case 2:  // at it and a step below
      return {{under}, {at}};
    case 3: {  // any
      Palette p;
      for (int k = 0; k < 16; ++k) {
        const std::uint32_t x = any_texel(texel, random);
        (value_of(texel, x) < value_of(texel, at) ? p.below : p.above).push_back(x);
      }
      if (p.below.empty()) p.below.push_back(under);
      if (p.above.empty()) p.above.push_back(at);
      return p;
    }
    case 4:  // one number throughout
      return random.below(2) != 0 ? Palette{{at}, {at}} : Palette{{under}, {under}};
    default:  // extremes, and numbers next to 0
      if (texel != Texel::float32) return {{none, stepped(texel, none, 1)}, {all, stepped(texel, all, -1)}};
      // Large maps avoid values that binary64 cannot decide everywhere: a baker needs minutes for them in whole
      // numbers.
      if (n >= large_level)
        return {{bits(-0.25f), bits(-0x1p-149f), bits(-0.0f)}, {bits(1.5f), bits(0x1.000002p+0f)}};
      return {{bits(-0.25f), bits(-0x1p-149f), bits(0x1p-149f), bits(-0.0f), bits(-1e9f), under},
              {bits(1.5f), bits(0x1.000002p+0f), bits(3e8f), at}};
  }
}

/// Fills a mip; `high` decides by a texel's place whether it is at or above the cutoff.
template <class High>
void fill(std::vector<std::uint32_t>& alpha, std::uint32_t width, std::uint32_t height,
          const Palette& palette, std::uint64_t salt, High high) {
  for (std::uint32_t j = 0; j < height; ++j)
    for (std::uint32_t i = 0; i < width; ++i) {
      const std::uint64_t hash = scattered(salt, i, j);
      alpha.push_back(palette.pick(high(i, j, hash), hash));
    }
}

struct Spread {
  std::uint8_t pattern;
  std::uint64_t salt;
  std::uint32_t i, j;  ///< the target texel
  bool odd;            ///< the side of the target texel in the patterns where it stands alone
};

void fill_by(std::vector<std::uint32_t>& alpha, std::uint32_t width, std::uint32_t height,
             const Palette& palette, const Spread& s) {
  const auto by = [&](auto high) { fill(alpha, width, height, palette, s.salt, high); };
  const auto coin = [&](std::uint64_t i, std::uint64_t j) {
    return (scattered(s.salt + 1, i, j) >> 20 & 1) != 0;
  };
  switch (s.pattern) {
    case 0: return by([](std::uint32_t, std::uint32_t, std::uint64_t hash) { return (hash & 1) != 0; });
    case 1: return by([&](std::uint32_t i, std::uint32_t j, std::uint64_t) { return coin(i / 4, j / 4); });
    case 2: return by([&](std::uint32_t i, std::uint32_t j, std::uint64_t) { return coin(i / 2, j / 3); });
    case 3:
      return by(
          [&](std::uint32_t i, std::uint32_t j, std::uint64_t) { return (i == s.i && j == s.j) == s.odd; });
    case 4: return by([&](std::uint32_t i, std::uint32_t, std::uint64_t) { return coin(i, 0); });
    case 5: return by([&](std::uint32_t, std::uint32_t j, std::uint64_t) { return coin(0, j); });
    case 6:  // halves that meet at the texel
      return by(
          [&](std::uint32_t i, std::uint32_t j, std::uint64_t) { return (i + j < s.i + s.j) == s.odd; });
    case 7:  // the last column and the last row differ
      return by([&](std::uint32_t i, std::uint32_t j, std::uint64_t) {
        return (i + 1 == width || j + 1 == height) == s.odd;
      });
    default: return by([](std::uint32_t i, std::uint32_t j, std::uint64_t) { return ((i + j) & 1) != 0; });
  }
}

// ---- The triangle

/// The unit of lengths: so many functions make a texel, and all sums of them are exact.
constexpr std::int64_t functions = 4096;

struct Offset {
  std::int64_t x, y;
};

/// The target's place along one axis, in functions of texels.
std::int64_t target_along(std::uint8_t place, bool second, std::int64_t size, Random& random) {
  const std::int64_t somewhere = random.between(0, size * 2) * functions / 2,
                     last = (2 * size - random.between(0, 4)) * functions / 2;
  // Lines between texels at whose numbers words or rows of words end.
  const auto at_word = [&] {
    const std::int64_t word = std::int64_t{32} << random.below(4);
    return size <= word
               ? last
               : random.between(1, size / word) * word * functions + random.between(-1, 1) * functions / 2;
  };
  switch (place) {
    case 0:  // the last corner
      return last;
    case 1: return second ? somewhere : last;
    case 2: return second ? last : somewhere;
    case 3:  // near the first corner
      return random.between(-3, 3) * functions / 2;
    case 4: return somewhere;
    case 5:  // beyond the last texel
      return last + random.between(0, size) * functions;
    case 6:  // below the first texel
      return -random.between(0, 2 * size) * functions;
    case 7:  // move_away() adds the repeats
      return somewhere;
    default: return at_word();
  }
}

float coordinate(std::int64_t in_parts, std::uint32_t size) {
  return static_cast<float>(static_cast<double>(in_parts) / (static_cast<double>(functions) * size));
}

/// The length of a micro-triangle for each value of the span, in functions of a texel of the deciding mip.
constexpr std::array<std::int64_t, 5> spans{functions / 16, functions / 2, functions, 5 * functions / 2,
                                            8 * functions};

/// The greatest length of a micro-triangle, which limits its cells, so that the specification is fast enough.
std::int64_t most_along(Level n) {
  constexpr std::array<std::int64_t, 4> texels{40, 20, 8, 5};
  return (n < texels.size() ? texels[n] : 3) * functions;
}

/// Moves coordinates of a placed triangle to their neighbours among binary32's numbers.
void nudge_vertices(Case& one, std::uint8_t shape, std::uint8_t place, Random& random) {
  if (shape == 3) {  // as thin as the numbers allow
    const std::size_t axis = random.below(2);
    one.uv[4 + axis] = std::nextafter(one.uv[4 + axis], random.below(2) != 0 ? 1e9f : -1e9f);
  }
  if (shape == 7)  // an ulp off
    for (float& x : one.uv)
      if (const auto step = random.between(-1, 1); step != 0) x = std::nextafter(x, step > 0 ? 1e9f : -1e9f);
  if (place == 3)  // next to 0, and -0
    for (float& x : one.uv)
      if (std::fabs(x) < 0x1p-60f && random.below(2) != 0) x = random.below(2) != 0 ? 0x1p-149f : -0.0f;
}

void place_triangle(Case& one, const Row& row, Level n, Offset target, std::uint32_t mip, Random& random) {
  const std::int64_t side = std::int64_t{1} << n,
                     long_side =
                         std::clamp<std::int64_t>(spans[row[span_of]] << std::min(mip, 5u), 1, most_along(n));
  const auto length = [&] { return std::max<std::int64_t>(1, random.between(long_side / 2, long_side)); };
  Offset e{length(), 0}, f{0, length()};
  const std::uint8_t shape = row[shape_of] == 5 && n >= large_level ? std::uint8_t{4} : row[shape_of];
  switch (shape) {
    case 1:  // turned by some angle
    case 2:  // the same with swapped vertices
    case 7:
      e.y = random.between(-long_side / 2, long_side / 2);
      f.x = random.between(-long_side / 2, long_side / 2);
      if (shape == 2) std::swap(e, f);
      break;
    case 3:  // a line, later a sliver
    case 4:  // a line
      e.y = random.between(-long_side / 2, long_side / 2);
      f = random.below(2) != 0 ? Offset{e.x / 2, e.y / 2} : Offset{-e.x, -e.y};
      break;
    case 5:  // a point
      e = f = {0, 0};
      break;
    case 6: {  // on lines of texels, or of their centres
      const std::int64_t step = long_side >= functions ? functions : functions / 2;
      e = {std::max(step, long_side / step * step), 0};
      f = {random.below(2) != 0 ? step : 0, e.x};
      target = {target.x / (functions / 2) * (functions / 2), target.y / (functions / 2) * (functions / 2)};
      break;
    }
    case 8:  // a strip along u
    case 9:  // a strip along v
      e = {std::min<std::int64_t>(4 * long_side,
                                  std::max<std::int64_t>(long_side, one.width * functions / side)),
           random.between(-2, 2)};
      f = {random.between(-functions, functions) / side, std::max<std::int64_t>(1, functions / 2 / side)};
      if (shape == 9) e = {e.y, e.x}, f = {f.y, f.x};
      break;
    default: break;
  }
  if (shape != 5 && (e.x | e.y) == 0) e.x = 1;
  // The corner of some micro-triangle lies on the target.
  const std::int64_t i = random.between(0, side), j = random.between(0, side - i);
  const Offset p{target.x - i * e.x - j * f.x, target.y - i * e.y - j * f.y};
  const std::array<Offset, 3> vertices{
      p, {p.x + side * e.x, p.y + side * e.y}, {p.x + side * f.x, p.y + side * f.y}};
  for (std::size_t k = 0; k < 3; ++k) {
    one.uv[2 * k] = coordinate(vertices[k].x, one.width);
    one.uv[2 * k + 1] = coordinate(vertices[k].y, one.height);
  }
  nudge_vertices(one, shape, row[place_of], random);
}

/// Moves a triangle repeats away, as far as its coordinates still hold its shape.
void move_away(Case& one, Random& random) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    float least = std::numeric_limits<float>::max(), most = -least;
    for (std::size_t k = axis; k < 6; k += 2)
      least = std::min(least, one.uv[k]), most = std::max(most, one.uv[k]);
    const float extent = std::max(most - least, 0x1p-12f);
    int power = 0;
    while (power < 19 && std::ldexp(1.0f, power - 19) < extent) ++power;
    const auto distance = static_cast<int>(random.between(1, std::max(1, power)));
    const float away = std::ldexp(random.below(2) != 0 ? 1.0f : -1.0f, distance);
    for (std::size_t k = axis; k < 6; k += 2) one.uv[k] += away;
  }
}

constexpr std::uint8_t whole_chain = 4, one_of_them = 1;  // of mips_of and of deciding_mip

std::uint32_t chain(std::uint32_t width, std::uint32_t height) {
  return static_cast<std::uint32_t>(std::bit_width(std::max(width, height)));
}

void set_sides(Case& one, const Row& row, std::uint64_t number, Random& random) {
  const auto& side = sides();
  const std::uint64_t limit = large_row(number) ? large_texels : usual_texels;
  const bool shorter = random.below(2) != 0;
  std::size_t w = row[width_of], h = row[height_of];
  while (std::uint64_t{side[w]} * side[h] > limit) --(shorter ? h : w);
  one.width = side[w];
  one.height = side[h];
  constexpr std::array<std::uint32_t, 5> counts{1, 2, 3, 5, 15};
  one.mips = std::min(counts[row[mips_of]], chain(one.width, one.height));
}

/// The deciding mip of those that exist; 0 if all decide.
std::uint32_t deciding(const Case& one, const Row& row) {
  const std::uint8_t kind = row[deciding_mip];
  const std::uint32_t last = one.mips - 1;
  return kind == 0 ? 0 : kind == 5 ? last : std::min<std::uint32_t>(kind - 1u, last);
}

}  // namespace

const std::array<std::uint8_t, dimensions>& values_of() {
  static const std::array<std::uint8_t, dimensions> values{22, 22,           5, 6, 3,  2, 5, 5, 5, 7,
                                                           7,  cutoff_kinds, 6, 9, 10, 5, 6, 9};
  return values;
}

const std::array<std::uint32_t, 22>& sides() {
  static const std::array<std::uint32_t, 22> all{
      1, 2, 3, 5, 31, 32, 33, 63, 64, 65, 127, 128, 129, 255, 256, 257, 1000, 1024, 2048, 4096, 8192, 16384};
  return all;
}

const std::vector<Row>& design() {
  static const std::vector<Row> rows = designed();
  return rows;
}

namespace {

Row row_of(Level n, std::uint64_t number) {
  Row row = design()[number % design().size()];
  if (number >= plain_rows) {
    for (const Dimension d : {mips_of, deciding_mip, texel_of, filter_of, factor_of, vertex_of, margin_of})
      row[d] = 0;
    if (row[cutoff_of] == cutoff_kinds - 1) row[cutoff_of] = 0;  // BLEND
  }
  if (number >= chain_rows) {
    row[mips_of] = whole_chain;
    row[deciding_mip] = one_of_them;
    row[cutoff_of] = 0;
    row[palette_of] %= 3;
  }
  // Large maps also avoid such factors, with which whole numbers get wider.
  if (n >= large_level && row[factor_of] == 6) row[factor_of] = 4;
  return row;
}

}  // namespace

Case stratified(std::uint64_t seed, Level n, std::uint64_t number) {
  const Row row = row_of(n, number);
  Random random(seed, strata_stream + 1 + n, number);
  Case one;
  set_sides(one, row, number, random);
  one.texel = static_cast<Texel>(row[texel_of]);
  one.filter = static_cast<Filter>(row[filter_of]);
  one.wrap_u = static_cast<Wrap>(row[wrap_u_of]);
  one.wrap_v = static_cast<Wrap>(row[wrap_v_of]);
  constexpr std::array<float, 6> margins{0, 0x1p-8f, 0.1f, 0.25f, 1, 2.5f};
  one.margin = margins[row[margin_of]];
  set_factors(one, row[factor_of], row[vertex_of], random);
  const std::uint32_t at = set_cutoff(one, row[cutoff_of], random);
  const std::array<std::uint32_t, 5> borders{lowest(one.texel), highest(one.texel), at,
                                             stepped(one.texel, at, -1), any_texel(one.texel, random)};
  one.border = borders[row[border_of]];

  const std::uint8_t place = row[place_of];
  Offset target{target_along(place, false, one.width, random), target_along(place, true, one.height, random)};
  const auto to_border = [&](Wrap wrap, std::int64_t& x, std::int64_t size) {
    if (wrap != Wrap::clamp_to_border || random.below(2) != 0) return;
    x = (random.below(2) != 0 ? size * 2 + random.between(0, 6) : -random.between(0, 6)) * functions / 2;
  };
  to_border(one.wrap_u, target.x, one.width);
  to_border(one.wrap_v, target.y, one.height);
  const std::uint32_t mip =
      number < chain_rows ? deciding(one, row) : static_cast<std::uint32_t>(random.below(one.mips));
  place_triangle(one, row, n, target, mip, random);
  if (place == 7) move_away(one, random);

  const Palette palette = palette_of_kind(row[palette_of], one.texel, n, at, random);
  const bool odd = random.below(2) != 0;
  one.alpha.clear();
  one.alpha.reserve(texels_of(one.width, one.height, one.mips));
  for (std::uint32_t k = 0; k < one.mips; ++k) {
    const std::uint32_t width = std::max(1u, one.width >> k), height = std::max(1u, one.height >> k);
    const auto texel_at = [&](Wrap wrap, std::int64_t at_parts, std::uint32_t size, std::uint32_t full) {
      const std::int64_t index = (at_parts * size / full - (at_parts < 0 ? functions - 1 : 0)) / functions;
      return spec::bake::wrapped(wrap, index, size).value_or(size - 1);
    };
    const Spread spread{row[pattern_of], random.next(), texel_at(one.wrap_u, target.x, width, one.width),
                        texel_at(one.wrap_v, target.y, height, one.height), odd};
    const bool decides = row[deciding_mip] == 0 || k == mip;
    if (!decides)
      fill(one.alpha, width, height, palette, spread.salt, [odd](auto, auto, auto) { return !odd; });
    else if (width == 1 && height == 1 && one.mips > 1)
      fill(one.alpha, width, height, palette, spread.salt, [odd](auto, auto, auto) { return odd; });
    else
      fill_by(one.alpha, width, height, palette, spread);
  }
  one.drawn = "drawn-" + std::to_string(seed) + "-" + std::to_string(n) + "-" + std::to_string(number);
  return one;
}

Case drawn_case(const std::string& name) { return case_named(name, "drawn-", stratified); }

std::uint64_t fast_strata(Level n) {
  constexpr std::array<std::uint64_t, 10> counts{64, 64, 64, 64, 64, 64, 48, 28, 16, 8};
  return n < counts.size() ? counts[n] : 0;
}

std::uint64_t stratum(Level n, std::uint64_t k) {
  if (n > highest_rows) return plain_rows + 37 * std::uint64_t{n} + k;
  if (k % 4 == 3) return plain_rows + 37 * std::uint64_t{n} + k / 4;
  std::uint64_t first = 0;
  for (Level m = 0; m < n; ++m) first += fast_strata(m);
  return first + k - k / 4;
}

const char* strata_text() {
  return "stiff cases: sides of 1 to 16384 texels, chains of mips that one decides alone, 8 and 16 bits and "
         "binary32, both filters, all addressing, borders, factors whose products round, cutoffs at, beside "
         "and between them, BLEND, margins, every fourth plain; triangles at far corners, across lines, "
         "repeats away, thin, flat";
}

const char* judged_strata_text() {
  static const std::string text =
      std::string(strata_text()) +
      "; each pair of values of two of these once over levels 0..9; up to 24 micro-triangles of each case";
  return text.c_str();
}

}  // namespace mmverify::proofs::bake
