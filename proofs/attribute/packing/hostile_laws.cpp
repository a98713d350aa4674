// Laws of bytes that are no packed maps, or other packed maps.
#include "proofs/attribute/laws.hpp"
#include "proofs/attribute/packing/cases.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::attribute {
namespace {

namespace slow = spec::attribute;

/// A kind of damage to packed bytes.
enum class Harm : std::uint32_t { bit, byte, cut, longer, unused_bits, start, width, wider };
constexpr std::array<const char*, 8> harm_names{"bit",         "byte",  "cut",   "longer",
                                                "unused-bits", "start", "width", "wider"};

struct HarmedCase {
  PackCase maps;
  Harm harm = Harm::bit;
};

/// The offsets of the parts of packed bytes.
struct PartsAt {
  std::size_t starts, widths, bits;
};

PartsAt parts_of(const PackedShape& shape) {
  const std::size_t blocks = shape.maps * slow::block_lengths(shape.at, shape.level).size();
  const std::size_t starts = shape.maps * slow::roots_of(shape.at) * shape.channels;
  const std::size_t widths = starts + (blocks + 7) / 8 * 4;
  return {starts, widths, widths + (blocks * shape.channels + 1) / 2};
}

/// Makes the last block's last channel one bit wider than needed, and keeps all else.
void widen_last(const PackedShape& shape, Bytes& bytes) {
  const auto lengths = slow::block_lengths(shape.at, shape.level);
  if (lengths.empty()) return;
  const PartsAt parts = parts_of(shape);
  const std::size_t halves = shape.maps * lengths.size() * shape.channels, last = halves - 1;
  auto half =
      slow::detail::BitString::of_bytes(ByteView(bytes).subspan(parts.widths, parts.bits - parts.widths));
  slow::Widths widths;
  for (std::size_t k = 0; k < halves; ++k) widths.push_back(half.take(4));
  auto old_bits = slow::detail::BitString::of_bytes(ByteView(bytes).subspan(parts.bits));
  slow::detail::BitString bits;
  for (std::size_t k = 0; k < halves; ++k)
    for (std::uint32_t r = 0; r < 3 * lengths[k / shape.channels % lengths.size()]; ++r)
      bits.put(old_bits.take(widths[k]), widths[k] + (k == last ? 1 : 0));
  bytes[parts.widths + last / 2] =
      static_cast<std::uint8_t>(bytes[parts.widths + last / 2] + (last % 2 == 0 ? 1 : 16));
  bytes.resize(parts.bits);
  const auto tail = bits.bytes();
  bytes.insert(bytes.end(), tail.begin(), tail.end());
}

Bytes harmed(const HarmedCase& one) {
  const PackedShape& shape = one.maps.shape;
  Bytes bytes = slow::pack(shape, codes_of(one.maps));
  Random random(one.maps.seed, 0x6861726d, one.maps.number * 32 + shape.level);
  const PartsAt parts = parts_of(shape);
  const auto in = [&](std::size_t from, std::size_t to) {
    return from < to ? from + static_cast<std::size_t>(random.below(to - from)) : bytes.size() - 1;
  };
  const auto flip = [&](std::size_t at) {
    bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ 1u << random.below(8));
  };
  switch (one.harm) {
    case Harm::bit: flip(in(0, bytes.size())); break;
    case Harm::byte: bytes[in(0, bytes.size())] = static_cast<std::uint8_t>(random.below(256)); break;
    case Harm::cut: bytes.resize(static_cast<std::size_t>(random.below(bytes.size()))); break;
    case Harm::longer: bytes.resize(bytes.size() + 1 + random.below(5)); break;
    case Harm::unused_bits: bytes.back() = static_cast<std::uint8_t>(bytes.back() | 128); break;
    case Harm::start:
      // Flips a bit of the last start, which belongs to the ninth block or a later one if there are so many.
      flip(parts.widths > parts.starts ? parts.widths - 4 : in(0, bytes.size()));
      break;
    case Harm::width: flip(in(parts.widths, parts.bits)); break;
    case Harm::wider: widen_last(shape, bytes); break;
  }
  return bytes;
}

Finding takes_no_other(const AttributeSubject& s, Level, const HarmedCase& one) {
  const PackedShape& shape = one.maps.shape;
  const Bytes bytes = harmed(one);
  const auto expected = slow::unpack(shape, bytes), got = s.functions.compression.unpack(shape, bytes);
  const auto said = [](bool accepted) { return std::string(accepted ? "bytes accepted" : "bytes refused"); };
  if (expected.has_value() != got.has_value())
    return wrong(said(expected.has_value()), said(got.has_value()));
  if (!got) return {hash_of(bytes)};
  if (*got != *expected) return differ_at(*expected, *got, "codes");
  const Bytes again = s.functions.compression.pack(shape, *got);
  if (again != bytes) return differ_at(bytes, again, "bytes");
  return {hash_of(*got)};
}

Law canonical_law() {
  Cases<HarmedCase> cases;
  cases.count = {192, 3'840};
  cases.number = [](Level n, std::uint64_t k, std::uint64_t seed) {
    return HarmedCase{pack_case(n, k / harm_names.size(), seed, true),
                      static_cast<Harm>(k % harm_names.size())};
  };
  cases.text = [](Level, const HarmedCase& one) {
    return fmt::format("{}:{}", harm_names[static_cast<std::size_t>(one.harm)], text_of(one.maps));
  };
  cases.read = [](Level n, const std::string& text) {
    const Groups g = groups_of(text, "([a-z-]+):(.*)");
    const auto* const name = g ? std::find(harm_names.begin(), harm_names.end(), (*g)[1]) : harm_names.end();
    if (name == harm_names.end())
      throw BadCase(fmt::format(
          "'{:.60}': write bit, byte, cut, longer, unused-bits, start, width or wider, a colon, maps", text));
    return HarmedCase{pack_case_of(n, (*g)[2]), static_cast<Harm>(name - harm_names.begin())};
  };
  cases.check = takes_no_other;
  cases.chunk = 4;
  return on_cases({.id = "attribute.packed_canonical",
                   .says = "bytes are refused, or are those that packing what they give would write: maps "
                           "have one form, and no other bytes are taken for it",
                   .source = "spec/attribute/compress.hpp",
                   .method = Method::sample,
                   .subjects = {"attribute-spec", "attribute"},
                   .tiers = {.fast = {0, 4}, .long_run = {0, 6}, .seconds = 2},
                   .domain = "packed maps with a bit or a byte changed, cut, longer, with unused bits set, a "
                             "start or a width changed, a block wider than it is",
                   .mutants = {mutant("the second start is not looked at", "attribute", {4, 4},
                                      [](Functions& f) {
                                        f.compression.unpack = [real = f.compression.unpack](
                                                                   const PackedShape& shape,
                                                                   ByteView bytes) -> std::optional<Bytes> {
                                          if (auto codes = real(shape, bytes)) return codes;
                                          const PartsAt parts = parts_of(shape);
                                          if (shape.level < 4 || parts.widths != parts.starts + 8)
                                            return std::nullopt;
                                          // Flips each bit of the second start's low byte in turn, and takes the first result
                                          // that is accepted.
                                          for (unsigned bit = 0; bit < 8; ++bit) {
                                            Bytes other(bytes.begin(), bytes.end());
                                            if (other.size() < parts.widths) return std::nullopt;
                                            other[parts.starts + 4] = static_cast<std::uint8_t>(
                                                other[parts.starts + 4] ^ 1u << bit);
                                            if (auto codes = real(shape, other)) return codes;
                                          }
                                          return std::nullopt;
                                        };
                                      })}},
                  needing({pack_entry, unpack_entry}), std::move(cases));
}

}  // namespace

std::vector<Law> compression_hostile_laws() { return {canonical_law()}; }

}  // namespace mmverify::proofs::attribute
