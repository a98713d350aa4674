// Laws of fields: where the bits of each lie in a block.
#include "proofs/vq/blocks.hpp"
#include "proofs/vq/fields.hpp"
#include "proofs/vq/law_parts.hpp"
#include "proofs/vq/laws.hpp"
#include "proofs/vq/texts.hpp"

namespace mmverify::proofs::vq {
namespace {

template <class Format>
Finding lie_in_their_places(const VqSubject& s, const Values<Format>& values) {
  const Format fields = with<Format>(values);
  const BlockBytes<Format> expected = bits_of_values<Format>(values);
  const Codec<Format>& codec = s.functions.codec<Format>();
  if (const BlockBytes<Format> got = codec.bytes(fields); got != expected)
    return wrong("block " + hex(expected), hex(got));
  if (const Format got = codec.fields(expected); !(got == fields))
    return wrong("the fields of block " + hex(expected), "the fields of block " + hex(codec.bytes(got)));
  return {hash_of(expected)};
}

/// Blocks with at most two bits set, and those with at most two clear.
template <class Format>
constexpr std::uint64_t two_bits = 1 + Format::bits + Format::bits*(Format::bits - 1) / 2;

template <class Format>
Values<Format> two_bits_number(std::uint64_t k) {
  BlockBytes<Format> block{};
  const std::uint8_t others = k < two_bits<Format> ? 0 : 0xFF;
  k %= two_bits<Format>;
  if (k > 0) {
    k -= 1;
    std::uint64_t high = 0;
    // Bit `high` alone, then with each below it.
    while (k > high) k -= ++high;
    const auto set = [&](std::uint64_t bit) {
      block[bit / 8] = static_cast<std::uint8_t>(block[bit / 8] | 1u << bit % 8);
    };
    set(high);
    if (k > 0) set(k - 1);
  }
  for (std::uint8_t& byte : block) byte ^= others;
  return values_of_bits<Format>(block);
}

template <class Format>
std::optional<std::string> lacks_fields(const VqSubject& s) {
  if (!s.functions.codec<Format>().bytes || !s.functions.codec<Format>().fields)
    return s.name() + " has no entry point of fields: they are the specification's";
  return std::nullopt;
}

template <class Format>
Law law_of_fields(Law law, std::uint64_t count, std::function<Values<Format>(std::uint64_t)> number) {
  Cases<Values<Format>> cases;
  cases.count = count;
  cases.number = [=](Level, std::uint64_t k, std::uint64_t) { return number(k); };
  cases.text = [](const Values<Format>& values) {
    return text_of_block<Format>(bits_of_values<Format>(values));
  };
  cases.read = [](Level n, const std::string& at) {
    const BlockBytes<Format> block = block_from_text<Format>(at);
    check_level<Format>(n);
    return values_of_bits<Format>(block);
  };
  cases.check = lie_in_their_places<Format>;
  cases.chunk = 4096;
  law.source = figure_11;
  law.tiers.fast = level_alone<Format>;
  return on_cases(std::move(law), lacks_fields<Format>, cases);
}

template <class Format>
Law bits_law(const char* id, std::vector<Mutant> mutants) {
  return law_of_fields<Format>(
      {.id = id,
       .says = fmt::format(
           "the fields of a block fill its {} bits, each with its own, and every block has fields",
           Format::bits),
       .subjects = {"vq-spec"},
       .tiers = {.seconds = Format::side == 2 ? 0.3 : 1.5},
       .domain = "all blocks with at most two bits set or at most two clear",
       .mutants = std::move(mutants)},
      2 * two_bits<Format>, two_bits_number<Format>);
}

template <class Format>
Law values_law(const char* id, std::vector<Mutant> mutants) {
  return law_of_fields<Format>(
      {.id = id,
       .says = "a field of a block holds each of its values, the others whatever theirs are",
       .subjects = {"vq-spec"},
       .tiers = {.seconds = 0.1},
       .domain = fmt::format(
           "every value of every field, every pair of values of two fields of up to 5 bits, in {} "
           "blocks",
           field_blocks<Format>),
       .mutants = std::move(mutants),
       .long_only = Format::side == 4},
      field_blocks<Format>, [](std::uint64_t k) { return values_of_bits<Format>(field_block<Format>(k)); });
}

template <class Format>
std::function<void(Functions&)> writes_wrongly(
    std::function<void(const Format&, BlockBytes<Format>&)> change) {
  return [=](Functions& functions) {
    auto& bytes = functions.codec<Format>().bytes;
    bytes = [=, real = bytes](const Format& fields) {
      BlockBytes<Format> block = real(fields);
      change(fields, block);
      return block;
    };
  };
}

template <class Format>
std::function<void(Functions&)> reads_wrongly(std::function<void(Format&)> change) {
  return [=](Functions& functions) {
    auto& fields = functions.codec<Format>().fields;
    fields = [=, real = fields](const BlockBytes<Format>& block) {
      Format read = real(block);
      change(read);
      return read;
    };
  };
}

}  // namespace

std::vector<Law> field_laws() {
  const auto bit = [](auto& block, std::size_t k) {
    block[k / 8] = static_cast<std::uint8_t>(block[k / 8] ^ 1u << k % 8);
  };
  const auto spec2 = [](const char* name, const std::function<void(Functions&)>& change) {
    return mutant(name, "vq-spec", level_alone<Vq2>, change);
  };
  const auto spec4 = [](const char* name, const std::function<void(Functions&)>& change) {
    return mutant(name, "vq-spec", level_alone<Vq4>, change);
  };
  return {
      bits_law<Vq2>(
          "vq2.block_bits",
          {spec2("the last bit is lost where all else is set",
                 writes_wrongly<Vq2>([=](const Vq2& f, auto& block) {
                   if (f.own[3][1] == 31 && f.indices[0] == 6) bit(block, 255);
                 })),
           spec2("BL and BR change places in two transforms", reads_wrongly<Vq2>([](Vq2& f) {
                   if (f.transforms[2].number() == 1 && f.transforms[3].number() == 0)
                     std::swap(f.transforms[2], f.transforms[3]);
                 })),
           spec2("index 63 reaches into the transforms", writes_wrongly<Vq2>([=](const Vq2& f, auto& block) {
                   if (f.indices[63] == 4) bit(block, 192);
                 }))}),
      values_law<Vq2>("vq2.field_values",
                      {spec2("one code of TR's second own entry loses a bit",
                             writes_wrongly<Vq2>([=](const Vq2& f, auto& block) {
                               if (f.own[1][1] == 29) bit(block, 231);
                             })),
                       spec2("index 17 is 0 where it is 5", reads_wrongly<Vq2>([](Vq2& f) {
                               if (f.indices[17] == 5) f.indices[17] = 0;
                             })),
                       spec2("the last code is 0 where it is 30", reads_wrongly<Vq2>([](Vq2& f) {
                               if (f.own[3][1] == 30) f.own[3][1] = 0;
                             }))}),
      bits_law<Vq4>("vq4.block_bits", {spec4("the last bit is lost where all else is set",
                                             writes_wrongly<Vq4>([=](const Vq4& f, auto& block) {
                                               if (f.codebook[12] == 0xFFFFF && f.indices[0] == 14)
                                                 bit(block, 511);
                                             })),
                                       spec4("entry 7 has a bit of entry 8", reads_wrongly<Vq4>([](Vq4& f) {
                                               if (f.codebook[4] == 0 && f.codebook[5] == 1)
                                                 f.codebook[4] = 1u << 17;
                                             })),
                                       spec4("two bits at once, of the first and the last index",
                                             reads_wrongly<Vq4>([](Vq4& f) {
                                               if (f.indices[0] == 8 && f.indices[63] == 8) f.indices[0] = 0;
                                             }))}),
      values_law<Vq4>("vq4.field_values",
                      {spec4("one word of entry 15 loses its top bit",
                             writes_wrongly<Vq4>([=](const Vq4& f, auto& block) {
                               if (f.codebook[12] == 0xFACED) bit(block, 511);
                             })),
                       spec4("one word of entry 3", reads_wrongly<Vq4>([](Vq4& f) {
                               if (f.codebook[0] == 0x1BEEF) f.codebook[0] = 0;
                             })),
                       spec4("one word of entry 7 has a bit of entry 6", reads_wrongly<Vq4>([](Vq4& f) {
                               if (f.codebook[4] == 0x2CAFE) f.codebook[4] ^= 1;
                             }))})};
}

}  // namespace mmverify::proofs::vq
