// Compact, reorder, concatenate: each triangle resolves as before.
#include <set>

#include "proofs/array/bundles.hpp"
#include "proofs/array/law_groups.hpp"
#include "proofs/array/law_parts.hpp"

namespace mmverify::proofs::array {
namespace {

namespace maps = mmverify::spec::micromap;

/// One or two triangles of the 46 sorted maps of levels 0 and 1, every choice, behind two records of which nobody need use
/// one: (46 + 46^2) x 8.
constexpr std::uint64_t bundle_choices = 8;
std::uint64_t small_bundles() {
  const std::uint64_t sorted = sorted_maps(1).size();
  return (sorted + sorted * sorted) * bundle_choices;
}
BuildCase bundle_number(std::uint64_t k) {
  const auto& from = sorted_maps(1);
  const std::uint64_t choice = k % bundle_choices, rest = k / bundle_choices;
  BuildCase c;
  c.before = {{1, Format::two_state, {0x0c}}, {0, Format::four_state, {0x02}}};
  c.options.api = Api::glTF;
  c.options.encoding = maps::encodings[k % 5];
  c.options.special = (choice & 1) == 0;
  c.options.share = (choice & 2) == 0;
  c.options.base = (choice & 4) == 0 ? 0 : 1;
  if (rest < from.size())
    c.maps = {from[rest]};
  else
    c.maps = {from[(rest - from.size()) / from.size()], from[(rest - from.size()) % from.size()]};
  return c;
}

/// The array of a case with a second geometry: the same triangles from the last to the first, in 16 bits, over base 0.
Bundle shared_bundle_of(const BuildCase& c) {
  Bundle b = bundle_of(c);
  Part second{Encoding::u16, 0, {}};
  const std::uint64_t triangles = spec::array::triangles(b.parts[0]);
  for (std::uint64_t t = triangles; t-- > 0;) {
    const Target to = spec::array::target(b, b.parts[0], t);
    const std::uint32_t code = to.kind == Target::Kind::record ? static_cast<std::uint32_t>(to.record)
                                                               : maps::special_code(to.state, Encoding::u16);
    second.indices.push_back(static_cast<std::uint8_t>(code));
    second.indices.push_back(static_cast<std::uint8_t>(code >> 8));
  }
  b.parts.push_back(second);
  return b;
}

std::set<std::uint64_t> records_in_use(const Bundle& b) {
  std::set<std::uint64_t> all;
  for (const Part& part : b.parts)
    for (std::uint64_t t = 0; t < spec::array::triangles(part); ++t)
      if (const Target to = spec::array::target(b, part, t); to.kind == Target::Kind::record)
        all.insert(to.record);
  return all;
}

Finding kept(const Bundle& b) {
  Hash hash;
  hash.numbers(b.array.data);
  for (const Record& r : b.array.records) hash.number(r.offset);
  for (const Part& p : b.parts) hash.numbers(p.indices);
  return {hash.value()};
}

/// Nothing between, before and behind the records' bytes, in their order.
std::optional<Finding> loose(const Bundle& b) {
  std::uint64_t end = 0;
  for (std::size_t r = 0; r < b.array.records.size(); ++r) {
    if (b.array.records[r].offset != end)
      return wrong(fmt::format("record {} at byte {}", r, end), fmt::format("{}", b.array.records[r].offset));
    const maps::Map map = spec::array::map_of(b.array, r);
    end += maps::packed_bytes(map.states.size(), map.format);
  }
  if (end != b.array.data.size())
    return wrong(fmt::format("{} bytes of data", end), fmt::format("{}", b.array.data.size()));
  return std::nullopt;
}

template <class F>
Finding judged(const Bundle& was, const Bundle& is, F more) {
  if (const auto other = resolved_differently(was, is)) return wrong(other->first, other->second);
  if (auto found = more()) return *found;
  return kept(is);
}

Finding compacts(const ArraySubject& s, const BuildCase& c) {
  const Bundle was = shared_bundle_of(c), is = s.functions.compact(was);
  return judged(was, is, [&]() -> std::optional<Finding> {
    const std::size_t records = records_in_use(was).size();
    if (is.array.records.size() != records)
      return wrong(fmt::format("{} records", records), fmt::format("{}", is.array.records.size()));
    return loose(is);
  });
}

Finding reorders(const ArraySubject& s, const BuildCase& c) {
  const Bundle was = shared_bundle_of(c), is = s.functions.reorder(was);
  return judged(was, is, [&]() -> std::optional<Finding> {
    if (spec::array::array_histogram(was.array) != spec::array::array_histogram(is.array))
      return wrong("the same records", "others");
    std::uint64_t next = 0;
    for (std::uint64_t t = 0; t < spec::array::triangles(is.parts[0]); ++t)
      if (const Target to = spec::array::target(is, is.parts[0], t); to.kind == Target::Kind::record) {
        if (to.record > next)
          return wrong(fmt::format("triangle {}: at most record {}", t, next), fmt::format("{}", to.record));
        if (to.record == next) ++next;
      }
    return loose(is);
  });
}

Finding concatenates(const ArraySubject& s, const BuildCase& c) {
  // The second has the triangles from the last to the first, with other bases and codes.
  BuildCase turned = c;
  std::reverse(turned.maps.begin(), turned.maps.end());
  turned.options.encoding = Encoding::u32;
  const Bundle first = bundle_of(c), second = bundle_of(turned), is = s.functions.concatenate(first, second);
  if (is.parts.size() != 2) return wrong("2 geometries", fmt::format("{}", is.parts.size()));
  Bundle of_first = is, of_second = is;
  of_first.parts = {is.parts[0]};
  of_second.parts = {is.parts[1]};
  if (const auto other = resolved_differently(first, of_first)) return wrong(other->first, other->second);
  return judged(second, of_second, [&]() -> std::optional<Finding> {
    const std::size_t records = first.array.records.size() + second.array.records.size();
    if (is.array.records.size() != records)
      return wrong(fmt::format("{} records", records), fmt::format("{}", is.array.records.size()));
    return loose(is);
  });
}

using One = std::function<Bundle(const Bundle&)> Functions::*;
std::function<void(Functions&)> changing(One entry, void (*change)(const Bundle&, Bundle&)) {
  return spoils(entry, [change](const Bundle& was, Bundle& is) { change(was, is); });
}

using BundleCheck = Finding (*)(const ArraySubject&, const BuildCase&);
Law on_bundles(Law law, const Entry& needed, BundleCheck check) {
  law.method = Method::exhaustive;
  law.fast = law.long_run = {1, 1};
  law.subjects = {"array-spec", "array"};
  law.source = here;
  law.domain = named_domain(
      "1 and 2 triangles of the sorted maps of levels 0 and 1, both formats, every choice, all encodings, "
      "behind two "
      "records; two geometries");
  return on_cases(
      std::move(law), {needed},
      {[](Level n) { return n == 1 ? small_bundles() : 0; },
       [check](const ArraySubject& s, Level, std::uint64_t k, const Run&) {
         return check(s, bundle_number(k));
       },
       [](Level, std::uint64_t k, const Run&) { return text_of(bundle_number(k)); },
       [check](const ArraySubject& s, Level, const std::string& at) { return check(s, case_of(at)); }});
}

}  // namespace

std::vector<Law> change_laws() {
  return {on_bundles({.id = "array.compact",
                      .topic = "array",
                      .says = "compacted, each triangle resolves as before, every record is used, and every "
                              "byte is a record's",
                      .fast_seconds = 0.5,
                      .mutants = {mutant("keeps a base triangle that is gone", "array", {1, 1},
                                         changing(&Functions::compact,
                                                  [](const Bundle& was, Bundle& is) {
                                                    for (std::size_t p = 0; p < is.parts.size(); ++p)
                                                      is.parts[p].base = was.parts[p].base;
                                                  })),
                                  mutant("drops records and keeps their bytes", "array-spec", {1, 1},
                                         changing(&Functions::compact,
                                                  [](const Bundle& was, Bundle& is) {
                                                    if (is.array.records.size() < was.array.records.size())
                                                      is.array.data.push_back(0);
                                                  })),
                                  mutant("drops nothing", "array", {1, 1},
                                         [](Functions& f) { f.compact = f.reorder; })}},
                     entry::compact, compacts),
          on_bundles(
              {.id = "array.reorder",
               .topic = "array",
               .says = "reordered, each triangle resolves as before, and records come in the order of their "
                       "first use",
               .fast_seconds = 0.5,
               .mutants = {mutant("indices stay as they were", "array", {1, 1},
                                  changing(&Functions::reorder,
                                           [](const Bundle& was, Bundle& is) { is.parts = was.parts; })),
                           mutant("special indices are moved, too", "array-spec", {1, 1},
                                  changing(&Functions::reorder,
                                           [](const Bundle& was, Bundle& is) {
                                             for (std::size_t t = 0; t < is.parts[0].indices.size(); ++t)
                                               if (was.parts[0].base == 1 && is.parts[0].indices[t] == 0xfd)
                                                 is.parts[0].indices[t] = 0;
                                           })),
                           mutant("keeps the order of records", "array", {1, 1},
                                  [](Functions& f) {
                                    f.reorder = [](const Bundle& b) {
                                      std::vector<std::uint64_t> order;
                                      for (std::uint64_t r = 0; r < b.array.records.size(); ++r)
                                        order.push_back(r);
                                      return spec::array::arranged(b, order);
                                    };
                                  })}},
              entry::reorder, reorders),
          on_bundles({.id = "array.concatenate",
                      .topic = "array",
                      .says = "one array behind another: each triangle of both resolves as before, and all "
                              "records are there",
                      .fast_seconds = 0.5,
                      .mutants = {mutant("the second's base triangle stays", "array", {1, 1},
                                         spoils(&Functions::concatenate,
                                                [](const Bundle&, const Bundle& b, Bundle& is) {
                                                  is.parts[1].base = b.parts[0].base;
                                                })),
                                  mutant("offsets stay", "array-spec", {1, 1},
                                         spoils(&Functions::concatenate,
                                                [](const Bundle& a, const Bundle& b, Bundle& is) {
                                                  for (std::size_t r = 0; r < b.array.records.size(); ++r)
                                                    is.array.records[a.array.records.size() + r].offset =
                                                        b.array.records[r].offset;
                                                })),
                                  mutant("indices grow as well as the base", "array", {1, 1},
                                         spoils(&Functions::concatenate,
                                                [](const Bundle& a, const Bundle&, Bundle& is) {
                                                  for (std::size_t t = 0; t + 4 <= is.parts[1].indices.size();
                                                       t += 4)
                                                    if (is.parts[1].indices[t + 3] == 0)
                                                      is.parts[1].indices[t] = static_cast<std::uint8_t>(
                                                          is.parts[1].indices[t] + a.array.records.size());
                                                }))}},
                     entry::concatenate, concatenates)};
}

}  // namespace mmverify::proofs::array
