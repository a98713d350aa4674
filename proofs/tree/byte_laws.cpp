#include "proofs/engine/shape.hpp"
#include "proofs/engine/spoils.hpp"
#include "proofs/tree/checks.hpp"
#include "proofs/tree/laws.hpp"
#include "proofs/tree/mutants.hpp"

namespace mmverify::proofs::tree {
namespace {

using spec::micromap::micro_triangles;

constexpr std::uint64_t strings = 1 + 256 + 65536;

/// String k: the empty one, those of one byte, those of two.
Bytes string_number(std::uint64_t k) {
  if (k == 0) return {};
  if (k <= 256) return {static_cast<std::uint8_t>(k - 1)};
  const std::uint64_t word = k - 257;
  return {static_cast<std::uint8_t>(word), static_cast<std::uint8_t>(word >> 8)};
}

std::string text_of(Format f, const Bytes& bytes) {
  return fmt::format("{}-state:{}", f == Format::two_state ? 2 : 4, hex(bytes));
}

std::pair<Format, Bytes> string_from(const std::string& text) {
  const auto [format, digits] = format_and_rest(text);
  if (const auto bytes = bytes_from_hex(digits)) return {format, *bytes};
  throw BadCase(fmt::format("'{:.60}': write 2-state: or 4-state: and bytes in hexadecimal", text));
}

/// The number after "k=".
std::uint64_t number_from(const std::string& text, std::uint64_t limit) {
  const Groups parts = groups_of(text, "k=([0-9]{1,10})");
  if (!parts || std::stoull((*parts)[1]) >= limit)
    throw BadCase(fmt::format("'{}': write k= and a number below {}", text, limit));
  return std::stoull((*parts)[1]);
}

Finding reads(const TreeSubject& s, Level n, std::uint64_t k) {
  const std::uint64_t expected = spec::tree::bits_read_of_largest(n, k),
                      got = s.functions.tree_bits_read(
                          s.functions.encode(alternating_map(n, Format::two_state)), k);
  if (got != expected) return wrong("bits", fmt::format("{}", expected), fmt::format("{}", got));
  return {got};
}

Finding worst_size(const TreeSubject& s, Level n, Format f) {
  const Bytes bytes = s.functions.bytes(s.functions.encode(alternating_map(n, f)));
  const std::uint64_t nodes = spec::tree::most_nodes(n),
                      expected = (nodes + 7) / 8 + spec::micromap::packed_bytes(micro_triangles(n), f);
  if (bytes.size() != expected)
    return wrong(fmt::format("bytes, {} bits,", spec::tree::most_bits(n, f)), fmt::format("{}", expected),
                 fmt::format("{}", bytes.size()));
  return {hash_of(bytes)};
}

constexpr Format formats[] = {Format::two_state, Format::four_state};

}  // namespace

Law canonical_law() {
  Law law{.id = "tree.canonical",
          .says = "of all byte strings, a decoder takes the codes of maps and no others, each as its own map",
          .source = succinct_4_1,
          .subjects = {"tree-spec", "tree-stream"},
          .tiers = {.fast = {0, 4}, .long_run = {0, 8}}};
  law.tiers.seconds = 0.4;
  law.domain = "all byte strings of up to two bytes, 2-state and 4-state";
  law.unfit = [](const Subject& s, Level n) -> std::optional<std::string> {
    if (n > 8) return "it is run up to level 8";
    return needing({entry::bytes, entry::paper})(s, n);
  };
  law = on_numbered_cases(std::move(law),
                          {[](Level, const Run&) { return 2 * strings; },
                           [](const Subject& s, Level n, std::uint64_t k, const Run&) {
                             return bytes_are_canonical(subject_as<TreeSubject>(s), n, formats[k / strings],
                                                        string_number(k % strings));
                           },
                           [](const Subject&, Level, std::uint64_t k, const Run&) {
                             return text_of(formats[k / strings], string_number(k % strings));
                           },
                           [](const Subject& s, Level n, const std::string& at) {
                             const auto [f, bytes] = string_from(at);
                             return bytes_are_canonical(subject_as<TreeSubject>(s), n, f, bytes);
                           },
                           1024, Kind::interior});
  // Each takes, or refuses, one string too many.
  const auto takes = [](const char* name, const char* base, Level n, Format f, Bytes string, Bytes as) {
    return mutant(name, base, {n, n},
                  opens_wrongly([=](const Functions& real, Level level, Format format, auto bytes,
                                    std::optional<Code> code) {
                    if (level != n || format != f ||
                        !std::equal(bytes.begin(), bytes.end(), string.begin(), string.end()))
                      return code;
                    return as.empty() ? std::nullopt : real.open(n, f, as);
                  }));
  };
  law.mutants = {
      takes("takes a set bit after the last value", "tree-stream", 0, Format::two_state, {0x00, 0x80},
            {0x00, 0x00}),
  };
  return law;
}

Law bits_read_law() {
  Law law{.id = "paper.tree_bits_read",
          .says =
              "Algorithm 3 reads 1 + sum of (digit x subtree + 1) bits of the largest tree: all of it for "
              "the last index, and 1 + n/2 + 2/3 (4^n - 1) in the mean",
          .source = succinct_6_2,
          .subjects = {"tree-spec"},
          .tiers = {.fast = {0, 6}, .long_run = {0, 7}}};
  law.tiers.seconds = 0.3;
  law.domain = "the 4^n indices of the alternating map";
  law.unfit = needing({entry::reads});
  const auto cases = [](const Code& code) {
    return NumberedCases{
        [](Level n, const Run&) { return micro_triangles(n); },
        [code](const Subject& s, Level n, std::uint64_t k, const Run&) {
          const std::uint64_t expected = spec::tree::bits_read_of_largest(n, k),
                              got = subject_as<TreeSubject>(s).functions.tree_bits_read(code, k);
          return got == expected ? Finding{got}
                                 : wrong("bits", fmt::format("{}", expected), fmt::format("{}", got));
        },
        [](const Subject&, Level, std::uint64_t k, const Run&) { return fmt::format("k={}", k); },
        [](const Subject& s, Level n, const std::string& at) {
          return reads(subject_as<TreeSubject>(s), n, number_from(at, micro_triangles(n)));
        },
        64,
        Kind::interior};
  };
  law = on_numbered_cases(std::move(law), cases({}));
  // One code for all indices of a level.
  law.judge = [cases](const Subject& s, Level n, const Run& run) {
    return judge_numbered_cases(
        cases(subject_as<TreeSubject>(s).functions.encode(alternating_map(n, Format::two_state))), s, n, run);
  };
  const auto one_more = [](const char* name, Level n, std::uint64_t index) {
    return mutant(
        name, "tree-spec", {n, n},
        spoils(&Functions::tree_bits_read, [=](const Code& code, std::uint64_t k, std::uint64_t& bits) {
          if (code.level == n && k == index) ++bits;
        }));
  };
  law.mutants = {one_more("reads a bit beyond the last leaf of level 6", 6, 4095),
                 one_more("reads a bit more at level 0", 0, 0),
                 one_more("reads a bit more for index 2 of level 3", 3, 2)};
  return law;
}

Law worst_size_law() {
  Law law{.id = "paper.tree_worst_size",
          .says =
              "a map in which no siblings merge takes (4^(n+1)-1)/3 + b 4^n bits, more than flat; tree.sizes "
              "says that none takes more",
          .source = succinct_6_2,
          .subjects = {"tree-spec", "tree-stream"},
          .tiers = {.fast = {0, 8}, .long_run = {0, 10}}};
  law.method = Method::witness;
  law.tiers.seconds = 0.3;
  law.domain = "the alternating map, both formats";
  law.unfit = needing({entry::stream});
  law = on_numbered_cases(
      std::move(law),
      {[](Level, const Run&) { return std::uint64_t{2}; },
       [](const Subject& s, Level n, std::uint64_t k, const Run&) {
         return worst_size(subject_as<TreeSubject>(s), n, formats[k]);
       },
       [](const Subject&, Level, std::uint64_t k, const Run&) { return fmt::format("k={}", k); },
       [](const Subject& s, Level n, const std::string& at) {
         return worst_size(subject_as<TreeSubject>(s), n, formats[number_from(at, 2)]);
       },
       1, Kind::interior});
  law.divisible = false;
  const auto longer = [](const char* name, const char* base, Level n, Format f, int by) {
    return mutant(name, base, {n, n}, writes_wrongly([=](const Map& map, Bytes& bytes) {
                    if (map.level == n && map.format == f)
                      bytes.resize(bytes.size() + static_cast<std::size_t>(by));
                  }));
  };
  law.mutants = {longer("a byte too many at level 8", "tree-stream", 8, Format::four_state, 1)};
  return law;
}

}  // namespace mmverify::proofs::tree
