#include "proofs/micromap/maps.hpp"

#include <fmt/format.h>

#include <array>

#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::micromap {
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

/// A disc, with an unknown outline in 4-state.
Codes leaf(Level n, Format f, Random& random) {
  const auto N = static_cast<std::int64_t>(spec::side(n));
  // The unit is 1/16 of a micro-triangle's side.
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

/// A map in which every node is uniform with one chance in three.
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
  codes[odd] = static_cast<std::uint8_t>((common + 1 + random.below(state_limit(f) - 1)) % state_limit(f));
  return codes;
}

constexpr std::array families{noise, leaf, blocks, alternating, all_but_one};

std::string name_of(Format f) { return f == Format::two_state ? "2-state" : "4-state"; }

/// The ordered pairs of states: 2 in 2-state, 12 in 4-state.
constexpr std::uint64_t pairs_of_states = 14;

OneApart pair_number(std::uint64_t k) {
  if (k < 2) return {Format::two_state, static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(1 - k), 0, 0};
  k -= 2;
  return {Format::four_state, static_cast<std::uint8_t>(k / 3),
          static_cast<std::uint8_t>((k / 3 + 1 + k % 3) % 4), 0, 0};
}

OneApart uniform_number(std::uint64_t k) {
  const auto state = static_cast<std::uint8_t>(k < 2 ? k : k - 2);
  return {k < 2 ? Format::two_state : Format::four_state, state, state, 0, 0};
}

/// The number of places of single micro-triangles: the ends of the map and of words of 16, 32 and 64 states, if the
/// map has so many.
constexpr std::uint64_t places = 10;

std::uint64_t place_number(Level n, std::uint64_t k) {
  const std::uint64_t all = micro_triangles(n);
  return std::array<std::uint64_t, places>{
             0, 15, 16, 31, 32, 63, 64, all / 2 - 1, all / 2, all - 1}[static_cast<std::size_t>(k)] %
         all;
}

}  // namespace

OneApart one_apart_number(Level n, std::uint64_t k) {
  if (k < 6) return uniform_number(k);
  OneApart apart = pair_number((k - 6) % pairs_of_states);
  apart.depth = 1;
  apart.node = (k - 6) / pairs_of_states;
  while (apart.depth < n && apart.node >= micro_triangles(apart.depth))
    apart.node -= micro_triangles(apart.depth++);
  return apart;
}

std::uint64_t chosen_apart_count(Level n) {
  return n <= 7 ? 6 + pairs_of_states * places : n == 8 ? 6 + pairs_of_states : 8;
}

OneApart chosen_apart(Level n, std::uint64_t k) {
  // Above level 8: uniform T and UO, then T among O, O among T, UT among T, T among UT, UO among O, O among UO.
  constexpr std::uint64_t few[] = {2, 5, 1, 0, 3, 9, 6, 12};
  const bool all = n <= 8, alone = all ? k < 6 : k < 2;
  if (alone) return uniform_number(all ? k : few[k]);
  const std::uint64_t pair = all ? (k - 6) % pairs_of_states : few[k];
  OneApart apart = pair_number(pair);
  apart.depth = n;
  apart.node = place_number(n, n <= 7 ? (k - 6) / pairs_of_states : (3 * k + n) % places);
  return apart;
}

Map map_of(Level n, const OneApart& apart) {
  const unsigned b = bits(apart.format);
  const auto filled = [&](unsigned state) {
    return static_cast<std::uint8_t>(b == 1 ? 0xFF * state : 0x55 * state);
  };
  Bytes packed(spec::micromap::packed_bytes(micro_triangles(n), apart.format), filled(apart.common));
  if (const std::uint64_t used = micro_triangles(n) * b; used < 8)
    packed[0] = static_cast<std::uint8_t>(packed[0] & ((1u << used) - 1));
  const std::uint64_t run = micro_triangles(n - apart.depth);
  for (std::uint64_t k = apart.node * run; k < (apart.node + 1) * run;) {
    if (k * b % 8 == 0 && ((apart.node + 1) * run - k) * b >= 8) {
      packed[k * b / 8] = filled(apart.odd);
      k += 8 / b;
      continue;
    }
    auto& byte = packed[k * b / 8];
    const unsigned shift = static_cast<unsigned>(k * b % 8);
    byte = static_cast<std::uint8_t>((byte & ~(((1u << b) - 1) << shift)) | unsigned{apart.odd} << shift);
    ++k;
  }
  return {n, apart.format, packed};
}

Bytes code_of(const OneApart& apart) {
  States tree, data;  // a bit of the tree is a 2-state state
  const auto leaf = [&](std::uint8_t state) {
    tree.push_back(State::T);
    data.push_back(static_cast<State>(state));
  };
  const auto subtree = [&](const auto& self, Level below) -> void {
    if (below == 0) return leaf(apart.odd);
    tree.push_back(State::O);
    const std::uint64_t way = apart.node >> 2 * (below - 1) & 3;
    for (std::uint64_t child = 0; child < 4; ++child)
      if (child == way)
        self(self, below - 1);
      else
        leaf(apart.common);
  };
  subtree(subtree, apart.depth);
  Bytes code = spec::micromap::pack(tree, Format::two_state);
  const Bytes values = spec::micromap::pack(data, apart.format);
  code.insert(code.end(), values.begin(), values.end());
  return code;
}

std::string text_of(const OneApart& a) {
  return fmt::format("{}:{}+{}@{}:{}", name_of(a.format), a.common, a.odd, a.depth, a.node);
}

std::optional<OneApart> apart_from_text(Level n, const std::string& text) {
  const Groups parts = text.size() > 64
                           ? std::nullopt
                           : groups_of(text, "([24])-state:([0-3])\\+([0-3])@([0-9]{1,2}):([0-9]{1,8})");
  if (!parts) return std::nullopt;
  const auto number = [&](std::size_t k) { return std::stoull((*parts)[k]); };
  const OneApart apart{number(1) == 2 ? Format::two_state : Format::four_state,
                       static_cast<std::uint8_t>(number(2)), static_cast<std::uint8_t>(number(3)),
                       static_cast<Level>(number(4)), number(5)};
  if (n > 12 || apart.depth > n || apart.node >= micro_triangles(apart.depth))
    throw BadCase(fmt::format("'{}': level {} has no such node", text, n));
  if (apart.common >= state_limit(apart.format) || apart.odd >= state_limit(apart.format))
    throw BadCase(fmt::format("'{}': a 2-state map has the states 0 and 1", text));
  return apart.odd == apart.common ? OneApart{apart.format, apart.common, apart.odd, 0, 0} : apart;
}

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
  if (const Groups sample =
          text.size() > 64 ? std::nullopt : groups_of(text, "sample:([0-9]{1,19}):([0-9]{1,19})")) {
    if (n > 12) throw BadCase(fmt::format("'{:.60}': samples have levels up to 12", text));
    return sample_map(n, std::stoull((*sample)[1]), std::stoull((*sample)[2]));
  }
  if (const auto apart = apart_from_text(n, text)) return map_of(n, *apart);
  const auto [f, digits] = format_and_rest(text);
  if (digits.empty() || digits.find_first_not_of("0123") != std::string_view::npos)
    throw BadCase(fmt::format(
        "'{:.60}': write 2-state:0110..., 4-state:0123..., 4-state:0+2@3:17 or sample:SEED:K", text));
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

}  // namespace mmverify::proofs::micromap
