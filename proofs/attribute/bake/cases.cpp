#include "proofs/attribute/bake/cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "proofs/attribute/bake/names.hpp"
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

// Inside; half of the square, on the grid; beyond all sides; clockwise and thin; far left above; a segment; a point.
constexpr std::array<UvTriangle, 7> family_triangles{{{0.125f, 0.25f, 0.875f, 0.375f, 0.5f, 0.8125f},
                                                      {0, 0, 1, 0, 0, 1},
                                                      {-0.75f, -0.5f, 1.5f, 0.25f, 0.375f, 1.75f},
                                                      {0.9375f, 0.0625f, 0.125f, 0.875f, 0.1875f, 1},
                                                      {-1.25f, -1.5f, -0.625f, -1.375f, -1, -0.75f},
                                                      {-0.5f, 0.125f, 0.25f, 0.5f, 1, 0.875f},
                                                      {0.5f, 0.75f, 0.5f, 0.75f, 0.5f, 0.75f}}};
constexpr std::uint64_t family_meanings = 2;

std::string hex(const std::vector<Rgba>& texels) {
  std::string text;
  for (const Rgba& t : texels)
    for (const std::uint8_t c : t) text += fmt::format("{:02x}", c);
  return text;
}

std::vector<Rgba> unhexed(const std::string& text) {
  std::vector<Rgba> texels(text.size() / 8);
  for (std::size_t k = 0; k < texels.size(); ++k)
    for (std::size_t c = 0; c < 4; ++c)
      texels[k][c] =
          static_cast<std::uint8_t>(std::strtoul(text.substr(8 * k + 2 * c, 2).c_str(), nullptr, 16));
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
  return "all 81 2x2 textures over 0, 101, 255 in each channel, 8 pairs of addressing modes, linear and "
         "sRGB, 7 "
         "triangles";
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
  // Most in 8 bits, which exact numbers of 127 bits bear; a quarter in nearly all of binary32's.
  const std::uint64_t grid = random.below(8);
  for (float& x : one.uv) {
    const double fine = static_cast<double>(random.between(-(1 << 22), 2 << 22)) / (1 << 22);
    x = static_cast<float>(grid <= 1   ? fine
                           : grid <= 4 ? std::nearbyint(fine * 64) / 64
                                       : std::nearbyint(fine * 8) / 8);
  }
  if (random.below(8) == 0) {  // on a line
    one.uv[4] = (one.uv[0] + one.uv[2]) / 2;
    one.uv[5] = (one.uv[1] + one.uv[3]) / 2;
  }
  if (random.below(16) == 0) std::copy_n(one.uv.begin(), 2, one.uv.begin() + 2);
  // Some lie whole repeats away, where a mode that begins anew with each second one is in another.
  if (random.below(4) == 0)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto repeats = static_cast<float>(random.between(-5, 5));
      for (std::size_t k = axis; k < 6; k += 2) one.uv[k] += repeats;
    }
  return one;
}

std::string text_of(const BakeCase& one) {
  const Picture& p = one.picture;
  std::string uv;
  for (const float x : one.uv) uv += fmt::format("{}{:a}", uv.empty() ? "" : ",", x);
  return fmt::format("{}x{}:{}:{},{},{},{},{}:{}", p.width, p.height, hex(p.texels),
                     wrap_names[static_cast<std::size_t>(p.wrap_u)],
                     wrap_names[static_cast<std::size_t>(p.wrap_v)],
                     filter_names[static_cast<std::size_t>(p.filter)],
                     meaning_names[static_cast<std::size_t>(p.meaning)], hex({p.border}), uv);
}

BakeCase read_bake_case(const std::string& text) {
  const Groups groups = groups_of(
      text, "([1-9]|1[0-6])x([1-9]|1[0-6]):((?:[0-9a-f]{8})+):([a-z,+-]+),([0-9a-f]{8}):([0-9a-fxp.,+-]+)");
  if (!groups)
    throw BadCase(fmt::format(
        "'{:.60}': write WxH:TEXELS:WRAP,WRAP,FILTER,MEANING,BORDER:U,V,U,V,U,V, texels and border "
        "eight hexadecimal digits each",
        text));
  BakeCase one;
  Picture& p = one.picture;
  p.width = static_cast<std::uint32_t>(std::stoul((*groups)[1]));
  p.height = static_cast<std::uint32_t>(std::stoul((*groups)[2]));
  p.texels = unhexed((*groups)[3]);
  if (p.texels.size() != std::size_t{p.width} * p.height)
    throw BadCase(fmt::format("'{:.60}': {} texels of {}x{}", text, p.texels.size(), p.width, p.height));
  const std::vector<std::string> names = split((*groups)[4], ',');
  if (names.size() != 4) throw BadCase(fmt::format("'{:.60}': four names before the border", text));
  p.wrap_u = static_cast<Wrap>(named(wrap_names, names[0]));
  p.wrap_v = static_cast<Wrap>(named(wrap_names, names[1]));
  p.filter = static_cast<Filter>(named(filter_names, names[2]));
  p.meaning = static_cast<Meaning>(named(meaning_names, names[3]));
  p.border = unhexed((*groups)[5])[0];
  const std::vector<std::string> uv = split((*groups)[6], ',');
  if (uv.size() != 6) throw BadCase(fmt::format("'{:.60}': six coordinates", text));
  for (std::size_t k = 0; k < 6; ++k) {
    char* end = nullptr;
    one.uv[k] = std::strtof(uv[k].c_str(), &end);
    if (uv[k].empty() || *end != 0 || !(std::fabs(one.uv[k]) < 64))
      throw BadCase(fmt::format("'{:.60}': coordinates are numbers below 64", uv[k]));
  }
  return one;
}

std::string text_of(const Rgba& c) { return fmt::format("{} {} {} {}", c[0], c[1], c[2], c[3]); }

}  // namespace mmverify::proofs::attribute
