#include "proofs/tree/maps.hpp"

#include <fmt/format.h>

#include <array>

#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::tree {
namespace {

using spec::micromap::micro_triangles;

Map from_states(Level n, Format f, const std::vector<std::uint8_t>& codes) {
  States states;
  for (const std::uint8_t code : codes) states.push_back(static_cast<State>(code));
  return {n, f, spec::micromap::pack(states, f)};
}

/// The bits of a number as a packed map of at most 32 bits.
Map from_bits(Level n, Format f, std::uint64_t k) {
  Bytes packed(spec::micromap::packed_bytes(micro_triangles(n), f));
  for (std::size_t byte = 0; byte < packed.size(); ++byte)
    packed[byte] = static_cast<std::uint8_t>(k >> 8 * byte);
  return {n, f, packed};
}

std::uint64_t state_limit(Format f) { return f == Format::two_state ? 2 : 4; }

std::uint8_t any_state(Format f, Random& random) {
  return static_cast<std::uint8_t>(random.below(state_limit(f)));
}

using Codes = std::vector<std::uint8_t>;

Codes noise(Level n, Format f, Random& random) {
  Codes codes(micro_triangles(n));
  for (std::uint8_t& code : codes) code = any_state(f, random);
  return codes;
}

/// A disc, its outline unknown where the format can say so.
Codes leaf(Level n, Format f, Random& random) {
  const auto N = static_cast<std::int64_t>(spec::side(n));
  // In units of 1/16 of a micro-triangle's side.
  const std::int64_t cu = random.between(0, 16 * N), cv = random.between(0, 16 * N),
                     r = random.between(2 * N, 12 * N);
  Codes codes(micro_triangles(n));
  for (std::uint64_t k = 0; k < codes.size(); ++k) {
    unsigned inside = 0;
    for (const auto& corner : spec::index::corners(static_cast<std::uint32_t>(k), n)) {
      const std::int64_t du = 16 * std::int64_t{corner.i} - cu, dv = 16 * std::int64_t{corner.j} - cv;
      inside += du * du + dv * dv < r * r ? 1 : 0;
    }
    const bool opaque = inside >= 2, mixed = inside == 1 || inside == 2;
    codes[k] = static_cast<std::uint8_t>((opaque ? 1 : 0) + (mixed && f == Format::four_state ? 2 : 0));
  }
  return codes;
}

/// Every node is uniform with one chance in three.
Codes blocks(Level n, Format f, Random& random) {
  Codes codes;
  const auto subtree = [&](const auto& self, Level level) -> void {
    if (level == 0 || random.below(3) == 0) {
      codes.insert(codes.end(), micro_triangles(level), any_state(f, random));
      return;
    }
    for (unsigned child = 0; child < 4; ++child) self(self, level - 1);
  };
  subtree(subtree, n);
  return codes;
}

Codes alternating(Level n, Format f, Random& random) {
  Codes codes(micro_triangles(n));
  const std::uint8_t first = any_state(f, random);
  for (std::uint64_t k = 0; k < codes.size(); ++k)
    codes[k] = static_cast<std::uint8_t>((first + k) % state_limit(f));
  return codes;
}

Codes all_but_one(Level n, Format f, Random& random) {
  const std::uint8_t common = any_state(f, random);
  Codes codes(micro_triangles(n), common);
  const auto odd = static_cast<std::uint64_t>(random.below(codes.size()));
  codes[odd] = static_cast<std::uint8_t>((common + 1) % state_limit(f));
  return codes;
}

constexpr std::array families{noise, leaf, blocks, alternating, all_but_one};

std::string name_of(Format f) { return f == Format::two_state ? "2-state" : "4-state"; }

}  // namespace

Map map_number(Level n, std::uint64_t k) {
  const std::uint64_t two_state = std::uint64_t{1} << micro_triangles(n);
  return k < two_state ? from_bits(n, Format::two_state, k) : from_bits(n, Format::four_state, k - two_state);
}

Map four_state_map_of_level_2(std::uint64_t k) { return from_bits(2, Format::four_state, k); }

Map sample_map(Level n, std::uint64_t seed, std::uint64_t k) {
  Random random(seed, n, k);
  const Format f = k % 2 == 0 ? Format::two_state : Format::four_state;
  return from_states(n, f, families[k / 2 % families.size()](n, f, random));
}

Map alternating_map(Level n, Format f) {
  Codes codes(micro_triangles(n));
  for (std::uint64_t k = 0; k < codes.size(); ++k) codes[k] = static_cast<std::uint8_t>(k % state_limit(f));
  return from_states(n, f, codes);
}

std::string text_of_states(const Map& map) {
  std::string text = name_of(map.format) + ":";
  for (std::uint64_t k = 0; k < micro_triangles(map.level); ++k)
    text += static_cast<char>('0' + state_at(map, k));
  return text;
}

std::string text_of_sample(const Map& map, std::uint64_t seed, std::uint64_t k) {
  return map.level <= 4 ? text_of_states(map) : fmt::format("sample:{}:{}", seed, k);
}

std::pair<Format, std::string_view> format_and_rest(std::string_view text) {
  constexpr std::string_view rest = "-state:";
  if (text.size() > rest.size() && (text[0] == '2' || text[0] == '4') && text.substr(1, rest.size()) == rest)
    return {text[0] == '2' ? Format::two_state : Format::four_state, text.substr(1 + rest.size())};
  throw BadCase(fmt::format("'{:.60}': write 2-state: or 4-state: first", text));
}

Map map_from_text(Level n, const std::string& text) {
  if (const Parts sample =
          text.size() > 64 ? std::nullopt : parts_of(text, "sample:([0-9]{1,19}):([0-9]{1,19})")) {
    if (n > 12) throw BadCase(fmt::format("'{:.60}': samples have levels up to 12", text));
    return sample_map(n, std::stoull((*sample)[1]), std::stoull((*sample)[2]));
  }
  const auto [f, digits] = format_and_rest(text);
  if (digits.empty() || digits.find_first_not_of("0123") != std::string_view::npos)
    throw BadCase(fmt::format("'{:.60}': write 2-state:0110..., 4-state:0123... or sample:SEED:K", text));
  if (n > 12 || digits.size() != micro_triangles(n))
    throw BadCase(fmt::format("'{:.60}': {} states, level {} has another number", text, digits.size(), n));
  Codes codes;
  for (const char c : digits) {
    codes.push_back(static_cast<std::uint8_t>(c - '0'));
    if (codes.back() >= state_limit(f))
      throw BadCase(fmt::format("'{:.60}': a 2-state map has the states 0 and 1", text));
  }
  return from_states(n, f, codes);
}

}  // namespace mmverify::proofs::tree
