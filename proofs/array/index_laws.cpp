// What a code means: special, none, a record that is there, or one that is not.
#include <algorithm>
#include <array>

#include "proofs/array/law_groups.hpp"
#include "proofs/array/law_parts.hpp"
#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::array {
namespace {

namespace maps = mmverify::spec::micromap;

/// Bases and numbers of records: small ones all, and the borders of 32 bits.
constexpr std::array<std::uint32_t, 9> bases{0, 1, 2, 3, 250, 255, 256, 0xfffffffe, 0xffffffff};
constexpr std::array<std::uint32_t, 11> record_counts{0,   1,   2,   3,          4,         5,
                                                      251, 252, 256, 0xfffffffe, 0xffffffff};
constexpr std::uint64_t readings = 5 * 2 * bases.size() * record_counts.size();

Reading reading_number(std::uint64_t k) {
  Reading r;
  r.records = record_counts[k % record_counts.size()];
  k /= record_counts.size();
  r.base = bases[k % bases.size()];
  k /= bases.size();
  r.cluster = k % 2 != 0;
  r.encoding = maps::encodings[k / 2];
  return r;
}

/// All of 8 bits; of wider ones both ends, the middle, and what is beside the number of records, less the base.
std::vector<std::uint32_t> codes_for(const Reading& r) {
  std::vector<std::uint32_t> all;
  const std::uint64_t end = std::uint64_t{1} << maps::width(r.encoding);
  if (end == 256) {
    for (std::uint32_t c = 0; c < 256; ++c) all.push_back(c);
    return all;
  }
  for (std::uint32_t near = 0; near < 8; ++near)
    for (const std::uint64_t from :
         {std::uint64_t{0}, end - 8, end / 2 - 4, std::uint64_t{r.records} - r.base - 4})
      all.push_back(static_cast<std::uint32_t>((from + near) % end));
  return all;
}

std::string text_of_reading(const Reading& r) {
  return fmt::format("{},{},base={},records={}", name_of(r.encoding), r.cluster ? "cluster" : "mesh", r.base,
                     r.records);
}

Reading reading_of(const std::string& text) {
  const Groups parts =
      groups_of(text, "(u8|u16|u32|i16|i32),(cluster|mesh),base=([0-9]{1,10}),records=([0-9]{1,10})");
  if (!parts || std::stoull((*parts)[3]) > 0xffffffff || std::stoull((*parts)[4]) > 0xffffffff)
    throw BadCase("'" + text.substr(0, 60) + "': write u8,mesh,base=0,records=2");
  Reading r;
  for (const Encoding e : maps::encodings)
    if ((*parts)[1] == name_of(e)) r.encoding = e;
  r.cluster = (*parts)[2] == "cluster";
  r.base = static_cast<std::uint32_t>(std::stoull((*parts)[3]));
  r.records = static_cast<std::uint32_t>(std::stoull((*parts)[4]));
  return r;
}

Finding means(const ArraySubject& s, const Reading& r) {
  const std::vector<std::uint32_t> all = codes_for(r);
  const std::vector<Target> got = s.functions.targets(r, all);
  std::uint64_t digest = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Target right = spec::array::target(all[k], r.encoding, r.cluster, r.base, r.records);
    Target is = k < got.size() ? got[k] : Target{Target::Kind::outside};
    // Which record it would be says nothing more where there is none.
    if (right.kind == Target::Kind::outside && is.kind == Target::Kind::outside) is = right;
    if (is != right) return wrong(fmt::format("code {:#x}: {}", all[k], text_of(right)), text_of(is));
    digest = digest * 31 + static_cast<std::uint64_t>(right.kind) * 8 + right.record;
  }
  return {digest};
}

using Change = void (*)(const Reading&, std::uint32_t code, Target&);
std::function<void(Functions&)> meaning(Change change) {
  return spoils(&Functions::targets,
                [change](const Reading& r, std::span<const std::uint32_t> codes, std::vector<Target>& all) {
                  for (std::size_t k = 0; k < all.size(); ++k) change(r, codes[k], all[k]);
                });
}

}  // namespace

std::vector<Law> index_laws() {
  return {on_cases(
      {.id = "array.codes",
       .topic = "array",
       .says = "a code is a special index, in clusters -5 no micromap, or index + base triangle, which must "
               "be less than the "
               "number of records; the base is added to nothing else",
       .source = indices_source,
       .method = Method::exhaustive,
       .subjects = {"array-spec", "array"},
       .at_once = "all levels",
       .fast_seconds = 0.1,
       .domain = named_domain(
           "5 encodings, in clusters or not, 9 base triangles, 11 numbers of records; all codes of 8 bits, "
           "of wider ones 32 at the borders"),
       .mutants = {mutant("index + base may be the number of records", "array", {0, 0},
                          meaning([](const Reading& r, std::uint32_t, Target& to) {
                            if (to.kind == Target::Kind::outside && to.record == r.records)
                              to.kind = Target::Kind::record;
                          })),
                   mutant("the base triangle is added to special indices", "array-spec", {0, 0},
                          meaning([](const Reading& r, std::uint32_t code, Target& to) {
                            if (to.kind == Target::Kind::special && r.base == 3)
                              to = spec::array::target(
                                  (code + r.base) & (0xffffffffu >> (32 - maps::width(r.encoding))),
                                  r.encoding, r.cluster, 0, r.records);
                          })),
                   mutant("the sum has 32 bits", "array", {0, 0},
                          meaning([](const Reading& r, std::uint32_t code, Target& to) {
                            if (to.kind == Target::Kind::outside && code + r.base < r.records && code < 256)
                              to = {Target::Kind::record, State::T, code + r.base};
                          })),
                   mutant("-5 is an index in a cluster", "array-spec", {0, 0},
                          meaning([](const Reading& r, std::uint32_t code, Target& to) {
                            if (to.kind == Target::Kind::none)
                              to = spec::array::target(code, r.encoding, false, r.base, r.records);
                          })),
                   mutant("-5 is no micromap outside clusters", "array", {0, 0},
                          meaning([](const Reading& r, std::uint32_t code, Target& to) {
                            if (!r.cluster && r.encoding == Encoding::u8 && code == 0xfb)
                              to = {Target::Kind::none};
                          }))}},
      {entry::targets},
      {[](Level) { return readings; },
       [](const ArraySubject& s, Level, std::uint64_t k, const Run&) { return means(s, reading_number(k)); },
       [](Level, std::uint64_t k, const Run&) { return text_of_reading(reading_number(k)); },
       [](const ArraySubject& s, Level, const std::string& at) { return means(s, reading_of(at)); }, 32})};
}

}  // namespace mmverify::proofs::array
