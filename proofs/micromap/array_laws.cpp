// Laws of arrays: a built array gives every state back and is valid, and the validator lists the specification's
// violations.
#include <set>

#include "proofs/engine/spoils.hpp"
#include "proofs/micromap/arrays.hpp"
#include "proofs/micromap/law_parts.hpp"
#include "proofs/micromap/laws.hpp"
#include "proofs/micromap/maps.hpp"

namespace mmverify::proofs::micromap {
namespace {

namespace slow = mmverify::spec::micromap;
using slow::Rule;

std::string text(const Violation& v) {
  return fmt::format("{} at {} ({}, {})", slow::text(v.rule).id, v.where, v.found, v.other);
}

std::uint64_t hash_of(const std::vector<Violation>& found) {
  std::uint64_t hash = found.size();
  for (const Violation& v : found)
    hash = (hash * 31 + static_cast<std::uint64_t>(v.rule)) * 31 + v.where * 7 + v.found * 3 + v.other;
  return hash;
}

// ---- Building

// The states of a triangle, found as a traversal finds them; for a special index, `count` times its state.
States fetched(const Built& b, const Options& o, std::uint64_t t, std::uint64_t count) {
  const Meaning m =
      slow::meaning(slow::code_at(b.indices, o.encoding, slow::width(o.encoding) / 8, t), o.encoding);
  if (m.kind == Meaning::Kind::special) return States(static_cast<std::size_t>(count), m.state);
  const slow::Record r = slow::record_at(b.records, 8 * (std::uint64_t{m.index} + o.base_triangle));
  return slow::unpack(std::span(b.data).subspan(r.offset), static_cast<Format>(r.format), count);
}

/// A built array with its indices, without a geometry's counts, by glTF's rules.
Input input_of(const Built& built, const BuildCase& c) {
  Input in;
  in.sets = slow::glTF;
  in.records = built.records;
  in.record_count = built.records.size() / slow::record_bytes;
  in.data = built.data;
  in.triangles = c.maps.size();
  in.indexed = true;
  in.indices = built.indices;
  in.encoding = c.options.encoding;
  in.index_stride = slow::width(c.options.encoding) / 8;
  in.base_triangle = c.options.base_triangle;
  in.array_counts = built.array_counts;
  return in;
}

Finding builds(const MicromapSubject& s, const BuildCase& c) {
  const Options& o = c.options;
  const Built built = s.functions.build(c.before, c.maps, o);

  // Validity first: then nothing below reads outside.
  Input in = input_of(built, c);
  if (const auto found = slow::validate(in); !found.empty())
    return wrong("a clean array", text(found.front()));
  in.sets = slow::EXT;
  in.geometry_counts = built.geometry_counts;
  for (const Violation& v : slow::validate(in))
    if (v.rule != Rule::index_encoding) return wrong("a clean geometry", text(v));

  // Sharing: the new records are the different maps without a special index that no record from the base triangle on
  // has. Without sharing each such triangle has a new record.
  std::set<std::tuple<Level, Format, Bytes>> different;
  for (std::size_t r = o.base_triangle; r < c.before.size(); ++r)
    different.insert({c.before[r].level, c.before[r].format, c.before[r].bytes});
  const std::size_t there = different.size();
  std::size_t stored = 0;
  for (std::size_t t = 0; t < c.maps.size(); ++t) {
    const PackedMap& map = c.maps[t];
    const States states = slow::unpack(map.bytes, map.format, slow::micro_triangles(map.level));
    const bool special = o.special && slow::uniform(states);
    const Meaning m = slow::meaning(slow::code_at(built.indices, o.encoding, in.index_stride, t), o.encoding);
    if ((m.kind == Meaning::Kind::special) != special)
      return wrong(fmt::format("triangle {} {}", t, special ? "special" : "indexed"),
                   special ? "indexed" : "special");
    if (!special) {
      ++stored;
      different.insert({map.level, map.format, map.bytes});
      const slow::Record r = slow::record_at(built.records, 8 * (std::uint64_t{m.index} + o.base_triangle));
      if (r.level != map.level || r.format != static_cast<std::uint16_t>(map.format))
        return wrong(
            fmt::format("triangle {}: level {}, format {}", t, map.level, static_cast<int>(map.format)),
            fmt::format("level {}, format {}", r.level, r.format));
    }
    const States got = fetched(built, o, t, states.size());
    for (std::size_t i = 0; i < states.size(); ++i)
      if (got[i] != states[i])
        return wrong(fmt::format("triangle {} state {} {}", t, i, slow::code(states[i])),
                     fmt::format("{}", slow::code(got[i])));
  }
  // Earlier records are unchanged, and come first.
  for (std::size_t r = 0; r < c.before.size(); ++r) {
    const PackedMap& map = c.before[r];
    const slow::Record record = slow::record_at(built.records, 8 * r);
    const auto bytes = std::span(built.data).subspan(record.offset, map.bytes.size());
    if (record.level != map.level || record.format != static_cast<std::uint16_t>(map.format) ||
        !std::equal(bytes.begin(), bytes.end(), map.bytes.begin()))
      return wrong(fmt::format("record {} as before", r), "another map");
  }
  const std::size_t records = c.before.size() + (o.deduplicate ? different.size() - there : stored);
  if (in.record_count != records)
    return wrong(fmt::format("{} records", records), fmt::format("{}", in.record_count));
  return {proofs::hash_of(built.data) ^ proofs::hash_of(built.indices), true, {}, {}};
}

void drop_bit(Bytes& bytes, std::size_t byte, unsigned bit) {
  if (byte < bytes.size()) bytes[byte] = static_cast<std::uint8_t>(bytes[byte] ^ 1u << bit);
}

bool are(std::span<const PackedMap> maps, Level n, std::initializer_list<std::uint8_t> first_bytes) {
  if (maps.size() != first_bytes.size()) return false;
  std::size_t k = 0;
  for (const std::uint8_t byte : first_bytes) {
    if (maps[k].level != n || maps[k].format != Format::four_state || maps[k].bytes != Bytes{byte})
      return false;
    ++k;
  }
  return true;
}

/// A mutant that builds with other options.
template <class Choose>
auto builds_otherwise(Choose choose) {
  return [=](Functions& functions) {
    functions.build = [choose, real = functions.build](auto before, auto maps, Options options) {
      choose(maps, options);
      return real(before, maps, options);
    };
  };
}

BuildCase pair_of(std::initializer_list<Map> two) {
  BuildCase c;
  for (const Map& map : two) c.maps.push_back({map.level, map.format, map.packed});
  c.options = {Encoding::u8, 0, true, true};
  return c;
}

BuildCase pair_number(Level n, std::uint64_t k) {
  const std::uint64_t maps = map_count(n);
  return pair_of({map_number(n, k / maps), map_number(n, k % maps)});
}

std::string text_of_pair(const BuildCase& c) {
  std::string line;
  for (const PackedMap& m : c.maps)
    line += (line.empty() ? "" : "|") + text_of_states({m.level, m.format, m.bytes});
  return line;
}

// Every ordered pair of maps of one small level, with sharing and special indices.
Law pairs() {
  return on_cases(
      {.id = "micromap.build",
       .says = "a built array is clean, gives every state back, shares equal maps and has no others",
       .source = packing_source,
       .subjects = {"micromap-spec", "micromap"},
       .tiers = {.fast = {0, 1}, .long_run = {0, 1}, .seconds = 3},
       .domain =
           [](Level n) { return fmt::format("all ordered pairs of maps of level {}, both formats", n); },
       .mutants = {mutant("two maps that differ in one state share a record", "micromap", {1, 1},
                          spoils(&Functions::build,
                                 [](auto, auto maps, const Options&, Built& b) {
                                   if (are(maps, 1, {0xe4, 0xe5})) b.indices[1] = 0;
                                 })),
                   mutant("the geometry's counts are the array's", "micromap-spec", {1, 1},
                          spoils(&Functions::build,
                                 [](auto, auto maps, const Options&, Built& b) {
                                   if (are(maps, 1, {0x1b, 0x1b})) b.geometry_counts = b.array_counts;
                                 })),
                   mutant("equal maps are not shared", "micromap", {1, 1},
                          builds_otherwise([](auto maps, Options& o) {
                            if (are(maps, 1, {0x40, 0x40})) o.deduplicate = false;
                          }))}},
      {entry::build},
      {[](Level n) -> std::uint64_t { return n > 1 ? 0 : map_count(n) * map_count(n); },
       [](const MicromapSubject& s, Level n, std::uint64_t k, const Run&) {
         return builds(s, pair_number(n, k));
       },
       [](Level n, std::uint64_t k, const Run&) { return text_of_pair(pair_number(n, k)); },
       [](const MicromapSubject& s, Level n, const std::string& text) {
         const auto bar = text.find('|');
         if (bar == std::string::npos) throw BadCase("'" + text + "': write 4-state:0123|2-state:0110");
         return builds(
             s, pair_of({map_from_text(n, text.substr(0, bar)), map_from_text(n, text.substr(bar + 1))}));
       },
       1024});
}

void drop_last_bit(std::span<const PackedMap>, std::span<const PackedMap> maps, const Options& o, Built& b) {
  if (o.encoding == Encoding::i16 && !maps.empty() && maps.back().level == 5 && !b.data.empty())
    drop_bit(b.data, b.data.size() - 1, 7);
}

Law sampled_builds() {
  return on_cases(
      {.id = "micromap.build_on_samples",
       .says = "a built array is clean, gives every state back, and shares equal maps where asked to",
       .source = packing_source,
       .method = Method::sample,
       .subjects = {"micromap-spec", "micromap"},
       .tiers = {.fast = {0, 5}, .long_run = {0, 7}, .seconds = 3},
       .domain =
           [](Level n) {
             return fmt::format(
                 "up to 23 maps of levels 0..{} after up to 5, all encodings, options and base triangles", n);
           },
       .mutants = {mutant("a bit of the last byte of a map of level 5", "micromap", {5, 5},
                          spoils(&Functions::build, drop_last_bit)),
                   mutant("shares a record before the base triangle", "micromap-spec", {0, 5},
                          builds_otherwise([](auto, Options& o) {
                            if (o.deduplicate && o.base_triangle == 3) o.base_triangle = 0;
                          })),
                   mutant("an offset one too far at level 4", "micromap", {4, 4},
                          spoils(&Functions::build,
                                 [](auto, auto maps, const Options&, Built& b) {
                                   if (maps.size() == 12 && b.records.size() >= 8)
                                     ++b.records[b.records.size() - 8];
                                 }))}},
      {entry::build},
      {falling({{4, 400}}, 100),
       [](const MicromapSubject& s, Level n, std::uint64_t k, const Run& run) {
         return builds(s, sample_build(n, run.seed, k));
       },
       [](Level, std::uint64_t k, const Run& run) { return text_of(run.seed, k); },
       [](const MicromapSubject& s, Level n, const std::string& text) {
         const auto [seed, k] = sample_from(text);
         return builds(s, sample_build(n, seed, k));
       },
       16});
}

// ---- Validating

Finding validates(const MicromapSubject& s, const Input& in) {
  const std::vector<Violation> expected = slow::validate(in), got = s.functions.validate(in);
  if (got == expected) return {hash_of(expected), true, {}, {}};
  std::size_t k = 0;
  while (k < expected.size() && k < got.size() && expected[k] == got[k]) ++k;
  const auto at = [k](const std::vector<Violation>& all) {
    return k < all.size() ? text(all[k]) : std::string("no more violations");
  };
  return wrong(at(expected), at(got));
}

// Drops the first violation of a rule.
auto misses(Rule rule, std::uint64_t at_least = 0) {
  return spoils(&Functions::validate, [=](const Input& in, std::vector<Violation>& found) {
    if (in.record_count < at_least) return;
    for (std::size_t k = 0; k < found.size(); ++k)
      if (found[k].rule == rule) {
        found.erase(found.begin() + static_cast<std::ptrdiff_t>(k));
        return;
      }
  });
}

Law validating() {
  return on_cases(
      {.id = "micromap.validate",
       .says = "the validator lists exactly the violations that the rules have, rule by rule",
       .source = "the rules' sources, docs/MICROMAP.md",
       .method = Method::sample,
       .subjects = {"micromap"},
       .tiers = {.fast = {0, 5}, .long_run = {0, 7}, .seconds = 4},
       .domain =
           [](Level n) {
             return fmt::format(
                 "arrays of up to 28 maps of levels 0..{}, up to three things spoilt, all sets", n);
           },
       .mutants = {mutant("overlap is missed in arrays of 8 records and more", "micromap", {3, 5},
                          misses(Rule::record_overlap, 8)),
                   mutant("the histograms' exchange is not seen at level 4", "micromap", {4, 5},
                          misses(Rule::counts_array_is_geometry)),
                   mutant("the last byte of a region may be missing at level 5", "micromap", {5, 5},
                          spoils(&Functions::validate,
                                 [](const Input&, std::vector<Violation>& found) {
                                   std::erase_if(found, [](const Violation& v) {
                                     return v.rule == Rule::record_region && v.found == v.other + 1;
                                   });
                                 }))}},
      {entry::validate},
      {falling({{4, 3000}}, 1500),
       [](const MicromapSubject& s, Level n, std::uint64_t k, const Run& run) {
         Handed handed;
         sample_spoilt(n, run.seed, k, handed);
         return validates(s, handed.in);
       },
       [](Level, std::uint64_t k, const Run& run) { return text_of(run.seed, k); },
       [](const MicromapSubject& s, Level n, const std::string& text) {
         const auto [seed, k] = sample_from(text);
         Handed handed;
         sample_spoilt(n, seed, k, handed);
         return validates(s, handed.in);
       },
       64});
}

}  // namespace

std::vector<Law> array_laws() { return {pairs(), sampled_builds(), validating()}; }

}  // namespace mmverify::proofs::micromap
