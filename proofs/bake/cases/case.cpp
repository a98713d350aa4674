#include "proofs/bake/cases/case.hpp"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "proofs/bake/cases/lone_texel.hpp"
#include "proofs/bake/domains/plateaus.hpp"
#include "proofs/bake/domains/strata.hpp"
#include "proofs/engine/random.hpp"

namespace mmverify::proofs::bake {
namespace {

constexpr std::array<std::string_view, 5> wrap_names{"repeat", "mirror", "clamp", "border", "once"};
constexpr std::array<std::string_view, 3> texel_names{"u8", "u16", "f32"};
constexpr std::array<std::size_t, 3> texel_digits{2, 4, 8};
constexpr std::uint32_t largest_side = 16384;
constexpr std::uint64_t most_texels = std::uint64_t{1} << 21, most_said = 1024;

std::size_t digits_of(Texel texel) { return texel_digits[static_cast<std::size_t>(texel)]; }

[[noreturn]] void bad(std::string_view part, const char* remedy) {
  throw BadCase(fmt::format("'{:.60}': {}", part, remedy));
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> functions;
  for (;;) {
    const std::size_t end = text.find(at);
    functions.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return functions;
    text.remove_prefix(end + 1);
  }
}

std::uint32_t whole(std::string_view text, int base, const char* remedy) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc() || end != text.data() + text.size()) bad(text, remedy);
  return value;
}

float finite(std::string_view text) {
  const std::string copy(text);
  char* end = nullptr;
  const float value = std::strtof(copy.c_str(), &end);
  if (copy.empty() || *end != 0 || !std::isfinite(value)) bad(text, "write a finite number, best as C's %a");
  return value;
}

template <std::size_t count>
std::uint32_t named(std::string_view text, const std::array<std::string_view, count>& names,
                    const char* remedy) {
  const auto at = std::find(names.begin(), names.end(), text);
  if (at == names.end()) bad(text, remedy);
  return static_cast<std::uint32_t>(at - names.begin());
}

/// A stored texel, which must be a number.
std::uint32_t stored(std::string_view digits, Texel texel) {
  const std::uint32_t bits = whole(digits, 16, "write texels in hexadecimal digits");
  if (texel == Texel::float32 && !std::isfinite(std::bit_cast<float>(bits)))
    bad(digits, "a texel is not finite");
  return bits;
}

void read_texels(Case& one, std::string_view value) {
  constexpr char remedy[] = "write u8, u16 or f32, WIDTHxHEIGHT and the texels' digits, as u8:2x1:00ff";
  const auto functions = split(value, ':');
  if (functions.size() != 3) bad(value, remedy);
  one.texel = static_cast<Texel>(named(functions[0], texel_names, remedy));
  const auto sides = split(functions[1], 'x');
  if (sides.size() != 2) bad(value, remedy);
  one.width = whole(sides[0], 10, remedy);
  one.height = whole(sides[1], 10, remedy);
  if (one.width < 1 || one.height < 1 || one.width > largest_side || one.height > largest_side ||
      texels_of(one.width, one.height, one.mips) > most_texels)
    bad(value, "1 to 16384 texels along each side, and no more than 2^21");
  const std::size_t digits = digits_of(one.texel);
  const std::uint64_t count = texels_of(one.width, one.height, one.mips);
  if (functions[2].starts_with(lone_begins)) {
    if (one.mips != 1) bad(value, "a texture with a lone texel has one mip");
    one.drawn = functions[2];
    one.alpha = texels(lone_texel(one.drawn), one.width, one.height);
    return;
  }
  const bool is_plateau = functions[2].starts_with(plateau_begins);
  if (is_plateau || functions[2].starts_with("drawn-")) {
    one.drawn = functions[2];
    const std::optional<Case> drawn = resized(is_plateau ? plateau_named(one.drawn) : drawn_case(one.drawn),
                                              one.width, one.height, one.mips, one.texel);
    if (!drawn) bad(value, "the draw has fewer columns, rows or mips");
    one.alpha = drawn->alpha;
    return;
  }
  if (functions[2].size() != digits * count) bad(value, "the digits are not those of all texels of all mips");
  one.alpha.clear();
  for (std::size_t k = 0; k < count; ++k)
    one.alpha.push_back(stored(functions[2].substr(digits * k, digits), one.texel));
}

void read_cutoff(Case& one, std::string_view value) {
  constexpr char remedy[] = "write a cutoff as 1/2 or blend";
  if (value == "blend") {
    one.blend = true;
    return;
  }
  const auto functions = split(value, '/');
  if (functions.size() != 2) bad(value, remedy);
  one.cutoff = {whole(functions[0], 10, remedy), whole(functions[1], 10, remedy)};
  if (one.cutoff.denominator == 0) bad(value, "a cutoff over 0");
}

void read_travel(Case& one, std::string_view value) {
  if (value.empty()) return;
  const auto axes = split(value, ':');
  if (axes.size() != 2) bad(value, "write travel=U:V");
  one.travel = {finite(axes[0]), finite(axes[1])};
  if (one.travel[0] < 0 || one.travel[1] < 0) bad(value, "a travel below 0");
}

/// Domain: the case has its sides and mips.
void read_change(Case& one, std::string_view value) {
  if (value.empty()) return;
  constexpr char remedy[] = "write change=SEED:X-Y-WIDTH-HEIGHT, a box for each mip, within it";
  const auto parts = split(value, ':');
  if (parts.size() != one.mips + 1) bad(value, remedy);
  one.change.seed = whole(parts[0], 10, remedy);
  for (std::uint32_t k = 0; k < one.mips; ++k) {
    const auto numbers = split(parts[k + 1], '-');
    if (numbers.size() != 4) bad(value, remedy);
    auto& box = one.change.boxes.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) box[i] = whole(numbers[i], 10, remedy);
    const std::uint32_t width = std::max(1u, one.width >> k), height = std::max(1u, one.height >> k);
    if (box[0] > width || box[2] > width - box[0] || box[1] > height || box[3] > height - box[1])
      bad(value, remedy);
  }
}

double largest(Texel texel) { return texel == Texel::unorm8 ? 255 : 65535; }

}  // namespace

std::uint64_t texels_of(std::uint32_t width, std::uint32_t height, std::uint32_t mips) {
  std::uint64_t sum = 0;
  for (std::uint32_t k = 0; k < mips; ++k)
    sum += std::uint64_t{std::max(1u, width >> k)} * std::max(1u, height >> k);
  return sum;
}

Case before_change(const Case& one) {
  Case before = one;
  before.change = {};
  before.drawn.clear();
  Random random(one.change.seed, 0x6368, 0);
  std::size_t from = 0;
  for (std::uint32_t k = 0; k < one.mips; ++k) {
    const std::uint32_t width = std::max(1u, one.width >> k), height = std::max(1u, one.height >> k);
    const auto& [x, y, columns, rows] = one.change.boxes.at(k);
    for (std::uint32_t j = y; j < y + rows; ++j)
      for (std::uint32_t i = x; i < x + columns; ++i)
        before.alpha.at(from + i + std::size_t{j} * width) =
            converted(Texel::unorm8, one.texel, random.code());
    from += std::size_t{width} * height;
  }
  return before;
}

std::string text_of(const Case& one) {
  const auto wrap = [](Wrap w) { return wrap_names[static_cast<std::size_t>(w)]; };
  const std::size_t digits = digits_of(one.texel);
  std::string text;
  if (one.mips != 1) text += fmt::format("mips={},", one.mips);
  text += fmt::format("texels={}:{}x{}:", texel_names[static_cast<std::size_t>(one.texel)], one.width,
                      one.height);
  if (one.alpha.size() > most_said
          ? !one.drawn.empty()
          : one.drawn.starts_with(lone_begins) || one.drawn.starts_with(plateau_begins))
    text += one.drawn;
  else
    for (const std::uint32_t bits : one.alpha) text += fmt::format("{:0{}x}", bits, digits);
  text += fmt::format(",wrap={}:{}", wrap(one.wrap_u), wrap(one.wrap_v));
  if (one.wrap_u == Wrap::clamp_to_border || one.wrap_v == Wrap::clamp_to_border)
    text += fmt::format(",border={:0{}x}", one.border, digits);
  if (one.filter == Filter::nearest) text += ",filter=nearest";
  if (one.factor != 1) text += fmt::format(",factor={:a}", one.factor);
  if (one.vertex_factor != 1) text += fmt::format(",vertex={:a}", one.vertex_factor);
  text += one.blend ? std::string(",cutoff=blend")
                    : fmt::format(",cutoff={}/{}", one.cutoff.numerator, one.cutoff.denominator);
  if (one.rules.above) text += ",opaque=above";
  if (one.rules.contact == spec::bake::Contact::open) text += ",contact=open";
  if (one.rules.slack != 0) text += fmt::format(",slack={:a}", one.rules.slack);
  if (one.margin != 0) text += fmt::format(",margin={:a}", one.margin);
  if (one.travel != std::array<float, 2>{})
    text += fmt::format(",travel={:a}:{:a}", one.travel[0], one.travel[1]);
  if (!one.change.boxes.empty()) text += ",change=" + std::to_string(one.change.seed);
  for (const auto& b : one.change.boxes) text += fmt::format(":{}-{}-{}-{}", b[0], b[1], b[2], b[3]);
  text += ",uv=";
  for (std::size_t k = 0; k < 6; ++k) text += fmt::format("{}{:a}", k == 0 ? "" : ":", one.uv[k]);
  return text;
}

Case case_from(const std::string& text) {
  std::map<std::string_view, std::string_view> items;
  for (const std::string_view part : split(text, ',')) {
    const std::size_t at = part.find('=');
    if (at == std::string_view::npos || !items.emplace(part.substr(0, at), part.substr(at + 1)).second)
      bad(part, "write NAME=VALUE, each name once");
  }
  const auto take = [&items](std::string_view name) {
    const auto found = items.find(name);
    if (found == items.end()) return std::string_view();
    const std::string_view value = found->second;
    items.erase(found);
    return value;
  };
  Case one;
  if (const auto value = take("mips"); !value.empty()) {
    one.mips = whole(value, 10, "write a number of mips");
    if (one.mips < 1 || one.mips > 15) bad(value, "1 to 15 mips");
  }
  read_texels(one, take("texels"));
  const auto wraps = split(take("wrap"), ':');
  if (wraps.size() != 2) bad(text, "write wrap=U:V, each repeat, mirror, clamp, border or once");
  one.wrap_u = static_cast<Wrap>(named(wraps[0], wrap_names, "repeat, mirror, clamp, border or once"));
  one.wrap_v = static_cast<Wrap>(named(wraps[1], wrap_names, "repeat, mirror, clamp, border or once"));
  if (const auto value = take("border"); !value.empty()) {
    if (value.size() != digits_of(one.texel)) bad(value, "write the border as a texel");
    one.border = stored(value, one.texel);
  }
  if (const auto value = take("filter"); !value.empty()) {
    if (value != "nearest" && value != "bilinear") bad(value, "bilinear or nearest");
    one.filter = value == "nearest" ? Filter::nearest : Filter::bilinear;
  }
  if (const auto value = take("factor"); !value.empty()) one.factor = finite(value);
  if (const auto value = take("vertex"); !value.empty()) one.vertex_factor = finite(value);
  if (one.factor < 0 || one.vertex_factor < 0) bad(text, "a factor below 0");
  read_cutoff(one, take("cutoff"));
  if (const auto value = take("opaque"); !value.empty()) {
    if (value != "above") bad(value, "write opaque=above where alpha at the cutoff is transparent");
    one.rules.above = true;
  }
  if (const auto value = take("contact"); !value.empty()) {
    if (value != "open") bad(value, "write contact=open where a contact of area 0 does not count");
    one.rules.contact = spec::bake::Contact::open;
  }
  if (const auto value = take("slack"); !value.empty()) one.rules.slack = finite(value);
  if (one.rules.slack < 0) bad(text, "a slack below 0");
  if (const auto value = take("margin"); !value.empty()) one.margin = finite(value);
  if (one.margin < 0) bad(text, "a margin below 0");
  read_travel(one, take("travel"));
  read_change(one, take("change"));
  const auto uv = split(take("uv"), ':');
  if (uv.size() != 6) bad(text, "write uv=U:V:U:V:U:V");
  for (std::size_t k = 0; k < 6; ++k) one.uv[k] = finite(uv[k]);
  if (!items.empty()) bad(items.begin()->first, "no such item of a case");
  return one;
}

std::uint32_t converted(Texel from, Texel to, std::uint32_t bits) {
  if (from == to) return bits;
  const double value = from == Texel::float32 ? std::bit_cast<float>(bits) : bits / largest(from);
  if (to == Texel::float32) return std::bit_cast<std::uint32_t>(static_cast<float>(value));
  return static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0, 1.0) * largest(to)));
}

std::optional<Case> resized(Case one, std::uint32_t width, std::uint32_t height, std::uint32_t mips,
                            Texel texel) {
  if (width > one.width || height > one.height || mips > one.mips) return std::nullopt;
  if (width == one.width && height == one.height && mips == one.mips && texel == one.texel) return one;
  std::vector<std::uint32_t> alpha;
  std::size_t from = 0;
  for (std::uint32_t k = 0; k < mips; ++k) {
    const std::uint32_t columns = std::max(1u, one.width >> k), rows = std::max(1u, one.height >> k);
    for (std::uint32_t j = 0; j < std::max(1u, height >> k); ++j)
      for (std::uint32_t i = 0; i < std::max(1u, width >> k); ++i)
        alpha.push_back(converted(one.texel, texel, one.alpha[from + i + std::size_t{j} * columns]));
    from += std::size_t{columns} * rows;
  }
  one.alpha = std::move(alpha);
  one.border = converted(one.texel, texel, one.border);
  one.width = width;
  one.height = height;
  one.mips = mips;
  one.texel = texel;
  return one;
}

}  // namespace mmverify::proofs::bake
