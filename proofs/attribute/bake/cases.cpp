#include "proofs/attribute/bake/cases.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdlib>

#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::attribute {
namespace {

constexpr std::array<std::pair<Wrap, Wrap>, 8> family_wraps{{{Wrap::repeat, Wrap::repeat},
                                                             {Wrap::mirrored_repeat, Wrap::mirrored_repeat},
                                                             {Wrap::clamp_to_edge, Wrap::clamp_to_edge},
                                                             {Wrap::clamp_to_border, Wrap::clamp_to_border},
                                                             {Wrap::mirror_once, Wrap::mirror_once},
                                                             {Wrap::repeat, Wrap::clamp_to_edge},
                                                             {Wrap::mirrored_repeat, Wrap::repeat},
                                                             {Wrap::clamp_to_border, Wrap::mirror_once}}};

// Triangles inside the square; half of the square, on the grid; beyond all sides; clockwise and thin; far left above;
// a segment; a point.
constexpr std::array<UvTriangle, 7> family_triangles{{{0.125f, 0.25f, 0.875f, 0.375f, 0.5f, 0.8125f},
                                                      {0, 0, 1, 0, 0, 1},
                                                      {-0.75f, -0.5f, 1.5f, 0.25f, 0.375f, 1.75f},
                                                      {0.9375f, 0.0625f, 0.125f, 0.875f, 0.1875f, 1},
                                                      {-1.25f, -1.5f, -0.625f, -1.375f, -1, -0.75f},
                                                      {-0.5f, 0.125f, 0.25f, 0.5f, 1, 0.875f},
                                                      {0.5f, 0.75f, 0.5f, 0.75f, 0.5f, 0.75f}}};
constexpr std::uint64_t family_meanings = 2;

/// Hexadecimal digits of a channel.
template <class Channel>
constexpr std::size_t digits = 2 * sizeof(Channel);

template <class Channel>
std::string hex(const std::vector<RgbaOf<Channel>>& texels) {
  std::string text;
  for (const auto& t : texels)
    for (const Channel c : t) text += fmt::format("{:0{}x}", bits_of(c), digits<Channel>);
  return text;
}

template <class Channel>
std::vector<RgbaOf<Channel>> unhexed(const std::string& text) {
  std::vector<RgbaOf<Channel>> texels(text.size() / (4 * digits<Channel>));
  for (std::size_t k = 0; k < texels.size(); ++k)
    for (std::size_t c = 0; c < 4; ++c)
      texels[k][c] = channel_of_bits<Channel>(static_cast<std::uint32_t>(
          std::strtoul(text.substr((4 * k + c) * digits<Channel>, digits<Channel>).c_str(), nullptr, 16)));
  return texels;
}

template <std::size_t count>
std::size_t named(const std::array<const char*, count>& names, const std::string& name) {
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw BadCase(fmt::format("'{:.60}': one of {}", name, fmt::join(names, ", ")));
  return static_cast<std::size_t>(at - names.begin());
}

std::vector<std::string> split(const std::string& text, char by) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == by)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

}  // namespace

std::uint64_t family_spots() { return family_wraps.size() * family_meanings * family_triangles.size(); }

BakeCase family_case(std::uint64_t spot, std::uint64_t texture, Filter filter) {
  BakeCase one;
  one.uv = family_triangles[spot % family_triangles.size()];
  spot /= family_triangles.size();
  Picture& p = one.picture;
  p.meaning = spot % family_meanings == 0 ? Meaning::linear : Meaning::srgb;
  std::tie(p.wrap_u, p.wrap_v) = family_wraps[spot / family_meanings];
  p.width = p.height = 2;
  p.filter = filter;
  p.border = {101, 101, 101, 101};
  p.texels.resize(4);
  for (std::size_t c = 0; c < 4; ++c) {
    std::uint64_t t = family_texture(texture, c);
    for (Rgba& texel : p.texels) {
      texel[c] = family_alphabet[t % 3];
      t /= 3;
    }
  }
  return one;
}

std::optional<std::uint64_t> family_spot(const BakeCase& one) {
  for (std::uint64_t spot = 0; spot < family_spots(); ++spot) {
    const BakeCase there = family_case(spot, 0, one.picture.filter);
    if (there.uv == one.uv && there.picture.meaning == one.picture.meaning &&
        there.picture.wrap_u == one.picture.wrap_u && there.picture.wrap_v == one.picture.wrap_v)
      return spot;
  }
  return std::nullopt;
}

const char* family_domain() {
  return "all 81 2x2 textures over 0, 101, 255 in each channel, 8 pairs of addressing modes, a grey border, "
         "linear and sRGB, 7 triangles";
}

BakeCase sample_case(std::uint64_t seed, Level n, std::uint64_t k) {
  Random random(seed, 0x626b00 + n, k);
  BakeCase one;
  Picture& p = one.picture;
  p.width = static_cast<std::uint32_t>(random.between(1, 9));
  p.height = static_cast<std::uint32_t>(random.between(1, 7));
  const std::uint64_t kind = random.below(4);
  const auto code = [&] {
    const std::uint64_t any = random.below(256);
    return static_cast<std::uint8_t>(kind == 0   ? any % 2 * 255
                                     : kind == 1 ? 120 + any % 8
                                     : kind == 2 ? any % 24
                                                 : any);
  };
  p.texels.resize(std::size_t{p.width} * p.height);
  for (Rgba& t : p.texels)
    for (std::uint8_t& c : t) c = code();
  for (std::uint8_t& c : p.border) c = code();
  p.wrap_u = static_cast<Wrap>(random.below(5));
  p.wrap_v = static_cast<Wrap>(random.below(5));
  p.filter = random.below(4) == 0 ? Filter::nearest : Filter::bilinear;
  p.meaning = static_cast<Meaning>(k % 4);
  // Most coordinates have few bits, so that Rational128 holds all numbers on the way; a quarter have 22 fraction
  // bits.
  const std::uint64_t grid = random.below(8);
  for (float& x : one.uv) {
    const double fine = static_cast<double>(random.between(-(1 << 22), 2 << 22)) / (1 << 22);
    x = static_cast<float>(grid <= 1   ? fine
                           : grid <= 4 ? std::nearbyint(fine * 64) / 64
                                       : std::nearbyint(fine * 8) / 8);
  }
  if (random.below(8) == 0) {  // all vertices on a line
    one.uv[4] = (one.uv[0] + one.uv[2]) / 2;
    one.uv[5] = (one.uv[1] + one.uv[3]) / 2;
  }
  if (random.below(16) == 0) std::copy_n(one.uv.begin(), 2, one.uv.begin() + 2);
  // A quarter of the triangles is moved by whole repeats, which finds a wrap mode that starts anew at every second
  // one.
  if (random.below(4) == 0)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto repeats = static_cast<float>(random.between(-5, 5));
      for (std::size_t k = axis; k < 6; k += 2) one.uv[k] += repeats;
    }
  return one;
}

namespace {

/// A texture of two texels side by side, and a triangle that covers as much of one as of the other by symmetry alone:
/// no float holds the places where its edges cross.
template <class Channel>
void balance(Random& random, BakeCaseOf<Channel>& one) {
  auto& p = one.picture;
  p.width = 2;
  p.height = 1;
  p.wrap_u = p.wrap_v = Wrap::clamp_to_edge;
  p.filter = Filter::bilinear;
  const auto fine = [&](std::int64_t from, std::int64_t to) {
    return static_cast<float>(random.between(from, to)) / (1 << 20);
  };
  const float side = fine(1 << 16, 1 << 19), base = fine(0, 1 << 20);
  one.uv = {0.5f - side, base, 0.5f + side, base, 0.5f, base + fine(1 << 16, 1 << 20)};
  std::rotate(one.uv.begin(), one.uv.begin() + static_cast<std::ptrdiff_t>(2 * random.below(3)),
              one.uv.end());
}

}  // namespace

BakeCase near_half_case(std::uint64_t seed, Level n, std::uint64_t k) {
  Random random(seed, 0x6e6800 + n, k);
  BakeCase one;
  Picture& p = one.picture;
  p.width = 2;
  p.height = 1;
  p.wrap_u = random.below(2) == 0 ? Wrap::repeat : Wrap::clamp_to_border;
  p.wrap_v = Wrap::clamp_to_edge;
  p.filter = Filter::nearest;
  p.meaning = Meaning::linear;
  p.texels.resize(2);
  for (std::size_t c = 0; c < 4; ++c) {
    const auto base = static_cast<std::uint8_t>(random.below(255));
    const bool first = random.below(2) == 0;
    p.texels[0][c] = static_cast<std::uint8_t>(base + first);
    p.texels[1][c] = p.border[c] = static_cast<std::uint8_t>(base + !first);
  }
  // The second texel, or the border, lies left of u = 0.  An apex at 0 would give each texel a half.
  const auto coarse = [&](std::int64_t from, std::int64_t to) {
    return static_cast<float>(random.between(from, to)) / 64;
  };
  const float side = coarse(8, 32), base = coarse(0, 32), top = base + coarse(16, 64);
  const auto power = static_cast<int>(-random.between(32, 36));
  const float off = std::ldexp(random.below(2) == 0 ? 1.0f : -1.0f, power);
  one.uv = {-side, base, side, base, off, top};
  std::rotate(one.uv.begin(), one.uv.begin() + static_cast<std::ptrdiff_t>(2 * random.below(3)),
              one.uv.end());
  return one;
}

BakeCase long_row_case(std::uint64_t seed, Level n, std::uint64_t k) {
  Random random(seed, 0x726f7700 + n, k);
  BakeCase one = sample_case(seed, n, k);
  Picture& p = one.picture;
  const auto length = static_cast<std::uint32_t>(random.between(257, 320));
  const bool row = random.below(2) == 0;
  p.width = row ? length : 1;
  p.height = row ? 1 : length;
  p.texels.resize(std::size_t{p.width} * p.height);
  // Texels get brighter along the row, so that a baker that leaves its end out is found.
  for (std::size_t t = 0; t < p.texels.size(); ++t)
    for (std::uint8_t& c : p.texels[t])
      c = static_cast<std::uint8_t>(t * 3 / p.texels.size() * 96 + random.below(64));
  const auto coarse = [&](std::int64_t from, std::int64_t to) {
    return static_cast<float>(random.between(from, to)) / 8;
  };
  one.uv = {coarse(-2, 1), coarse(-2, 1), coarse(8, 11), coarse(0, 4), coarse(0, 4), coarse(8, 11)};
  return one;
}

BakeCase beside_lines_case(std::uint64_t seed, Level n, std::uint64_t k) {
  Random random(seed, 0x6c696e00 + n, k);
  BakeCase one = sample_case(seed, n, k);
  Picture& p = one.picture;
  p.filter = Filter::nearest;
  // Sides by which no float division is exact.
  constexpr std::array<std::uint32_t, 5> sides{3, 5, 6, 7, 9};
  p.width = sides[random.below(sides.size())];
  p.height = sides[random.below(sides.size())];
  p.texels.resize(std::size_t{p.width} * p.height);
  for (Rgba& t : p.texels)
    for (std::uint8_t& c : t) c = static_cast<std::uint8_t>(random.below(256));
  const std::int64_t step = std::int64_t{1} << n;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::uint32_t side = axis == 0 ? p.width : p.height;
    const std::int64_t first = random.between(-9, 9);
    for (std::size_t at = axis; at < 6; at += 2)
      one.uv[at] = static_cast<float>(static_cast<double>(first + step * random.between(-1, 1)) / side);
  }
  return one;
}

BakeCaseOf<std::uint16_t> wide_sample_case(std::uint64_t seed, Level n, std::uint64_t k) {
  const BakeCase narrow = sample_case(seed, n, k);
  Random random(seed, 0x77696400 + n, k);
  BakeCaseOf<std::uint16_t> one;
  one.uv = narrow.uv;
  auto& p = one.picture;
  p.width = narrow.picture.width;
  p.height = narrow.picture.height;
  p.wrap_u = narrow.picture.wrap_u;
  p.wrap_v = narrow.picture.wrap_v;
  p.filter = narrow.picture.filter;
  p.meaning = narrow.picture.meaning == Meaning::srgb ? Meaning::linear : narrow.picture.meaning;
  const bool ties = k % 8 == 0 || k % 8 == 5;  // ties, at the cases with linear codes
  const std::uint64_t kind = random.below(4), base = random.below(65534);
  const auto code = [&] {
    const std::uint64_t any = random.below(65536);
    return static_cast<std::uint16_t>(ties        ? base + any % 2
                                      : kind == 0 ? any % 2 * 65535
                                      : kind == 1 ? 32760 + any % 16
                                                  : any);
  };
  if (ties) {  // coordinates at halves, quarters and eighths of texels
    p.width = 1u << random.below(4);
    p.height = 1u << random.below(3);
    p.filter = Filter::bilinear;
    for (float& x : one.uv) x = std::nearbyint(x * 16) / 16;
    if (k % 8 == 5) balance(random, one);
  }
  p.texels.resize(std::size_t{p.width} * p.height);
  for (auto& t : p.texels)
    for (std::uint16_t& c : t) c = code();
  for (std::uint16_t& c : p.border) c = code();
  return one;
}

namespace {

/// A finite number; `kind` selects the distribution.
float drawn_float(Random& random, std::uint64_t kind, std::uint32_t base) {
  const auto any = static_cast<std::uint32_t>(random.below(std::uint64_t{1} << 32));
  const std::uint32_t sign = any & 0x80000000, fraction = any & 0x7fffff;
  const auto with_exponent = [&](std::int64_t exponent) {
    return std::bit_cast<float>(sign | static_cast<std::uint32_t>(exponent + 127) << 23 | fraction);
  };
  switch (kind) {
    case 0: return std::fabs(with_exponent(random.between(-10, 14)));
    case 1:
    case 9: return with_exponent(random.below(2) == 0 ? random.between(95, 105) : random.between(-105, -95));
    case 2: {  // x, -x, and x 2^-40
      const float one = std::bit_cast<float>(base);
      const std::uint64_t which = random.below(5);
      return which == 0 ? one * 0x1p-40f : which < 3 ? one : -one;
    }
    case 3:
      return std::bit_cast<float>(sign | (random.below(2) == 0 ? fraction >> random.below(23) : any % 4));
    case 4:
    case 8: return std::bit_cast<float>(base + any % 2);
    case 7: return with_exponent(random.below(8) == 0 ? 30 : 0);
    case 5: return random.below(3) == 0 ? with_exponent(0) : std::bit_cast<float>(sign);
    default: return with_exponent(random.between(-126, 127));
  }
}

}  // namespace

BakeCaseOf<float> float_sample_case(std::uint64_t seed, Level n, std::uint64_t k) {
  const BakeCase narrow = sample_case(seed, n, k);
  Random random(seed, 0x666c7400 + n, k);
  BakeCaseOf<float> one;
  one.uv = narrow.uv;
  auto& p = one.picture;
  p.width = std::min(narrow.picture.width, 7u);
  p.height = narrow.picture.height;
  p.wrap_u = narrow.picture.wrap_u;
  p.wrap_v = narrow.picture.wrap_v;
  p.filter = narrow.picture.filter;
  const std::uint64_t kind = k % 10;
  // A number of any sign whose exponent leaves room: base x 2^-40 is still normal.
  const auto base = static_cast<std::uint32_t>(random.below(2) << 31 | (60 + random.below(150)) << 23 |
                                               random.below(1u << 23));
  if (kind == 2 || kind == 4 || kind == 9) {  // coordinates at halves, quarters and eighths of texels
    p.width = 1u << random.below(3);
    p.height = 1u << random.below(3);
    p.filter = Filter::bilinear;
    for (float& x : one.uv) x = std::nearbyint(x * 16) / 16;
  }
  if (kind == 8) balance(random, one);
  if (kind == 9) {  // the middle row of vertices lies beside texel centres, by less than binary64 holds
    p.width = 4;
    p.wrap_u = Wrap::repeat;
    one.uv[0] = -0x1p-60f;
    one.uv[2] = one.uv[4] = 0.75f;
  }
  p.texels.resize(std::size_t{p.width} * p.height);
  for (auto& t : p.texels)
    for (float& c : t) c = drawn_float(random, kind, base);
  for (float& c : p.border) c = drawn_float(random, kind, base);
  if (kind == 9)  // large texels in column 0 only
    for (std::size_t t = 0; t < p.texels.size(); ++t)
      for (float& c : p.texels[t])
        c = std::ldexp(c, t % 4 == 0 ? std::max(0, 100 - std::ilogb(c)) : std::min(0, -100 - std::ilogb(c)));
  return one;
}

template <class Channel>
std::string text_of(const BakeCaseOf<Channel>& one) {
  const auto& p = one.picture;
  std::string uv;
  for (const float x : one.uv) uv += fmt::format("{}{:a}", uv.empty() ? "" : ",", x);
  return fmt::format("{}x{}:{}:{},{},{},{},{}:{}", p.width, p.height, hex(p.texels),
                     wrap_names[static_cast<std::size_t>(p.wrap_u)],
                     wrap_names[static_cast<std::size_t>(p.wrap_v)],
                     filter_names[static_cast<std::size_t>(p.filter)],
                     meaning_names[static_cast<std::size_t>(p.meaning)], hex(std::vector{p.border}), uv);
}

template <class Channel>
BakeCaseOf<Channel> read_bake_case_of(const std::string& text) {
  constexpr std::size_t texel = 4 * digits<Channel>;
  static const std::string settings_form = fmt::format("([a-z,+-]+),([0-9a-f]{{{}}})", texel);
  // The texels are split off first: they have more characters than a regular expression can match.
  const std::vector<std::string> parts = split(text, ':');
  const bool four = parts.size() == 4;
  const Groups size = groups_of(parts[0], "([1-9][0-9]{0,2})x([1-9][0-9]{0,2})"),
               settings = groups_of(four ? parts[2] : "", settings_form.c_str());
  if (!four || !size || !settings || parts[1].find_first_not_of("0123456789abcdef") != std::string::npos ||
      parts[1].size() % texel != 0)
    throw BadCase(
        fmt::format("'{:.60}': write WxH:TEXELS:WRAP,WRAP,FILTER,MEANING,BORDER:U,V,U,V,U,V, texels and "
                    "border {} hexadecimal digits each",
                    text, texel == 8 ? "eight" : fmt::to_string(texel)));
  BakeCaseOf<Channel> one;
  auto& p = one.picture;
  p.width = static_cast<std::uint32_t>(std::stoul((*size)[1]));
  p.height = static_cast<std::uint32_t>(std::stoul((*size)[2]));
  p.texels = unhexed<Channel>(parts[1]);
  if (p.texels.size() != std::size_t{p.width} * p.height)
    throw BadCase(fmt::format("'{:.60}': {} texels of {}x{}", text, p.texels.size(), p.width, p.height));
  const std::vector<std::string> names = split((*settings)[1], ',');
  if (names.size() != 4) throw BadCase(fmt::format("'{:.60}': four names before the border", text));
  p.wrap_u = static_cast<Wrap>(named(wrap_names, names[0]));
  p.wrap_v = static_cast<Wrap>(named(wrap_names, names[1]));
  p.filter = static_cast<Filter>(named(filter_names, names[2]));
  p.meaning = static_cast<Meaning>(named(meaning_names, names[3]));
  p.border = unhexed<Channel>((*settings)[2])[0];
  if constexpr (std::is_same_v<Channel, float>) {
    const auto finite = [](const auto& t) {
      return std::all_of(t.begin(), t.end(), [](float c) { return std::isfinite(c); });
    };
    if (!finite(p.border) || !std::all_of(p.texels.begin(), p.texels.end(), finite))
      throw BadCase(fmt::format("'{:.60}': texels are finite numbers", text));
    if (p.meaning != Meaning::linear) throw BadCase(fmt::format("'{:.60}': floats are linear", text));
  }
  const std::vector<std::string> uv = split(parts[3], ',');
  if (uv.size() != 6) throw BadCase(fmt::format("'{:.60}': six coordinates", text));
  for (std::size_t k = 0; k < 6; ++k) {
    char* end = nullptr;
    one.uv[k] = std::strtof(uv[k].c_str(), &end);
    if (uv[k].empty() || *end != 0 || !(std::fabs(one.uv[k]) < 64))
      throw BadCase(fmt::format("'{:.60}': coordinates are numbers below 64", uv[k]));
  }
  return one;
}

template std::string text_of(const BakeCaseOf<std::uint8_t>&);
template std::string text_of(const BakeCaseOf<std::uint16_t>&);
template std::string text_of(const BakeCaseOf<float>&);
template BakeCaseOf<std::uint8_t> read_bake_case_of(const std::string&);
template BakeCaseOf<std::uint16_t> read_bake_case_of(const std::string&);
template BakeCaseOf<float> read_bake_case_of(const std::string&);

std::string text_of(const Rgba& c) { return fmt::format("{} {} {} {}", c[0], c[1], c[2], c[3]); }
std::string text_of(const RgbaOf<std::uint16_t>& c) {
  return fmt::format("{} {} {} {}", c[0], c[1], c[2], c[3]);
}

std::string text_of(const RgbaOf<float>& c) {
  return fmt::format("{:a} {:a} {:a} {:a}", c[0], c[1], c[2], c[3]);
}

}  // namespace mmverify::proofs::attribute
