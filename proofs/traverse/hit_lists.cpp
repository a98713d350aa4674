#include "proofs/traverse/hit_lists.hpp"

#include <cmath>
#include <cstdlib>

#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"
#include "proofs/traverse/colours.hpp"

namespace mmverify::proofs::traverse {
namespace {

using spec::traverse::Colour;

constexpr std::uint64_t stream = 0x68697473;
constexpr std::uint64_t kinds_of_distances = 6;
constexpr std::uint32_t infinite = 0x7F800000, least_normal = 0x00800000;

/// A distance of a kind; all distances of a list are near `middle`, the bits of a number.
std::uint32_t distance(std::uint64_t kind, std::uint32_t middle, Random& random) {
  const auto bits = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
  switch (kind) {
    case 0: return distance_of(std::ldexp(static_cast<float>(random.below(1u << 24)), -20));
    case 1: return bits(middle + random.below(5));
    case 2: return bits(middle + (random.below(2) << 12));
    case 3: return bits(random.below(2) == 0 ? random.below(4) : random.below(least_normal));
    case 4: return bits(infinite - 1 - random.below(16));
    default: return bits(random.below(infinite));
  }
}

/// A value whose effect later ones do not hide.
Colour telling_value(Operation o, Random& random) {
  Colour v{};
  for (auto& code : v) {
    const auto any = static_cast<spec::traverse::Code>(random.below(256));
    code = o == Operation::add ? any % 20 : o == Operation::multiply ? 255 - any % 32 : any;
  }
  if (o == Operation::over)
    for (std::size_t c = 0; c < 3; ++c) v[c] = v[c] * v[3] / 255;
  return v;
}

std::uint32_t hexadecimal(const std::string& digits) {
  return static_cast<std::uint32_t>(std::strtoul(digits.c_str(), nullptr, 16));
}

}  // namespace

HitList hit_list(std::uint64_t seed, std::uint64_t k) {
  Random random(seed, stream, k);
  HitList list;
  list.operation = static_cast<Operation>(k % spec::traverse::operations);
  const bool bright = list.operation == Operation::min || list.operation == Operation::multiply;
  // Half of the lists have any payload and any values, which the other half avoids.
  const bool any = random.below(2) == 0;
  const auto four_codes = [&random] { return colour_of(random.four_codes()); };
  list.payload = any ? four_codes() : bright ? Colour{255, 254, 253, 252} : Colour{0, 1, 2, 3};
  const std::uint64_t count = 1 + k % most_hits, kind = random.below(kinds_of_distances);
  // The middle is from 2^-20 to 2^20, and at times just below a power of two, so that neighbours have another
  // exponent.
  const auto fraction = random.below(4) == 0 ? 0x7FFFFE : random.below(1u << 23);
  const auto middle = static_cast<std::uint32_t>((107 + random.below(40)) << 23 | fraction);
  // The share of accepted hits: about one of `one_in`, from all to few.
  const std::uint64_t one_in = std::uint64_t{1} << random.below(6);
  for (std::uint64_t at = 0; at < count; ++at) {
    Hit hit{distance(kind, middle, random), random.below(one_in) == 0,
            any ? four_codes() : telling_value(list.operation, random)};
    const std::uint64_t again = list.hits.empty() ? 0 : random.below(5);
    if (again == 1 || again == 3) hit.distance = list.hits.back().distance;
    if (again == 2 || again == 3) hit.value = list.hits.back().value;
    if (again == 3) hit.accepted = list.hits.back().accepted;
    list.hits.push_back(hit);
  }
  return list;
}

std::string text_of(const HitList& list) {
  std::string text = fmt::format("{}:{:08x}:", name_of(list.operation), word_of(list.payload));
  for (const Hit& hit : list.hits) {
    if (&hit != list.hits.data()) text += ',';
    text += fmt::format("{}{:a}", hit.accepted ? 'A' : 'B', number_of_distance(hit.distance));
    if (!hit.accepted) text += fmt::format("={:08x}", word_of(hit.value));
  }
  return text;
}

HitList hit_list_of(const std::string& text) {
  const auto bad = [&](const char* why) {
    return BadCase(fmt::format("'{:.60}': {}; write add:09080706:B0x1.8p+0=04030201,A0x1p+1", text, why));
  };
  const Groups whole = groups_of(text, "(max|min|add|multiply|over):([0-9a-f]{8}):(.{1,1000})");
  if (!whole) throw bad("no operation, payload and hits");
  HitList list;
  unsigned o = 0;
  while ((*whole)[1] != name_of(static_cast<Operation>(o))) ++o;
  list.operation = static_cast<Operation>(o);
  list.payload = colour_of(hexadecimal((*whole)[2]));
  for (std::string rest = (*whole)[3] + ","; !rest.empty(); rest.erase(0, rest.find(',') + 1)) {
    const Groups one =
        groups_of(rest.substr(0, rest.find(',')), "([AB])([0-9a-fxp.+-]{1,30})(?:=([0-9a-f]{8}))?");
    if (!one) throw bad("a hit is A or B, a distance, and of B a value");
    Hit hit;
    hit.accepted = (*one)[1] == "A";
    char* end = nullptr;
    const float distance = std::strtof((*one)[2].c_str(), &end);
    if (*end != 0 || !std::isfinite(distance) || std::signbit(distance))
      throw bad("a distance is a finite number that is not negative");
    hit.distance = distance_of(distance);
    if (hit.accepted != (*one)[3].empty()) throw bad("a hit has a value just where it blends");
    if (!hit.accepted) hit.value = colour_of(hexadecimal((*one)[3]));
    list.hits.push_back(hit);
    if (list.hits.size() > most_hits) throw bad("more than 16 hits");
  }
  return list;
}

}  // namespace mmverify::proofs::traverse
