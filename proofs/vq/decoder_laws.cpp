// Laws of decoders: both ways to decode a block mean the same map.
#include "proofs/vq/blocks.hpp"
#include "proofs/vq/decoder_checks.hpp"
#include "proofs/vq/laws.hpp"

namespace mmverify::proofs::vq {
namespace {

using enum State;
using spec::vq::Region;

template <class Format>
std::optional<std::string> lacks_decoder(const VqSubject& s) {
  const Codec<Format>& codec = s.functions.codec<Format>();
  if (!codec.decode && !codec.regions)
    return fmt::format("{} has no decoder of VQ{}", s.name(), Format::side);
  return std::nullopt;
}

template <class Format>
using BlockOfNumber = std::function<BlockBytes<Format>(std::uint64_t seed, std::uint64_t k)>;

template <class Format>
Law on_blocks(Law law, CaseCount count, BlockOfNumber<Format> number,
              std::function<Finding(const VqSubject&, const BlockBytes<Format>&)> check,
              std::uint64_t chunk = 64) {
  Cases<BlockBytes<Format>> cases;
  cases.count = std::move(count);
  cases.number = [=](Level, std::uint64_t k, std::uint64_t seed) { return number(seed, k); };
  cases.text = text_of_block<Format>;
  cases.read = [](Level n, const std::string& at) {
    const BlockBytes<Format> block = block_from_text<Format>(at);
    check_level<Format>(n);
    return block;
  };
  cases.check = std::move(check);
  cases.chunk = chunk;
  law.source = figure_11;
  law.tiers.fast = level_alone<Format>;
  return on_cases(std::move(law), lacks_decoder<Format>, cases);
}

/// A change of whole maps; regions alone are not there, which halves the time of a sweep.
template <class Format>
std::function<void(Functions&)> decodes_wrongly(std::function<void(const Format&, Map<Format>&)> change) {
  return [=](Functions& functions) {
    functions.codec<Format>().regions = {};
    auto& decode = functions.codec<Format>().decode;
    decode = [=, real = decode](const BlockBytes<Format>& block) {
      Map<Format> map = real(block);
      change(spec::vq::from_bytes<Format>(block), map);
      return map;
    };
  };
}

/// The answer to one region of the blocks that are meant.
template <class Format>
std::function<void(Functions&)> asked_wrongly(Region where, std::function<bool(const Format&)> meant) {
  return [=](Functions& functions) {
    auto& regions = functions.codec<Format>().regions;
    regions = [=, real = regions](const BlockBytes<Format>& block, auto x, auto y, auto state) {
      real(block, x, y, state);
      if (!meant(spec::vq::from_bytes<Format>(block))) return;
      for (std::size_t k = 0; k < state.size(); ++k)
        if (x[k] == where.x && y[k] == where.y) state[k] = state[k] == C ? O : C;
    };
  };
}

/// One region, where the fields that it is made of have some values and another bit of the block is set.
template <class Format>
std::function<void(Functions&)> also_reads(Region where, std::uint32_t index, std::uint32_t transform,
                                           std::size_t bit) {
  return [=](Functions& functions) {
    functions.codec<Format>().regions = {};
    auto& decode = functions.codec<Format>().decode;
    decode = [=, real = decode](const BlockBytes<Format>& block) {
      Map<Format> map = real(block);
      const std::uint32_t X = where.x / Format::side, Y = where.y / Format::side;
      const Format fields = spec::vq::from_bytes<Format>(block);
      const auto q = static_cast<std::size_t>(spec::vq::quadrant_of(X, Y));
      State& state = map[where.x + 8 * Format::side * where.y];
      if (state == O && fields.indices[X + 8 * Y] == index && fields.transforms[q].number() == transform &&
          (block[bit / 8] >> bit % 8 & 1) != 0)
        state = C;
      return map;
    };
  };
}

/// Regions that are right when they are asked for in their order, all at once.
template <class Format, class Change>
std::function<void(Functions&)> in_some_calls(Change change) {
  return [=](Functions& functions) {
    functions.codec<Format>().decode = {};
    auto& regions = functions.codec<Format>().regions;
    regions = [=, real = regions](const BlockBytes<Format>& block, auto x, auto y, auto state) {
      real(block, x, y, state);
      change(x, y, state);
    };
  };
}

constexpr char both_ways_say[] =
    "a block decodes, whole and region by region, to the map whose vectors are its entries, transformed";

template <class Format>
Law region_law(const char* id, std::vector<Mutant> mutants) {
  return on_blocks<Format>(
      {.id = id,
       .says = both_ways_say,
       .subjects = {"vq-spec", "vq"},
       .tiers = {.seconds = Format::side == 2 ? 0.1 : 1.5},
       .domain = fmt::format(
           "every region; each transform of each quadrant with each entry and {}, the other entries at "
           "others and seldom equal; each index at each place under all 512 transform triples, any two "
           "index fields "
           "with all pairs of values{}",
           Format::side == 2 ? "all its words" : "its words that have at most three of 20 bits set or clear",
           Format::side == 2 ? " under each value of any transform" : ""),
       .mutants = std::move(mutants)},
      word_blocks<Format>() + index_blocks<Format>,
      [](std::uint64_t, std::uint64_t k) {
        const std::uint64_t first = word_blocks<Format>();
        return spec::vq::bytes(k < first ? word_block<Format>(k) : index_block<Format>(k - first));
      },
      decodes<Format>);
}

template <class Format>
Law other_bits_law(const char* id, std::vector<std::string> subjects, std::vector<Mutant> mutants) {
  return on_blocks<Format>(
      {.id = id,
       .says =
           "a region's state depends on its own index, transform and entry, and on no other bit of the block",
       .subjects = std::move(subjects),
       .tiers = {.seconds = Format::side == 2 ? 0.3 : 0.5},
       .domain = fmt::format(
           "{} blocks of random bits: every region, with each value of its index, of its transform and "
           "of the two "
           "bits of its entry beside either value of every other bit",
           scattered_blocks<Format>),
       .mutants = std::move(mutants)},
      scattered_blocks<Format>, [](std::uint64_t, std::uint64_t k) { return scattered_block<Format>(k); },
      decodes<Format>);
}

template <class Format>
Law random_law(const char* id, std::uint64_t fast, std::uint64_t long_run) {
  return on_blocks<Format>(
      {.id = id,
       .says =
           "a block decodes to its map, whole and region by region, whichever regions are asked for together",
       .method = Method::sample,
       .subjects = {"vq"},
       .tiers = {.seconds = 0.3},
       .domain = "blocks of random bits, one in four with two indices in a pattern and an entry twice, one "
                 "in eight "
                 "with entries that repeat; a "
                 "region alone, up to 40 with repetitions, all in another order",
       .mutants = {mutant("the last of a call whose size is odd, where it is asked for twice in turn", "vq",
                          level_alone<Format>, in_some_calls<Format>([](auto x, auto y, auto state) {
                            const std::size_t n = state.size();
                            if (n % 2 != 0 && n > 1 && x[n - 1] == x[n - 2] && y[n - 1] == y[n - 2])
                              state[n - 1] = T;
                          }))}},
      {fast, long_run}, [](std::uint64_t seed, std::uint64_t k) { return random_block<Format>(seed, k); },
      decodes_in_any_order<Format>);
}

Law every_word_law() {
  const auto word_of = [](const Vq4& fields, std::uint32_t index) { return fields.codebook[index - 3]; };
  return on_blocks<Vq4>(
      {.id = "vq4.every_code_word",
       .says = "both ways to decode, for every code word of every entry",
       .subjects = {"vq"},
       .domain = "every region, each transform of each quadrant, each entry with all its words, the other "
                 "entries at others, every index in each quadrant",
       .mutants = {mutant("one word of entry 15, transposed in BR", "vq", level_alone<Vq4>,
                          decodes_wrongly<Vq4>([=](const Vq4& f, Map<Vq4>& map) {
                            if (word_of(f, 15) == 0xABCDE && f.transforms[3].number() == 5)
                              for (State& s : map) s = s == O ? T : s;
                          })),
                   mutant(
                       "one word of entry 3", "vq", level_alone<Vq4>,
                       asked_wrongly<Vq4>({31, 31}, [=](const Vq4& f) { return word_of(f, 3) == 0x12345; })),
                   mutant(
                       "one word of entry 7", "vq", level_alone<Vq4>,
                       asked_wrongly<Vq4>({0, 16}, [=](const Vq4& f) { return word_of(f, 7) == 0x2FACE; }))},
       .long_only = true},
      every_word_blocks, [](std::uint64_t, std::uint64_t k) { return spec::vq::bytes(every_word_block(k)); },
      decodes<Vq4>, 4096);
}

}  // namespace

std::vector<Law> decoder_laws() {
  const auto two = [](const char* name, const auto& change) {
    return mutant(name, "vq", level_alone<Vq2>, change);
  };
  const auto four = [](const char* name, const auto& change) {
    return mutant(name, "vq", level_alone<Vq4>, change);
  };
  return {
      region_law<Vq2>("vq2.region_is_map",
                      {two("one triple of transforms", decodes_wrongly<Vq2>([](const Vq2& f, Map<Vq2>& map) {
                             if (f.transforms[1].number() == 3 && f.transforms[2].number() == 6 &&
                                 f.transforms[3].number() == 1)
                               std::swap(map[254], map[255]);
                           }))}),
      region_law<Vq4>("vq4.region_is_map",
                      {four("one triple of transforms", decodes_wrongly<Vq4>([](const Vq4& f, Map<Vq4>& map) {
                              if (f.transforms[1].number() == 7 && f.transforms[2].number() == 4 &&
                                  f.transforms[3].number() == 2 && f.indices[0] == 9)
                                map[528] = map[528] == C ? T : C;
                            }))}),
      other_bits_law<Vq2>("vq2.no_other_bit", {"vq-spec", "vq"},
                          {two("the last region reads the first index", also_reads<Vq2>({15, 15}, 3, 7, 0))}),
      other_bits_law<Vq4>(
          "vq4.no_other_bit", {"vq"},
          {four("the last region reads the first index", also_reads<Vq4>({31, 31}, 15, 7, 0))}),
      random_law<Vq2>("vq2.on_random_blocks", 20'000, 20'000'000),
      random_law<Vq4>("vq4.on_random_blocks", 6'000, 4'000'000),
      every_word_law()};
}

}  // namespace mmverify::proofs::vq
