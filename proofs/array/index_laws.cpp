// Laws of codes: a code names a special index, no micromap, a record, or a record that does not exist.
#include "proofs/array/law_parts.hpp"
#include "proofs/array/laws.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::array {
namespace {

namespace maps = mmverify::spec::micromap;

/// Bases and numbers of records: the smallest ones, those near 256, and the largest of 32 bits.
constexpr std::array<std::uint32_t, 9> bases{0, 1, 2, 3, 250, 255, 256, 0xfffffffe, 0xffffffff};
constexpr std::array<std::uint32_t, 11> record_counts{0,   1,   2,   3,          4,         5,
                                                      251, 252, 256, 0xfffffffe, 0xffffffff};
constexpr std::uint64_t readings = 5 * 2 * bases.size() * record_counts.size();

/// A reading of one geometry over one array.
struct Geometry {
  Reading how;
  std::uint32_t base = 0, records = 0;
};

Geometry reading_number(std::uint64_t k) {
  Geometry r;
  r.records = record_counts[k % record_counts.size()];
  k /= record_counts.size();
  r.base = bases[k % bases.size()];
  k /= bases.size();
  r.how = {maps::encodings[k / 2], k % 2 != 0};
  return r;
}

/// All codes of 8 bits.  Of wider ones both ends, the middle, and those beside the number of records less the base.
std::vector<Reference> codes_for(const Geometry& r) {
  std::vector<Reference> all;
  const std::uint64_t end = std::uint64_t{1} << maps::width(r.how.encoding);
  if (end == 256) {
    for (std::uint32_t c = 0; c < 256; ++c) all.push_back({c, r.base, r.records});
    return all;
  }
  for (std::uint32_t near = 0; near < 8; ++near)
    for (const std::uint64_t from :
         {std::uint64_t{0}, end - 8, end / 2 - 4, std::uint64_t{r.records} - r.base - 4})
      all.push_back({static_cast<std::uint32_t>((from + near) % end), r.base, r.records});
  return all;
}

std::string text_of_reading(const Geometry& r) {
  return fmt::format("{},{},base={},records={}", name_of(r.how.encoding), r.how.cluster ? "cluster" : "mesh",
                     r.base, r.records);
}

Geometry reading_of(const std::string& text) {
  const Groups parts =
      groups_of(text, "(u8|u16|u32|i16|i32),(cluster|mesh),base=([0-9]{1,10}),records=([0-9]{1,10})");
  if (!parts || std::stoull((*parts)[3]) > 0xffffffff || std::stoull((*parts)[4]) > 0xffffffff)
    throw BadCase("'" + text.substr(0, 60) + "': write u8,mesh,base=0,records=2");
  Geometry r;
  for (const Encoding e : maps::encodings)
    if ((*parts)[1] == name_of(e)) r.how.encoding = e;
  r.how.cluster = (*parts)[2] == "cluster";
  r.base = static_cast<std::uint32_t>(std::stoull((*parts)[3]));
  r.records = static_cast<std::uint32_t>(std::stoull((*parts)[4]));
  return r;
}

Finding mean(const ArraySubject& s, const Reading& r, const std::vector<Reference>& all) {
  const std::vector<Target> got = s.functions.targets(r, all);
  std::uint64_t digest = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto& [code, base, records] = all[k];
    const Target right = spec::array::target(code, r.encoding, r.cluster, base, records);
    Target is = k < got.size() ? got[k] : Target{Target::Kind::outside};
    // The number of a record that does not exist is not compared.
    if (right.kind == Target::Kind::outside && is.kind == Target::Kind::outside) is = right;
    if (is != right)
      return wrong(
          fmt::format("code {:#x} with base {}, {} records: {}", code, base, records, text_of(right)),
          text_of(is));
    digest = digest * 31 + static_cast<std::uint64_t>(right.kind) * 8 + right.record;
  }
  return {digest};
}
Finding means(const ArraySubject& s, const Geometry& r) { return mean(s, r.how, codes_for(r)); }

/// Up to 70 references of one batch, each with a base and a number of records of its own, of any size.  A code is at
/// the end of its width, beside the number of records less the base, or any.
std::pair<Reading, std::vector<Reference>> references_number(std::uint64_t seed, std::uint64_t k) {
  Random random(seed, 401, k);
  const Reading r{maps::encodings[random.below(5)], random.below(2) != 0};
  const std::uint64_t end = std::uint64_t{1} << maps::width(r.encoding);
  // A number of any count of bits, or one whose bytes are mostly corner values.
  const auto number = [&random] {
    return random.below(3) == 0 ? random.four_codes()
                                : static_cast<std::uint32_t>(random.next() >> (32 + random.below(32)));
  };
  std::vector<Reference> all(1 + random.below(70));
  for (Reference& of : all) {
    of.base = number();
    of.records = number();
    const std::uint64_t kind = random.below(3),
                        code = kind == 0   ? end - random.below(8)
                               : kind == 1 ? std::uint64_t{of.records} - of.base + random.below(5) - 2
                                           : random.four_codes();
    of.code = static_cast<std::uint32_t>(code % end);
  }
  return {r, all};
}

Finding mean_of_sample(const ArraySubject& s, Level, std::uint64_t seed, std::uint64_t k) {
  const auto [how, all] = references_number(seed, k);
  return mean(s, how, all);
}

using Change = void (*)(const Reading&, const Reference&, Target&);
std::function<void(Functions&)> meaning(Change change) {
  return spoils(&Functions::targets,
                [change](const Reading& r, std::span<const Reference> of, std::vector<Target>& all) {
                  for (std::size_t k = 0; k < all.size(); ++k) change(r, of[k], all[k]);
                });
}

Law codes_on_samples() {
  return on_cases(
      {.id = "array.codes_on_samples",
       .says =
           "the same of codes, base triangles and numbers of records that have nothing to do with each other",
       .source = indices_source,
       .method = Method::sample,
       .subjects = {"array-spec", "array"},
       .tiers = {.seconds = 0.1},
       .at_once = "all levels",
       .domain = "5 encodings, in clusters or not; 1 to 70 codes at once, each with a base "
                 "triangle and a number of records of its own",
       .mutants = {mutant("the first base triangle of a batch is everybody's", "array", {0, 0},
                          [](Functions& f) {
                            f.targets = [real = f.targets](const Reading& r, std::span<const Reference> of) {
                              std::vector<Reference> others(of.begin(), of.end());
                              for (Reference& one : others) one.base = others[0].base;
                              return real(r, others);
                            };
                          }),
                   mutant("the third byte of a code is lost", "array-spec", {0, 0},
                          meaning([](const Reading& r, const Reference& of, Target& to) {
                            if (r.encoding == Encoding::i32 && to.kind == Target::Kind::record)
                              to.record -= of.code & 0xFF0000;
                          })),
                   mutant("a number of records of 2^31 and more is none", "array", {0, 0},
                          meaning([](const Reading&, const Reference& of, Target& to) {
                            if (to.kind == Target::Kind::record && of.records >> 31 != 0 && of.base < 256)
                              to = {Target::Kind::outside};
                          }))}},
      {entry::targets}, drawn_cases(2'000, mean_of_sample, 64));
}

}  // namespace

std::vector<Law> index_laws() {
  return {
      on_cases(
          {.id = "array.codes",
           .says = "a code is a special index, in clusters -5 no micromap, or index + base triangle, which "
                   "must be less than the number of records; the base is added to nothing else",
           .source = indices_source,
           .subjects = {"array-spec", "array"},
           .tiers = {.seconds = 0.1},
           .at_once = "all levels",
           .domain = "5 encodings, in clusters or not, 9 base triangles, 11 numbers of records; "
                     "all codes of 8 bits, of wider ones 32 at the borders; a batch has one "
                     "base triangle and one number of records",
           .mutants = {mutant("index + base may be the number of records", "array", {0, 0},
                              meaning([](const Reading&, const Reference& of, Target& to) {
                                if (to.kind == Target::Kind::outside && to.record == of.records)
                                  to.kind = Target::Kind::record;
                              })),
                       mutant("the base triangle is added to special indices", "array-spec", {0, 0},
                              meaning([](const Reading& r, const Reference& of, Target& to) {
                                if (to.kind == Target::Kind::special && of.base == 3)
                                  to = spec::array::target(
                                      (of.code + of.base) & (0xffffffffu >> (32 - maps::width(r.encoding))),
                                      r.encoding, r.cluster, 0, of.records);
                              })),
                       mutant("the sum has 32 bits", "array", {0, 0},
                              meaning([](const Reading&, const Reference& of, Target& to) {
                                if (to.kind == Target::Kind::outside && of.code + of.base < of.records &&
                                    of.code < 256)
                                  to = {Target::Kind::record, State::T, of.code + of.base};
                              })),
                       mutant("-5 is an index in a cluster", "array-spec", {0, 0},
                              meaning([](const Reading& r, const Reference& of, Target& to) {
                                if (to.kind == Target::Kind::none)
                                  to = spec::array::target(of.code, r.encoding, false, of.base, of.records);
                              })),
                       mutant("-5 is no micromap outside clusters", "array", {0, 0},
                              meaning([](const Reading& r, const Reference& of, Target& to) {
                                if (!r.cluster && r.encoding == Encoding::u8 && of.code == 0xfb)
                                  to = {Target::Kind::none};
                              }))}},
          {entry::targets},
          {[](Level) { return readings; },
           [](const ArraySubject& s, Level, std::uint64_t k, const Run&) {
             return means(s, reading_number(k));
           },
           [](Level, std::uint64_t k, const Run&) { return text_of_reading(reading_number(k)); },
           [](const ArraySubject& s, Level, const std::string& at) { return means(s, reading_of(at)); }, 32}),
      codes_on_samples()};
}

}  // namespace mmverify::proofs::array
