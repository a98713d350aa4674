// Laws of devices: levels that a device lacks are emulated; blocks have few descriptors.
#include <set>

#include "proofs/array/law_parts.hpp"
#include "proofs/array/laws.hpp"
#include "proofs/micromap/maps.hpp"

namespace mmverify::proofs::array {
namespace {

namespace maps = mmverify::spec::micromap;

// ---- Emulated levels

/// KHR's rule, with no state lost that could be kept: a block of T alone or of O alone stays known.
Finding emulates(const ArraySubject& s, const PackedMap& m, Level most) {
  const States was = states_of(m);
  const Bytes bytes = s.functions.emulate(m.level, most, m.bytes);
  const std::uint64_t blocks = maps::micro_triangles(most), each = was.size() / blocks;
  if (bytes.size() != maps::packed_bytes(blocks, Format::four_state))
    return wrong(fmt::format("{} bytes", maps::packed_bytes(blocks, Format::four_state)),
                 fmt::format("{}", bytes.size()));
  const States is = maps::unpack(bytes, Format::four_state, blocks);
  for (std::uint64_t b = 0; b < blocks; ++b) {
    const auto block =
        std::span(was).subspan(static_cast<std::size_t>(b * each), static_cast<std::size_t>(each));
    const auto state = maps::uniform(block);
    if (state && !maps::unknown(*state)) {
      if (is[b] != *state)
        return wrong(fmt::format("block {} {}", b, maps::name_of(*state)), maps::name_of(is[b]));
    } else if (!maps::unknown(is[b])) {
      return wrong(fmt::format("block {} unknown", b), maps::name_of(is[b]));
    }
  }
  return {hash_of(bytes)};
}

PackedMap four_state(Level n, std::uint64_t seed, std::uint64_t k) {
  const micromap::Map map = micromap::sample_map(n, seed, k);
  return packed(n, Format::four_state, maps::unpack(map.packed, map.format, maps::micro_triangles(n)));
}

/// The lower level of sample k, drawn independently of its map, whose kind depends on k.
Level level_below(Level n, std::uint64_t seed, std::uint64_t k) {
  return static_cast<Level>(Random(seed, 509 + n, k).below(n));
}

std::function<void(Functions&)> emulating(void (*change)(Level n, Level most, Bytes&)) {
  return spoils(&Functions::emulate, [change](Level n, Level most, std::span<const std::uint8_t>,
                                              Bytes& out) { change(n, most, out); });
}

Law emulation() {
  return on_cases(
      {.id = "array.emulates",
       .says = "a level that the device lacks, emulated by lossy substitution, has T and O for "
               "blocks of T and O alone, and unknown states for the rest",
       .source = "the KHR slides, Lossy Micromaps",
       .subjects = {"array-spec", "array"},
       .tiers = {.fast = {1, 1}, .long_run = {1, 1}, .seconds = 0.1},
       .domain = "all 256 4-state maps of level 1 at level 0",
       .mutants = {mutant("a majority of O is O", "array", {1, 1},
                          spoils(&Functions::emulate,
                                 [](Level n, Level, std::span<const std::uint8_t> map, Bytes& out) {
                                   if (n == 1 && map[0] == 0x54) out[0] = 1;
                                 })),
                   mutant("a block of UT is T", "array-spec", {1, 1},
                          spoils(&Functions::emulate,
                                 [](Level n, Level, std::span<const std::uint8_t> map, Bytes& out) {
                                   if (n == 1 && map[0] == 0xaa) out[0] = 0;
                                 })),
                   mutant("T and O are unknown at once", "array", {1, 1},
                          emulating([](Level, Level, Bytes& out) {
                            out[0] = static_cast<std::uint8_t>(out[0] | 2);
                          }))}},
      {entry::emulate},
      {[](Level n) -> std::uint64_t { return n == 1 ? 256 : 0; },
       [](const ArraySubject& s, Level, std::uint64_t k, const Run&) {
         return emulates(s, {1, Format::four_state, {static_cast<std::uint8_t>(k)}}, 0);
       },
       [](Level, std::uint64_t k, const Run&) {
         return micromap::text_of_states({1, Format::four_state, {static_cast<std::uint8_t>(k)}});
       },
       [](const ArraySubject& s, Level n, const std::string& at) {
         const micromap::Map map = micromap::map_from_text(n, at);
         if (map.format != Format::four_state) throw BadCase("4-state alone is lossy");
         return emulates(s, {map.level, map.format, map.packed}, 0);
       }});
}

Law emulation_on_samples() {
  return on_cases(
      {.id = "array.emulates_on_samples",
       .says = "the same of larger maps, at each level below",
       .source = "the KHR slides, Lossy Micromaps",
       .method = Method::sample,
       .subjects = {"array-spec", "array"},
       .tiers = {.fast = {2, 7}, .long_run = {2, 9}, .seconds = 1},
       .domain = [](const Subject&,
                    Level n) { return fmt::format("4-state maps of level {}, at levels 0..{}", n, n - 1); },
       .mutants = {mutant("the last block of level 3", "array", {4, 6},
                          emulating([](Level, Level most, Bytes& out) {
                            if (most == 3) out.back() = static_cast<std::uint8_t>(out.back() & 0x3f);
                          })),
                   mutant("two levels down at most", "array-spec", {4, 6},
                          [](Functions& f) {
                            f.emulate = [real = f.emulate](Level n, Level most,
                                                           std::span<const std::uint8_t> map) {
                              return real(n, std::max(most, n - 2), map);
                            };
                          }),
                   mutant("blocks of UO become O", "array", {2, 6}, emulating([](Level, Level, Bytes& out) {
                            for (std::uint8_t& b : out)
                              if (b == 0xff) b = 0x55;
                          }))}},
      {entry::emulate},
      drawn_cases(
          falling({{5, 100}}, 20),
          [](const ArraySubject& s, Level n, std::uint64_t seed, std::uint64_t k) {
            return emulates(s, four_state(n, seed, k), level_below(n, seed, k));
          },
          4));
}

// ---- Blocks

constexpr std::size_t longest_row = 10, most_codes = 7;

/// Every row of one to ten codes up to renaming: code k first occurs after k others.  Their numbers are Bell's, 1 + 2
/// + 5 + ... + 115,975.
std::vector<std::vector<std::uint32_t>> make_rows() {
  std::vector<std::vector<std::uint32_t>> all, last{{}};
  for (std::size_t length = 1; length <= longest_row; ++length) {
    std::vector<std::vector<std::uint32_t>> next;
    for (const auto& row : last) {
      const std::uint32_t codes = row.empty() ? 0 : *std::max_element(row.begin(), row.end()) + 1;
      for (std::uint32_t c = 0; c <= codes; ++c) {
        next.push_back(row);
        next.back().push_back(c);
      }
    }
    all.insert(all.end(), next.begin(), next.end());
    last = std::move(next);
  }
  return all;
}
const std::vector<std::vector<std::uint32_t>>& rows() {
  static const auto all = make_rows();
  return all;
}

std::string text_of_row(const std::vector<std::uint32_t>& row) {
  std::string text = "codes:";
  for (const std::uint32_t c : row) text += static_cast<char>('a' + c);
  return text;
}

std::size_t distinct(const std::vector<std::uint32_t>& row, std::size_t from, std::size_t to) {
  return std::set<std::uint32_t>(row.begin() + static_cast<std::ptrdiff_t>(from),
                                 row.begin() + static_cast<std::ptrdiff_t>(to))
      .size();
}

Finding cuts(const ArraySubject& s, const std::vector<std::uint32_t>& row) {
  const std::vector<std::uint64_t> sizes = s.functions.blocks(row);
  std::size_t at = 0;
  for (const std::uint64_t size : sizes) {
    if (size == 0 || size > row.size() - at)
      return wrong(fmt::format("blocks of {} triangles", row.size()), "others");
    if (const std::size_t codes = distinct(row, at, at + static_cast<std::size_t>(size)); codes > most_codes)
      return wrong(fmt::format("at most {} codes from triangle {}", most_codes, at),
                   fmt::format("{}", codes));
    at += static_cast<std::size_t>(size);
  }
  if (at != row.size())
    return wrong(fmt::format("blocks of {} triangles", row.size()), fmt::format("{}", at));
  // The fewest blocks that end at each triangle, over all cuts.
  std::vector<std::size_t> fewest(row.size() + 1, row.size());
  fewest[0] = 0;
  for (std::size_t end = 1; end <= row.size(); ++end)
    for (std::size_t from = 0; from < end; ++from)
      if (distinct(row, from, end) <= most_codes) fewest[end] = std::min(fewest[end], fewest[from] + 1);
  if (sizes.size() != fewest.back())
    return wrong(fmt::format("{} blocks", fewest.back()), fmt::format("{}", sizes.size()));
  return {hash_of(sizes)};
}

std::function<void(Functions&)> cutting(std::vector<std::uint64_t> (*cut)(std::span<const std::uint32_t>)) {
  return [cut](Functions& f) { f.blocks = cut; };
}

Law palettes() {
  return on_cases(
      {.id = "array.blocks",
       .says = "triangles in order are cut into the fewest blocks of at most 7 distinct codes",
       .source = "DGF: a block holds at most 7 distinct descriptors; docs/ARRAYS.md",
       .subjects = {"array-spec", "array"},
       .tiers = {.seconds = 3},
       .at_once = "all levels",
       .domain = "all rows of 1 to 10 triangles, whatever their codes are called: 142,417",
       .mutants = {mutant("8 codes a block", "array", {0, 0}, cutting([](std::span<const std::uint32_t> c) {
                            return spec::array::blocks(c, 8);
                          })),
                   mutant("a code that comes again counts again", "array-spec", {0, 0},
                          cutting([](std::span<const std::uint32_t> c) {
                            std::vector<std::uint64_t> sizes;
                            for (std::size_t at = 0; at < c.size(); at += 7)
                              sizes.push_back(std::min<std::size_t>(7, c.size() - at));
                            return sizes;
                          })),
                   mutant("the last triangle is left out after a full block", "array", {0, 0},
                          cutting([](std::span<const std::uint32_t> c) {
                            auto sizes = spec::array::blocks(c);
                            if (sizes.size() > 1 && sizes.back() == 1) sizes.pop_back();
                            return sizes;
                          }))}},
      {entry::blocks},
      {[](Level) { return std::uint64_t{rows().size()}; },
       [](const ArraySubject& s, Level, std::uint64_t k, const Run&) { return cuts(s, rows()[k]); },
       [](Level, std::uint64_t k, const Run&) { return text_of_row(rows()[k]); },
       [](const ArraySubject& s, Level, const std::string& at) {
         if (!at.starts_with("codes:") || at.size() == 6 || at.size() > 6 + 40 ||
             at.find_first_not_of("abcdefghijklmnopqrstuvwxyz", 6) != std::string::npos)
           throw BadCase("'" + at.substr(0, 60) + "': write codes:abcab");
         std::vector<std::uint32_t> row;
         for (const char c : at.substr(6)) row.push_back(static_cast<std::uint32_t>(c - 'a'));
         return cuts(s, row);
       }});
}

}  // namespace

std::vector<Law> device_laws() { return {emulation(), emulation_on_samples(), palettes()}; }

}  // namespace mmverify::proofs::array
