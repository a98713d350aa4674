// Laws of decoders: both ways to decode a block mean the same map.
#include "proofs/vq/fields.hpp"
#include "proofs/vq/law_groups.hpp"
#include "proofs/vq/law_parts.hpp"
#include "proofs/vq/texts.hpp"

namespace mmverify::proofs::vq {
namespace {

using enum State;
using spec::vq::Quadrant;
using spec::vq::Region;

/// The regions that each transform fills the regions of a vector from.
template <std::size_t side>
const std::array<std::array<std::uint8_t, side * side>, 8>& sources() {
  static const auto table = [] {
    std::array<std::array<std::uint8_t, side * side>, 8> all{};
    for (std::uint32_t t = 0; t < 8; ++t)
      for (std::uint32_t k = 0; k < side * side; ++k) {
        const Region at{k % static_cast<std::uint32_t>(side), k / static_cast<std::uint32_t>(side)},
            from = spec::vq::filled_from<side>(Transform::of(t), at);
        all[t][k] = static_cast<std::uint8_t>(from.x + side * from.y);
      }
    return all;
  }();
  return table;
}

/// The specification's map, each entry decoded once.
template <class Format>
Map<Format> specified(const Format& fields) {
  constexpr std::size_t side = Format::side, indices = std::size_t{1} << Format::index_bits;
  const auto& from = sources<side>();
  std::array<std::array<Vector<side>, indices>, 4> turned;
  for (std::uint32_t index = 0; index < indices; ++index)
    for (std::size_t q = 0; q < 4; ++q) {
      const Vector<side> entry = fields.entry(static_cast<Quadrant>(q), index);
      for (std::size_t k = 0; k < side * side; ++k)
        turned[q][index][k] = entry[from[fields.transforms[q].number()][k]];
    }
  Map<Format> map;
  for (std::size_t vector = 0; vector < 64; ++vector) {
    const std::size_t X = vector % 8, Y = vector / 8;
    const auto q = static_cast<std::size_t>(
        spec::vq::quadrant_of(static_cast<std::uint32_t>(X), static_cast<std::uint32_t>(Y)));
    const Vector<side>& v = turned[q][fields.indices[vector]];
    for (std::size_t y = 0; y < side; ++y)
      std::copy_n(v.begin() + static_cast<std::ptrdiff_t>(side * y), side,
                  map.begin() + static_cast<std::ptrdiff_t>(side * X + 8 * side * (side * Y + y)));
  }
  return map;
}

template <class Format>
Finding same_map(const char* who, const Map<Format>& expected, const Map<Format>& got) {
  if (got == expected) return {};
  std::size_t k = 0;
  while (got[k] == expected[k]) ++k;
  return wrong(fmt::format("{} region {},{} {}", who, k % (8 * Format::side), k / (8 * Format::side),
                           letters({&expected[k], 1})),
               static_cast<unsigned>(got[k]) < 3 ? letters({&got[k], 1})
                                                 : fmt::format("{}", static_cast<unsigned>(got[k])));
}

template <class Format>
struct Coordinates {
  std::array<std::uint32_t, std::tuple_size_v<Map<Format>>> x, y;
};
template <class Format>
constexpr Coordinates<Format> everywhere = [] {
  Coordinates<Format> all{};
  for (std::uint32_t k = 0; k < all.x.size(); ++k) {
    all.x[k] = k % (8 * Format::side);
    all.y[k] = k / (8 * Format::side);
  }
  return all;
}();

template <class Format>
Finding decodes(const VqSubject& s, const BlockBytes<Format>& block) {
  const Map<Format> expected = specified(spec::vq::from_bytes<Format>(block));
  const Codec<Format>& codec = s.parts.codec<Format>();
  if (codec.decode)
    if (Finding whole = same_map<Format>("decoded", expected, codec.decode(block)); !whole.holds)
      return whole;
  if (codec.regions) {
    Map<Format> got;
    codec.regions(block, everywhere<Format>.x, everywhere<Format>.y, got);
    if (Finding one_by_one = same_map<Format>("asked for", expected, got); !one_by_one.holds)
      return one_by_one;
  }
  return {hash_of(block)};
}

/// Code words with at most three bits of `bits` set, or clear.
std::vector<std::uint32_t> few_bits(std::uint32_t bits) {
  std::vector<std::uint32_t> all;
  const std::uint32_t ones = (1u << bits) - 1;
  for (std::uint32_t word = 0; word <= ones; ++word) {
    const auto set = static_cast<std::uint32_t>(__builtin_popcount(word));
    if (set <= 3 || set + 3 >= bits) all.push_back(word);
  }
  return all;
}

/// All words of 5 bits; of the longer codes those of few bits.
template <class Format>
const std::vector<std::uint32_t>& chosen_words() {
  static const std::vector<std::uint32_t> words = few_bits(Format::side == 2 ? 5 : 20);
  return words;
}

/// Every index is in each quadrant, at other places for another shift.
template <class Format>
void lay_indices(Format& fields, std::uint32_t shift) {
  for (std::uint32_t vector = 0; vector < 64; ++vector) {
    const std::uint32_t place = vector % 4 + 4 * (vector / 8 % 4);
    fields.indices[vector] = static_cast<std::uint8_t>((place + shift) % (1u << Format::index_bits));
  }
}

/// The codebook whose entries all hold a word, cut to their bits.
template <class Format>
Format filled(const std::function<std::uint32_t(std::uint32_t entry)>& word) {
  Values values(fields_of<Format>);
  for (std::uint32_t k = 0; k < entries<Format>; ++k)
    values[67 + k] = word(k) & ((1u << places<Format>[67 + k].bits) - 1);
  return with<Format>(values);
}

template <class Format>
constexpr std::uint32_t shifts = 1u << Format::index_bits;

/// First each word in all entries, under each transform; then every shift of the indices under all 512
/// triples of transforms.
template <class Format>
Format block_number(std::uint64_t k) {
  const std::uint64_t first = 8 * chosen_words<Format>().size();
  if (k < first) {
    Format fields = filled<Format>([&](std::uint32_t) { return chosen_words<Format>()[k / 8]; });
    for (std::uint32_t q = 1; q < 4; ++q)
      fields.transforms[q] = Transform::of((static_cast<std::uint32_t>(k) + q) % 8);
    lay_indices(fields, static_cast<std::uint32_t>(k / 8));
    return fields;
  }
  k -= first;
  // No two entries alike.
  Format fields = filled<Format>([](std::uint32_t entry) { return 0x52F3Bu * (2 * entry + 1) >> entry; });
  for (std::uint32_t q = 1; q < 4; ++q)
    fields.transforms[q] = Transform::of(static_cast<std::uint32_t>(k >> 3 * (q - 1)) % 8);
  lay_indices(fields, static_cast<std::uint32_t>(k / 512));
  return fields;
}

template <class Format>
std::optional<std::string> lacks_decoder(const VqSubject& s) {
  const Codec<Format>& codec = s.parts.codec<Format>();
  if (!codec.decode && !codec.regions)
    return fmt::format("{} has no decoder of VQ{}", s.name(), Format::side);
  return std::nullopt;
}

template <class Format>
Cases<BlockBytes<Format>> blocks() {
  Cases<BlockBytes<Format>> cases;
  cases.text = text_of_block<Format>;
  cases.read = [](Level n, const std::string& at) {
    const BlockBytes<Format> block = block_from_text<Format>(at);
    check_level<Format>(n);
    return block;
  };
  cases.check = decodes<Format>;
  cases.chunk = 64;
  return cases;
}

template <class Format>
std::function<void(Parts&)> decodes_wrongly(std::function<void(const Format&, Map<Format>&)> change) {
  return [=](Parts& parts) {
    auto& decode = parts.codec<Format>().decode;
    decode = [=, real = decode](const BlockBytes<Format>& block) {
      Map<Format> map = real(block);
      change(spec::vq::from_bytes<Format>(block), map);
      return map;
    };
  };
}

/// The answer to one region of the blocks that are meant.
template <class Format>
std::function<void(Parts&)> asked_wrongly(Region where, std::function<bool(const Format&)> meant) {
  return [=](Parts& parts) {
    auto& regions = parts.codec<Format>().regions;
    regions = [=, real = regions](const BlockBytes<Format>& block, auto x, auto y, auto state) {
      real(block, x, y, state);
      if (!meant(spec::vq::from_bytes<Format>(block))) return;
      for (std::size_t k = 0; k < state.size(); ++k)
        if (x[k] == where.x && y[k] == where.y) state[k] = state[k] == C ? O : C;
    };
  };
}

template <class Format>
Law region_law(const char* id, std::vector<Mutant> mutants) {
  auto cases = blocks<Format>();
  cases.count = [](Level, const Run&) -> std::uint64_t {
    return 8 * chosen_words<Format>().size() + 512 * shifts<Format>;
  };
  cases.number = [](Level, std::uint64_t k, std::uint64_t) {
    return spec::vq::bytes(block_number<Format>(k));
  };
  return over(
      {.id = id,
       .topic = "vq",
       .says = "a block decodes, whole and region by region, to the map whose vectors are its entries, "
               "transformed",
       .source = figure_11,
       .subjects = {"vq-spec", "vq"},
       .fast = level_alone<Format>,
       .fast_seconds = 0.5,
       .domain =
           [](const Subject&, Level) {
             return fmt::format(
                 "every region, each transform of each quadrant, each entry with {}; each "
                 "index at each place under all 512 transform triples",
                 Format::side == 2 ? "all words"
                                   : "the words that have at most three of 20 bits set or clear");
           },
       .mutants = std::move(mutants)},
      lacks_decoder<Format>, cases);
}

constexpr std::uint64_t all_words = 1u << 20;

/// Word k mod 2^20 in the first entry and in each other one a word of its own, all of them over all k; the
/// transforms by k / 2^20.
Vq4 any_word_number(std::uint64_t k) {
  const auto word = static_cast<std::uint32_t>(k % all_words),
             turn = static_cast<std::uint32_t>(k / all_words);
  Vq4 fields = filled<Vq4>([&](std::uint32_t entry) { return word * (2 * entry + 1) + 0x9E37u * entry; });
  for (std::uint32_t q = 1; q < 4; ++q) fields.transforms[q] = Transform::of((turn + q) % 8);
  lay_indices(fields, word);
  return fields;
}

Law every_word_law() {
  auto cases = blocks<Vq4>();
  cases.count = [](Level, const Run&) { return 8 * all_words; };
  cases.number = [](Level, std::uint64_t k, std::uint64_t) { return spec::vq::bytes(any_word_number(k)); };
  cases.chunk = 4096;
  const auto word_of = [](const Vq4& fields, std::uint32_t index) { return fields.codebook[index - 3]; };
  Law law = over({.id = "vq4.every_code_word",
                  .topic = "vq",
                  .says = "both ways to decode, for every code word of every entry",
                  .source = figure_11,
                  .subjects = {"vq"},
                  .fast = level_alone<Vq4>,
                  .domain =
                      [](const Subject&, Level) {
                        return std::string(
                            "every region, each transform of each quadrant, each entry with all its words");
                      },
                  .mutants = {mutant("one word of entry 15, transposed in BR", "vq", level_alone<Vq4>,
                                     decodes_wrongly<Vq4>([=](const Vq4& f, Map<Vq4>& map) {
                                       if (word_of(f, 15) == 0xABCDE && f.transforms[3].number() == 5)
                                         for (State& s : map) s = s == O ? T : s;
                                     })),
                              mutant("one word of entry 3", "vq", level_alone<Vq4>,
                                     asked_wrongly<Vq4>(
                                         {31, 31}, [=](const Vq4& f) { return word_of(f, 3) == 0x12345; })),
                              mutant("one word of entry 7", "vq", level_alone<Vq4>,
                                     asked_wrongly<Vq4>(
                                         {0, 16}, [=](const Vq4& f) { return word_of(f, 7) == 0x2FACE; }))}},
                 lacks_decoder<Vq4>, cases);
  law.long_only = true;
  return law;
}

}  // namespace

std::vector<Law> decoder_laws() {
  return {
      region_law<Vq2>(
          "vq2.region_is_map",
          {mutant(
               "one entry of BR, under Rotate 270", "vq", level_alone<Vq2>,
               asked_wrongly<Vq2>(
                   {15, 2}, [](const Vq2& f) { return f.transforms[3].number() == 7 && f.own[3][1] == 21; })),
           mutant("one triple of transforms", "vq", level_alone<Vq2>,
                  decodes_wrongly<Vq2>([](const Vq2& f, Map<Vq2>& map) {
                    if (f.transforms[1].number() == 3 && f.transforms[2].number() == 6 &&
                        f.transforms[3].number() == 1)
                      std::swap(map[254], map[255]);
                  })),
           mutant(
               "TL takes TR's transform where that is Reflect TB", "vq-spec", level_alone<Vq2>,
               asked_wrongly<Vq2>(
                   {0, 0}, [](const Vq2& f) { return f.transforms[1].number() == 2 && f.shared[0] == 1; }))}),
      region_law<Vq4>("vq4.region_is_map",
                      {mutant("one entry of BR, under Rotate 270", "vq", level_alone<Vq4>,
                              asked_wrongly<Vq4>({30, 1},
                                                 [](const Vq4& f) {
                                                   return f.transforms[3].number() == 7 &&
                                                          f.codebook[12] == 0x80401;
                                                 })),
                       mutant("the second palette of a vertical line", "vq", level_alone<Vq4>,
                              decodes_wrongly<Vq4>([](const Vq4& f, Map<Vq4>& map) {
                                if (f.codebook[3] == 0x20001 && f.transforms[2].number() == 6)
                                  map[0] = map[0] == C ? T : C;
                              })),
                       mutant("one triple of transforms", "vq", level_alone<Vq4>,
                              asked_wrongly<Vq4>({16, 16},
                                                 [](const Vq4& f) {
                                                   return f.transforms[1].number() == 7 &&
                                                          f.transforms[2].number() == 4 &&
                                                          f.transforms[3].number() == 2 && f.indices[0] == 9;
                                                 }))}),
      every_word_law()};
}

}  // namespace mmverify::proofs::vq
