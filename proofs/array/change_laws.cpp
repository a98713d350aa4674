// Compact, reorder, concatenate: each triangle resolves as before.
#include <set>

#include "proofs/array/cases.hpp"
#include "proofs/array/law_parts.hpp"
#include "proofs/array/laws.hpp"

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

/// A record's map; none where its level, its format or its place is none.
using ReadableMap = std::optional<std::pair<Format, States>>;
ReadableMap readable_map(const maps::Array& array, std::uint64_t record) {
  try {
    maps::Map map = spec::array::map_of(array, record);
    return std::pair(map.format, std::move(map.states));
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// The maps of all records, in no order.
std::multiset<ReadableMap> maps_of(const maps::Array& array) {
  std::multiset<ReadableMap> all;
  for (std::size_t r = 0; r < array.records.size(); ++r) all.insert(readable_map(array, r));
  return all;
}

/// A byte of the data that is no record's, or a record that has no map.
std::optional<Finding> loose(const Bundle& b) {
  std::vector<bool> used(b.array.data.size());
  for (std::size_t r = 0; r < b.array.records.size(); ++r) {
    const ReadableMap map = readable_map(b.array, r);
    if (!map) return wrong(fmt::format("record {} with a map", r), "none");
    std::fill_n(used.begin() + static_cast<std::ptrdiff_t>(b.array.records[r].offset),
                maps::packed_bytes(map->second.size(), map->first), true);
  }
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused == used.end()) return std::nullopt;
  return wrong("every byte is a record's", fmt::format("byte {} is none's", unused - used.begin()));
}

template <class F>
Finding judged(const Bundle& was, const Bundle& is, F more) {
  if (const auto other = resolved_differently(was, is)) return wrong(other->first, other->second);
  if (auto found = more()) return *found;
  return kept(is);
}

Finding compacts(const ArraySubject& s, const Bundle& was) {
  const Bundle is = s.functions.compact(was);
  return judged(was, is, [&]() -> std::optional<Finding> {
    const std::size_t records = records_in_use(was).size();
    if (is.array.records.size() != records)
      return wrong(fmt::format("{} records", records), fmt::format("{}", is.array.records.size()));
    return loose(is);
  });
}

Finding reorders(const ArraySubject& s, const Bundle& was) {
  const Bundle is = s.functions.reorder(was);
  return judged(was, is, [&]() -> std::optional<Finding> {
    if (auto found = loose(is)) return found;
    if (maps_of(was.array) != maps_of(is.array)) return wrong("the same records", "others");
    std::uint64_t next = 0;
    for (std::size_t p = 0; p < is.parts.size(); ++p)
      for (std::uint64_t t = 0; t < spec::array::triangles(is.parts[p]); ++t)
        if (const Target to = spec::array::target(is, is.parts[p], t); to.kind == Target::Kind::record) {
          if (to.record > next)
            return wrong(fmt::format("geometry {} triangle {}: at most record {}", p, t, next),
                         fmt::format("{}", to.record));
          if (to.record == next) ++next;
        }
    return std::nullopt;
  });
}

/// The first's records and geometries, then the second's, those included that no triangle refers to.
Finding concatenates(const ArraySubject& s, const Bundle& first, const Bundle& second) {
  const Bundle is = s.functions.concatenate(first, second);
  const std::size_t parts = first.parts.size(), records = first.array.records.size();
  if (is.parts.size() != parts + second.parts.size())
    return wrong(fmt::format("{} geometries", parts + second.parts.size()),
                 fmt::format("{}", is.parts.size()));
  Bundle of_first = is, of_second = is;
  of_first.parts.resize(parts);
  of_second.parts.erase(of_second.parts.begin(),
                        of_second.parts.begin() + static_cast<std::ptrdiff_t>(parts));
  if (const auto other = resolved_differently(first, of_first)) return wrong(other->first, other->second);
  return judged(second, of_second, [&]() -> std::optional<Finding> {
    const std::size_t all = records + second.array.records.size();
    if (is.array.records.size() != all)
      return wrong(fmt::format("{} records", all), fmt::format("{}", is.array.records.size()));
    for (std::size_t r = 0; r < all; ++r) {
      const auto was = r < records ? readable_map(first.array, r) : readable_map(second.array, r - records);
      if (readable_map(is.array, r) != was)
        return wrong(fmt::format("record {} as before", r), "another one");
    }
    return std::nullopt;
  });
}

// The arrays that laws on small arrays hand over.
Finding compacts_case(const ArraySubject& s, const BuildCase& c) { return compacts(s, shared_bundle_of(c)); }
Finding reorders_case(const ArraySubject& s, const BuildCase& c) { return reorders(s, shared_bundle_of(c)); }
Finding concatenates_case(const ArraySubject& s, const BuildCase& c) {
  // The second has the triangles from the last to the first, with other bases and codes.
  BuildCase turned = c;
  std::reverse(turned.maps.begin(), turned.maps.end());
  turned.options.encoding = Encoding::u32;
  return concatenates(s, bundle_of(c), bundle_of(turned));
}

using One = std::function<Bundle(const Bundle&)> Functions::*;
std::function<void(Functions&)> changing(One entry, void (*change)(const Bundle&, Bundle&)) {
  return spoils(entry, [change](const Bundle& was, Bundle& is) { change(was, is); });
}

using BundleCheck = Finding (*)(const ArraySubject&, const BuildCase&);
Law on_bundles(Law law, const Entry& needed, BundleCheck check) {
  law.tiers.fast = law.tiers.long_run = {1, 1};
  law.subjects = {"array-spec", "array"};
  law.source = here;
  law.domain =
      "1 and 2 triangles of the sorted maps of levels 0 and 1, both formats, every choice, all encodings, "
      "behind two records, each record with bytes of its own; two geometries";
  return on_cases(
      std::move(law), {needed},
      {[](Level n) { return n == 1 ? small_bundles() : 0; },
       [check](const ArraySubject& s, Level, std::uint64_t k, const Run&) {
         return check(s, bundle_number(k));
       },
       [](Level, std::uint64_t k, const Run&) { return text_of(bundle_number(k)); },
       [check](const ArraySubject& s, Level, const std::string& at) { return check(s, case_of(at)); }});
}

/// Each change that the subject has, of one array, or of it and the next one.
Finding changes(const ArraySubject& s, Level n, std::uint64_t seed, std::uint64_t k) {
  const Functions& f = s.functions;
  const Bundle was = sample_bundle(n, seed, k);
  Finding found;
  const auto goes_on = [&](const char* change, Finding next) {
    found.answer = found.answer * 31 + next.answer;
    if (!next.holds) {
      found = std::move(next);
      found.expected = std::string(change) + ": " + found.expected;
    }
    return found.holds;
  };
  if (f.compact && !goes_on("compacted", compacts(s, was))) return found;
  if (f.reorder && !goes_on("reordered", reorders(s, was))) return found;
  if (f.concatenate) goes_on("concatenated", concatenates(s, was, sample_bundle(n, seed, k + 1)));
  return found;
}

constexpr Entry any_change{"array_compact, array_reorder or array_concatenate",
                           [](const Functions& f) { return f.compact || f.reorder || f.concatenate; }};

Law changes_on_samples() {
  return on_cases(
      {.id = "array.changes_on_samples",
       .says = "compacted, reordered and put behind another one, each triangle of any array resolves as "
               "before, and no record is lost that is to stay",
       .source = here,
       .method = Method::sample,
       .subjects = {"array-spec", "array"},
       .tiers = {.fast = {0, 5}, .long_run = {0, 6}, .seconds = 0.8},
       .domain =
           [](Level n) {
             return fmt::format(
                 "arrays of up to 45 maps of levels up to {}, or 600 of level 0, in any order, with gaps and "
                 "over others; "
                 "up to eight geometries of up to 40 triangles, each of any encoding, base and indices",
                 n);
           },
       .mutants = {mutant("an array with a map of level 4 is empty", "array", {2, 5},
                          changing(&Functions::compact,
                                   [](const Bundle& was, Bundle& is) {
                                     for (const Record& r : was.array.records)
                                       if (r.level >= 4) is = {};
                                   })),
                   mutant("the third geometry's indices stay as they were", "array-spec", {0, 5},
                          changing(&Functions::reorder,
                                   [](const Bundle& was, Bundle& is) {
                                     if (was.parts.size() == 3) is.parts[2].indices = was.parts[2].indices;
                                   })),
                   mutant("indices of 16 bits lose their high byte", "array", {0, 3},
                          spoils(&Functions::concatenate,
                                 [](const Bundle& a, const Bundle&, Bundle& is) {
                                   for (Part& p : is.parts)
                                     if (p.encoding == Encoding::u16 && a.array.records.size() > 256)
                                       for (std::size_t t = 1; t < p.indices.size(); t += 2)
                                         if (p.indices[t] == 1) p.indices[t] = 0;
                                 })),
                   mutant("a state of a record that no triangle refers to is another one", "array-spec",
                          {1, 5},
                          changing(&Functions::reorder,
                                   [](const Bundle&, Bundle& is) {
                                     if (records_in_use(is).size() < is.array.records.size() &&
                                         is.array.records.back().level == is.array.records[0].level &&
                                         is.array.records.back().format == is.array.records[0].format)
                                       is.array.data.back() =
                                           static_cast<std::uint8_t>(is.array.data.back() ^ 1);
                                   }))}},
      {any_change}, drawn_cases(falling({{3, 200}}, 60), changes, 4));
}

void keep_base(const Bundle& was, Bundle& is) {
  for (std::size_t p = 0; p < is.parts.size(); ++p) is.parts[p].base = was.parts[p].base;
}

void keep_a_byte(const Bundle& was, Bundle& is) {
  if (is.array.records.size() < was.array.records.size()) is.array.data.push_back(0);
}

void move_special_index(const Bundle& was, Bundle& is) {
  for (std::size_t t = 0; t < is.parts[0].indices.size(); ++t)
    if (was.parts[0].base == 1 && is.parts[0].indices[t] == 0xfd) is.parts[0].indices[t] = 0;
}

void keep_order(Functions& f) {
  f.reorder = [](const Bundle& b) {
    std::vector<std::uint64_t> order;
    for (std::uint64_t r = 0; r < b.array.records.size(); ++r) order.push_back(r);
    return spec::array::arranged(b, order);
  };
}

void keep_second_base(const Bundle&, const Bundle& b, Bundle& is) { is.parts[1].base = b.parts[0].base; }

void keep_offsets(const Bundle& a, const Bundle& b, Bundle& is) {
  for (std::size_t r = 0; r < b.array.records.size(); ++r)
    is.array.records[a.array.records.size() + r].offset = b.array.records[r].offset;
}

void grow_indices(const Bundle& a, const Bundle&, Bundle& is) {
  for (std::size_t t = 0; t + 4 <= is.parts[1].indices.size(); t += 4)
    if (is.parts[1].indices[t + 3] == 0)
      is.parts[1].indices[t] = static_cast<std::uint8_t>(is.parts[1].indices[t] + a.array.records.size());
}

}  // namespace

std::vector<Law> change_laws() {
  return {on_bundles({.id = "array.compact",
                      .says = "compacted, each triangle resolves as before, every record is used, and every "
                              "byte is a record's",
                      .tiers = {.seconds = 0.5},
                      .mutants = {mutant("keeps a base triangle that is gone", "array", {1, 1},
                                         changing(&Functions::compact, keep_base)),
                                  mutant("drops records and keeps their bytes", "array-spec", {1, 1},
                                         changing(&Functions::compact, keep_a_byte)),
                                  mutant("drops nothing", "array", {1, 1},
                                         [](Functions& f) { f.compact = f.reorder; })}},
                     entry::compact, compacts_case),
          on_bundles(
              {.id = "array.reorder",
               .says = "reordered, each triangle resolves as before, and records come in the order of their "
                       "first use",
               .tiers = {.seconds = 0.5},
               .mutants = {mutant("indices stay as they were", "array", {1, 1},
                                  changing(&Functions::reorder,
                                           [](const Bundle& was, Bundle& is) { is.parts = was.parts; })),
                           mutant("special indices are moved, too", "array-spec", {1, 1},
                                  changing(&Functions::reorder, move_special_index)),
                           mutant("keeps the order of records", "array", {1, 1}, keep_order)}},
              entry::reorder, reorders_case),
          on_bundles({.id = "array.concatenate",
                      .says = "one array behind another: each triangle of both resolves as before, and all "
                              "records are there",
                      .tiers = {.seconds = 0.5},
                      .mutants = {mutant("the second's base triangle stays", "array", {1, 1},
                                         spoils(&Functions::concatenate, keep_second_base)),
                                  mutant("offsets stay", "array-spec", {1, 1},
                                         spoils(&Functions::concatenate, keep_offsets)),
                                  mutant("indices grow as well as the base", "array", {1, 1},
                                         spoils(&Functions::concatenate, grow_indices))}},
                     entry::concatenate, concatenates_case),
          changes_on_samples()};
}

}  // namespace mmverify::proofs::array
