// Laws of builders: on all small arrays, and on samples of large ones.
#include "proofs/array/law_parts.hpp"
#include "proofs/array/laws.hpp"

namespace mmverify::proofs::array {
namespace {

namespace maps = mmverify::spec::micromap;

/// The only micro-triangle in which two maps differ; nothing if they differ in none or several.
std::optional<std::size_t> one_difference(const PackedMap& a, const PackedMap& b) {
  if (a.level != b.level || a.format != b.format) return std::nullopt;
  const States x = states_of(a), y = states_of(b);
  std::optional<std::size_t> at;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] == y[i]) continue;
    if (at) return std::nullopt;
    at = i;
  }
  return at;
}

/// The bug of merging: a map that differs in one micro-triangle from a map that is transparent there becomes that
/// map, even if the micro-triangle was opaque.
void merge_into_transparent(BuildCase& c) {
  for (std::size_t t = 1; t < c.maps.size(); ++t)
    for (std::size_t earlier = 0; earlier < t; ++earlier)
      if (const auto at = one_difference(c.maps[t], c.maps[earlier]);
          at && states_of(c.maps[earlier])[*at] == State::T) {
        c.maps[t] = c.maps[earlier];
        break;
      }
}

/// The bug of formats: all maps take the first triangle's format.
void take_the_first_format(BuildCase& c) {
  for (PackedMap& m : c.maps) {
    States s = states_of(m);
    if (c.maps.front().format == Format::two_state) s = maps::force2(s);
    m = packed(m.level, c.maps.front().format, s);
  }
}

/// Every triangle's map is refined to the finest level.
void take_the_finest_level(BuildCase& c) {
  Level finest = 0;
  for (const PackedMap& m : c.maps) finest = std::max(finest, m.level);
  for (PackedMap& m : c.maps)
    while (m.level < finest) m = packed(m.level + 1, m.format, maps::up(states_of(m)));
}

Law resolving() {
  return on_small_arrays(
      {.id = "array.resolves",
       .says = "through index, base triangle, record and data each triangle resolves to what was baked",
       .source = array_source,
       .subjects = {"array-spec", "array"},
       .tiers = {.seconds = 4},
       .mutants = {mutant("a map that differs little from a transparent one becomes it", "array", {0, 1},
                          building(merge_into_transparent)),
                   mutant("the last micro-triangle is transparent in 2-state", "array-spec", {1, 1},
                          building([](BuildCase& c) {
                            for (PackedMap& m : c.maps)
                              if (m.level == 1 && m.format == Format::two_state && m.bytes[0] == 0x09)
                                m.bytes[0] = 0x01;
                          })),
                   mutant("an offset counts maps, not bytes", "array", {1, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            if (c.maps.size() == 3 && a.records.size() == 24) --a.records[16];
                          })),
                   mutant("of three triangles the third has the second's index", "array", {0, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            if (c.maps.size() == 3 && c.maps[2].level == 0)
                              set_code(a, c, 2, code_of(a, c, 1));
                          }))}},
      resolves);
}

Law formats() {
  return on_small_arrays(
      {.id = "array.formats",
       .says = "the record of each triangle has the level and the format that were asked for that triangle",
       .source = array_source,
       .subjects = {"array-spec", "array"},
       .tiers = {.seconds = 4},
       .mutants = {mutant("all triangles have the first one's format", "array", {0, 1},
                          building(take_the_first_format)),
                   mutant("all triangles have the finest level", "array-spec", {1, 1},
                          building(take_the_finest_level)),
                   mutant("4-state without an unknown state is stored in 2-state", "array", {0, 1},
                          building([](BuildCase& c) {
                            for (PackedMap& m : c.maps) {
                              const States s = states_of(m);
                              if (std::none_of(s.begin(), s.end(), maps::unknown))
                                m = packed(m.level, Format::two_state, s);
                            }
                          }))}},
      keeps_formats);
}

Law special_indices() {
  return on_small_arrays(
      {.id = "array.special_indices",
       .says = "a uniform triangle has its special index in the width of the indices, whatever the base "
               "triangle, where that is wanted; no other triangle has one",
       .source = indices_source,
       .subjects = {"array-spec", "array"},
       .tiers = {.seconds = 4},
       .mutants = {mutant("the base triangle is added to special indices", "array", {0, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            for (std::size_t t = 0; t < c.maps.size(); ++t)
                              if (target_of(a, c, t).kind == Target::Kind::special)
                                set_code(a, c, t, code_of(a, c, t) + c.options.base);
                          })),
                   mutant("a special index of 16 bits in 32", "array-spec", {0, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            if (c.options.encoding != Encoding::u32) return;
                            for (std::size_t t = 0; t < c.maps.size(); ++t)
                              if (code_of(a, c, t) >= 0xfffffffc)
                                set_code(a, c, t, code_of(a, c, t) & 0xffff);
                          })),
                   mutant("special though it was not asked for", "array", {0, 1},
                          building([](BuildCase& c) { c.options.special = true; })),
                   mutant("a map of level 1 that is all UO stays a record", "array-spec", {1, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            if (c.maps.size() == 1 && c.maps[0].bytes[0] == 0xff && code_of(a, c, 0) % 4 == 0)
                              set_code(a, c, 0, 0);
                          }))}},
      uses_special_indices);
}

void leave_base_on(const BuildCase& c, Answer& a) {
  for (std::size_t t = 0; t < c.maps.size(); ++t)
    if (target_of(a, c, t).kind == Target::Kind::record) set_code(a, c, t, code_of(a, c, t) + c.options.base);
}

Law range() {
  return on_small_arrays(
      {.id = "array.index_range",
       .says = "every index that is not special names, with the base triangle, a record that is there",
       .source = indices_source,
       .subjects = {"array-spec", "array"},
       .tiers = {.seconds = 4},
       .mutants = {mutant("the base triangle is not taken off", "array", {0, 1}, answering(leave_base_on)),
                   mutant("the last index may be the number of records", "array-spec", {1, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            if (c.maps.size() == 3 && c.options.encoding == Encoding::u16 &&
                                code_of(a, c, 2) + std::uint64_t{1} == record_count(a))
                              set_code(a, c, 2, static_cast<std::uint32_t>(record_count(a)));
                          })),
                   mutant("indices of 8 bits lose the sign of a special one", "array", {0, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            if (c.options.encoding == Encoding::u8 && c.maps.size() == 2 &&
                                code_of(a, c, 1) == 0xfc)
                              set_code(a, c, 1, 0x7c);
                          }))}},
      stays_in_range);
}

Law array_counts() {
  return on_small_arrays({.id = "array.array_histogram",
                          .says = "the array's usage counts are its records', by level and format, each once "
                                  "however many triangles share it",
                          .source = counts_source,
                          .subjects = {"array-spec", "array"},
                          .tiers = {.seconds = 4},
                          .mutants = {mutant("the geometry's histogram is handed over", "array", {0, 1},
                                             answering([](const BuildCase& c, Answer& a) {
                                               if (spec::array::requirements(c.options.api).counts_geometry)
                                                 a.array_counts = a.geometry_counts;
                                             })),
                                      mutant("what was there before is not counted", "array-spec", {1, 1},
                                             answering([](const BuildCase& c, Answer& a) {
                                               if (!c.before.empty() && !a.array_counts.empty())
                                                 --a.array_counts.back().count;
                                             })),
                                      mutant("level and format change places", "array", {0, 1},
                                             answering([](const BuildCase&, Answer& a) {
                                               for (UsageCount& u : a.array_counts)
                                                 std::swap(u.level, u.format);
                                             }))}},
                         counts_records);
}

Law geometry_counts() {
  return on_small_arrays(
      {.id = "array.geometry_histogram",
       .says = "where the API takes them the geometry's usage counts are its references after indirection, "
               "the base triangle added, special indices left out; elsewhere there are none",
       .source = counts_source,
       .subjects = {"array-spec", "array"},
       .tiers = {.seconds = 4},
       .mutants = {mutant("the array's histogram is handed over", "array", {0, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            if (spec::array::requirements(c.options.api).counts_geometry)
                              a.geometry_counts = a.array_counts;
                          })),
                   mutant("special indices are counted", "array-spec", {0, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            if (!spec::array::requirements(c.options.api).counts_geometry) return;
                            for (std::size_t t = 0; t < c.maps.size(); ++t)
                              if (target_of(a, c, t).kind == Target::Kind::special)
                                a.geometry_counts.push_back(
                                    {1, c.maps[t].level, static_cast<std::uint32_t>(c.maps[t].format)});
                          })),
                   mutant("the base triangle is not added", "array", {1, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            if (c.options.base == 0 || a.geometry_counts.empty()) return;
                            std::vector<UsageCount> wrongly;
                            for (std::size_t t = 0; t < c.maps.size(); ++t) {
                              const std::uint32_t code = code_of(a, c, t);
                              if (code >= record_count(a)) continue;
                              const Record r = maps::record_at(a.records, code * maps::record_bytes);
                              wrongly.push_back({1, r.level, r.format});
                            }
                            a.geometry_counts = wrongly;
                          })),
                   mutant("there is a second histogram for DXR", "array-spec", {0, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            if (c.options.api == Api::DXR) a.geometry_counts = a.array_counts;
                          }))}},
      counts_references);
}

Law sharing() {
  return on_small_arrays({.id = "array.shares",
                          .says = "equal maps share a record where that is wanted, different ones never do, "
                                  "and no record is added that nobody uses",
                          .source = here,
                          .subjects = {"array-spec", "array"},
                          .tiers = {.seconds = 4},
                          .mutants = {mutant("equal maps are not shared where they are neighbours", "array",
                                             {0, 1}, building([](BuildCase& c) {
                                               if (c.maps.size() == 2 && c.maps[0] == c.maps[1])
                                                 c.options.share = false;
                                             })),
                                      mutant("shares though not asked to", "array-spec", {0, 1},
                                             building([](BuildCase& c) { c.options.share = true; })),
                                      mutant("a record that nobody uses stays at the end", "array", {1, 1},
                                             answering([](const BuildCase& c, Answer& a) {
                                               if (c.maps.size() == 3 && a.records.size() >= 16)
                                                 a.records.insert(a.records.end(), a.records.begin(),
                                                                  a.records.begin() + 8);
                                             }))}},
                         shares);
}

Law keeping() {
  return on_small_arrays(
      {.id = "array.keeps_before",
       .says = "records that were there before stay where they are, with the maps that they had",
       .source = here,
       .subjects = {"array-spec", "array"},
       .tiers = {.seconds = 3},
       .mutants = {mutant("new records come first", "array", {1, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            if (!c.before.empty() && record_count(a) > c.before.size())
                              std::swap_ranges(a.records.begin(), a.records.begin() + 8,
                                               a.records.begin() + 8);
                          })),
                   mutant("a byte of the data before is written over", "array-spec", {0, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            if (!c.before.empty() && c.maps.size() == 2) a.data[0] = c.maps[1].bytes[0];
                          })),
                   mutant("nothing is kept where nothing is added", "array", {0, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            if (record_count(a) == c.before.size()) a.records.clear();
                          }))}},
      keeps_what_was_there);
}

/// Runs every check and returns the first finding that fails.
Finding all_checks(const Answer& a, const BuildCase& c) {
  for (const Check check : {stays_in_range, resolves, keeps_formats, uses_special_indices, counts_records,
                            counts_references, keeps_what_was_there})
    if (Finding found = check(a, c); !found.holds) return found;
  return c.options.bound > 0 ? Finding{digest_of(a)} : shares(a, c);
}

void cut_indices_to_8_bits(Functions& f) {
  f.build = [real = f.build](const BuildCase& c) {
    std::optional<Answer> a = real(c);
    if (a || c.options.encoding != Encoding::u8) return a;
    BuildCase wide = c;
    wide.options.encoding = Encoding::u16;
    a = real(wide);
    for (std::size_t t = 0; t < c.maps.size(); ++t) a->indices[t] = a->indices[2 * t];
    a->indices.resize(c.maps.size());
    return a;
  };
}

Law sampled() {
  return on_cases(
      {.id = "array.on_samples",
       .says = "all of these at once: ranges, states, formats, special indices, both histograms, sharing, "
               "what was there",
       .source = array_source,
       .method = Method::sample,
       .subjects = {"array-spec", "array"},
       .tiers = {.fast = {0, 5}, .long_run = {0, 7}, .seconds = 3},
       .domain =
           [](Level n) {
             return fmt::format(
                 "up to 40 maps of levels 0..{} after up to 5, all APIs, encodings, choices and base "
                 "triangles; half of them with merging of up to 6; 1 of 50 has 248 to 256 records more, for "
                 "indices of 8 bits",
                 n);
           },
       .mutants = {mutant("a bit of the last byte of the data", "array", {2, 5},
                          answering([](const BuildCase& c, Answer& a) {
                            if (c.maps.size() == 20 && !a.data.empty()) a.data.back() ^= 0x80;
                          })),
                   mutant("the base triangle is not taken off signed indices", "array", {0, 5},
                          answering([](const BuildCase& c, Answer& a) {
                            if (c.options.encoding == Encoding::i16) leave_base_on(c, a);
                          })),
                   mutant("indices of 16 bits are cut to 8", "array", {0, 5}, cut_indices_to_8_bits),
                   mutant("the last state of a map of level 4", "array", {4, 5}, building([](BuildCase& c) {
                            for (PackedMap& m : c.maps)
                              if (m.level == 4) m.bytes.back() ^= 0x80;
                          })),
                   mutant("merges one more than the bound", "array", {2, 5}, building([](BuildCase& c) {
                            if (c.options.bound == 4) ++c.options.bound;
                          })),
                   mutant("NVAPI has one histogram", "array-spec", {0, 5},
                          answering([](const BuildCase& c, Answer& a) {
                            if (c.options.api == Api::NVAPI) a.geometry_counts.clear();
                          }))}},
      {entry::build},
      drawn_cases(
          falling({{4, 600}}, 150),
          [](const ArraySubject& s, Level n, std::uint64_t seed, std::uint64_t k) {
            return built(s, sample_array(n, seed, k, k % 2 == 0 ? 0 : 6), all_checks);
          },
          16));
}

Law whole() {
  return on_cases(
      {.id = "array.resolves_whole",
       .says = "array.resolves, .formats and both histograms on every array of three triangles of levels 0 "
               "and 1, sorted or not",
       .source = array_source,
       .subjects = {"array"},
       .tiers = {.fast = {1, 1}, .long_run = {1, 1}, .seconds = 200},
       .domain = "all 278^3 arrays of three triangles, both formats, indices of 8, 16 and 32 "
                 "bits; special indices and sharing",
       .mutants = {mutant("three maps of one byte are one", "array", {1, 1}, building([](BuildCase& c) {
                            if (c.maps[0].bytes == Bytes{0x1b} && c.maps[2].bytes == Bytes{0x1e})
                              c.maps[2] = c.maps[0];
                          })),
                   mutant("formats of three triangles turn", "array", {1, 1}, building([](BuildCase& c) {
                            if (c.maps[0].format == Format::two_state &&
                                c.maps[1].format == Format::four_state &&
                                c.maps[2].format == Format::two_state && c.maps[2].bytes[0] == 6)
                              c.maps[2] = packed(c.maps[2].level, Format::four_state, states_of(c.maps[2]));
                          })),
                   mutant("a third triangle is not counted", "array", {1, 1},
                          answering([](const BuildCase& c, Answer& a) {
                            if (c.maps[2].bytes[0] == 0x72 && c.maps[1].bytes[0] == 0x71 &&
                                !a.geometry_counts.empty())
                              --a.geometry_counts.back().count;
                          }))},
       .long_only = true},
      {entry::build},
      built_cases([](Level n) { return n == 1 ? whole_small_arrays() : 0; },
                  [](Level, std::uint64_t k) { return whole_small_array(k); }, all_checks, 4096));
}

}  // namespace

std::vector<Law> build_laws() {
  return {resolving(),       formats(), special_indices(), range(),   array_counts(),
          geometry_counts(), sharing(), keeping(),         sampled(), whole()};
}

}  // namespace mmverify::proofs::array
