// The three laws of lossy substitution, each for the codecs that keep it; and the law of judges of substitutions.
#include "proofs/engine/shape.hpp"
#include "proofs/engine/spoils.hpp"
#include "proofs/micromap/law_parts.hpp"
#include "proofs/micromap/laws.hpp"
#include "proofs/micromap/maps.hpp"
#include "spec/micromap/lossy.hpp"

namespace mmverify::proofs::micromap {
namespace {

namespace slow = mmverify::spec::micromap;
using enum State;

constexpr Format four = Format::four_state;

using Pair = bool (*)(State was, State is);

MapCheck keeps(Pair rule) {
  return [rule](const MicromapSubject& s, const PackedMap& map) {
    const std::uint64_t count = slow::micro_triangles(map.level);
    const States was = slow::unpack(map.bytes, four, count);
    Bytes first;
    Finding found;
    for (const Bytes& given : with_paddings(map)) {
      const Bytes out = s.functions.substitute(map.level, given);
      if (out.size() != map.bytes.size())
        return wrong(fmt::format("{} bytes", map.bytes.size()), fmt::format("{}", out.size()));
      const States is = slow::unpack(out, four, count);
      for (std::size_t i = 0; i < count; ++i)
        if (!rule(was[i], is[i]))
          return wrong(fmt::format("state {} {} or what may stand for it", i, slow::code(was[i])),
                       fmt::format("{}", slow::code(is[i])));
      found = same("packed", slow::pack(is, four), out);
      if (!found.holds) return found;
      if (first.empty()) first = out;
      found = same("whatever the padding holds,", first, out);
      if (!found.holds) return found;
    }
    return found;
  };
}

// Replaces the state `was` by `now` at a micro-triangle.
auto instead(Level level, std::uint64_t at, State was, State now) {
  return spoils(&Functions::substitute, [=](Level n, std::span<const std::uint8_t> in, Bytes& out) {
    if (n != level) return;
    const unsigned shift = static_cast<unsigned>(2 * at % 8);
    const std::size_t byte = static_cast<std::size_t>(2 * at / 8);
    if ((in[byte] >> shift & 3) != slow::code(was)) return;
    out[byte] = static_cast<std::uint8_t>((out[byte] & ~(3u << shift)) | unsigned{slow::code(now)} << shift);
  });
}

struct Rule {
  const char* id;
  const char* says;
  const char* source;
  Pair pair;
  std::vector<std::string> subjects;
  State was, now;  ///< the change of the mutants
};

void add(std::vector<Law>& laws, const Rule& rule) {
  const auto changed = [&](Level n, std::uint64_t at) {
    return mutant(
        fmt::format("{} for {} at {} of level {}", slow::code(rule.now), slow::code(rule.was), at, n),
        rule.subjects.front(), {n, n}, instead(n, at, rule.was, rule.now));
  };
  laws.push_back(on_all_maps({.id = rule.id,
                              .says = rule.says,
                              .source = rule.source,
                              .subjects = rule.subjects,
                              .tiers = {.seconds = 1},
                              .mutants = {changed(1, 2)}},
                             {entry::substitute}, Maps::four_state, 0, keeps(rule.pair)));
  laws.push_back(on_samples({.id = std::string(rule.id) + "_on_samples",
                             .says = rule.says,
                             .source = rule.source,
                             .subjects = rule.subjects,
                             .tiers = {.fast = {2, 10}, .long_run = {2, 12}, .seconds = 2},
                             .mutants = {changed(6, 2048)}},
                            {entry::substitute}, Maps::four_state, keeps(rule.pair)));
}

Finding judges(const MicromapSubject& s, const PackedMap& was, const PackedMap& is) {
  const std::uint64_t count = slow::micro_triangles(was.level);
  const States a = slow::unpack(was.bytes, four, count), b = slow::unpack(is.bytes, four, count);
  // The statements themselves, not spec/micromap/lossy.hpp, which a subject may use.
  LossyRules expected{true, true, true};
  for (std::size_t i = 0; i < count; ++i) {
    const bool same_state = a[i] == b[i];
    const bool to_unknown = b[i] == UT || b[i] == UO, from_known = a[i] == T || a[i] == O;
    const bool own_side = (a[i] == T && b[i] == UT) || (a[i] == O && b[i] == UO);
    expected.allowed &= same_state || to_unknown;
    expected.conservative &= same_state || (from_known && to_unknown);
    expected.force2_stable &= same_state || own_side;
  }
  const auto number = [](const LossyRules& k) {
    return 4 * k.allowed + 2 * k.conservative + k.force2_stable;
  };
  // Padding is no state: it is zero in both maps first; then the first map's values rise and the second's fall.
  const std::vector<Bytes> before = with_paddings(was), after = with_paddings(is);
  for (std::size_t k = 0; k <= before.size(); ++k) {
    const LossyRules got = k == 0 ? s.functions.judge(was.level, was.bytes, is.bytes)
                                  : s.functions.judge(was.level, before[k - 1], after[after.size() - k]);
    if (got != expected)
      return wrong(fmt::format("allowed, conservative, force2-stable {:03b}", number(expected)),
                   fmt::format("{:03b}", number(got)));
  }
  return {static_cast<std::uint64_t>(number(expected)), true, {}, {}};
}

std::uint64_t four_state_maps(Level n) { return std::uint64_t{1} << (2 * slow::micro_triangles(n)); }

PackedMap four_state_map(Level n, std::uint64_t k) { return {n, four, Bytes{static_cast<std::uint8_t>(k)}}; }

Law judge_law() {
  const auto text = [](const PackedMap& map) { return text_of_states({map.level, map.format, map.bytes}); };
  const auto pair = [](Level n, std::uint64_t k) {
    return std::pair(four_state_map(n, k / four_state_maps(n)), four_state_map(n, k % four_state_maps(n)));
  };
  const auto exactly = [](Level n, std::uint8_t was, std::uint8_t is, void (*change)(LossyRules&)) {
    return spoils(&Functions::judge, [=](Level level, auto a, auto b, LossyRules& kept) {
      if (level == n && a[0] == was && b[0] == is) change(kept);
    });
  };
  return on_cases(
      {.id = "lossy.judges",
       .says = "a judge of substitutions says which of the three rules every micro-triangle keeps",
       .source = lossy_source,
       .subjects = {"micromap-spec", "micromap"},
       .tiers = {.fast = {0, 1}, .long_run = {0, 1}, .seconds = 1},
       .domain = [](const Subject&,
                    Level n) { return fmt::format("all pairs of 4-state maps of level {}", n); },
       .mutants =
           {mutant("takes O for UO as allowed", "micromap", {0, 0},
                   exactly(0, 3, 1, [](LossyRules& k) { k.allowed = true; })),
            mutant("takes UT for UO as conservative", "micromap", {1, 1},
                   exactly(1, 0b11'00'00'00, 0b10'00'00'00, [](LossyRules& k) { k.conservative = true; })),
            mutant("takes UO for the last T as force2-stable", "micromap-spec", {1, 1},
                   exactly(1, 0b00'01'01'01, 0b11'01'01'01, [](LossyRules& k) { k.force2_stable = true; }))}},
      {entry::judge},
      {[](Level n) -> std::uint64_t { return n > 1 ? 0 : four_state_maps(n) * four_state_maps(n); },
       [=](const MicromapSubject& s, Level n, std::uint64_t k, const Run&) {
         const auto [was, is] = pair(n, k);
         return judges(s, was, is);
       },
       [=](Level n, std::uint64_t k, const Run&) {
         const auto [was, is] = pair(n, k);
         return text(was) + "|" + text(is);
       },
       [](const MicromapSubject& s, Level n, const std::string& at) {
         const auto bar = at.find('|');
         if (bar == std::string::npos) throw BadCase("'" + at + "': write 4-state:0123|4-state:2323");
         const Map was = map_from_text(n, at.substr(0, bar)), is = map_from_text(n, at.substr(bar + 1));
         if (was.format != four || is.format != four)
           throw BadCase("'" + at + "': the law is about 4-state maps");
         return judges(s, {n, four, was.packed}, {n, four, is.packed});
       }});
}

// A map, and the same map with one state replaced, or with all states of one node of the curve replaced.
struct Substituted {
  std::uint64_t map;  // the number of the sample
  State now;
  Level depth;
  std::uint64_t node;
};

// Each of the four states replaces the present one: at the ends of words and of the map, and in a quarter.
constexpr std::uint64_t substitutions = 4 * 8, maps = 5;

Substituted substituted(Level n, std::uint64_t k) {
  const std::uint64_t all = slow::micro_triangles(n), last = all - 1;
  const std::uint64_t at[] = {0,
                              std::min<std::uint64_t>(15, last),
                              std::min<std::uint64_t>(16, last),
                              std::min<std::uint64_t>(31, last),
                              std::min<std::uint64_t>(32, last),
                              all / 2,
                              last};
  const std::uint64_t place = k / 4 % 8;
  return {k / substitutions, static_cast<State>(k % 4), place < 7 ? n : 1,
          place < 7 ? at[place] : k / 4 / 8 % 4};
}

std::pair<PackedMap, PackedMap> maps_of(Level n, std::uint64_t seed, const Substituted& s) {
  const Map sample = sample_map(n, seed, 2 * s.map + 1);
  PackedMap is{n, four, sample.packed};
  const std::uint64_t run = slow::micro_triangles(n - s.depth);
  for (std::uint64_t k = s.node * run; k < (s.node + 1) * run; ++k) {
    auto& byte = is.bytes[k / 4];
    const unsigned shift = static_cast<unsigned>(2 * k % 8);
    byte = static_cast<std::uint8_t>((byte & ~(3u << shift)) | unsigned{slow::code(s.now)} << shift);
  }
  return {{n, four, sample.packed}, is};
}

Law judge_samples_law() {
  const auto at = [](Level n, std::uint64_t k, const Run& run) {
    return maps_of(n, run.seed, substituted(n, k));
  };
  const auto last = [](Level level, State now, void (*change)(LossyRules&)) {
    return spoils(&Functions::judge, [=](Level n, auto was, auto is, LossyRules& kept) {
      if (n == level && was.back() >> 6 != is.back() >> 6 && is.back() >> 6 == slow::code(now)) change(kept);
    });
  };
  return on_cases(
      {.id = "lossy.judges_on_samples",
       .says = "a judge of substitutions says which of the three rules every micro-triangle keeps",
       .source = lossy_source,
       .method = Method::sample,
       .subjects = {"micromap-spec", "micromap"},
       .tiers = {.fast = {2, 7}, .long_run = {2, 9}, .seconds = 0.5},
       .domain =
           [](Level n) {
             return fmt::format(
                 "{} sample maps of level {}, each state in the place of one at a word's or the map's end, "
                 "or of a quarter",
                 maps, n);
           },
       .mutants = {mutant("the last of level 7 may become T", "micromap", {7, 7},
                          last(7, T, [](LossyRules& k) { k.allowed = true; })),
                   mutant("the last of level 4 may not become UT", "micromap", {4, 4},
                          last(4, UT, [](LossyRules& k) { k.conservative = false; })),
                   mutant("the last of level 2 may become UO", "micromap-spec", {2, 2},
                          last(2, UO, [](LossyRules& k) { k.force2_stable = true; }))}},
      {entry::judge},
      {[](Level) { return maps * substitutions; },
       [=](const MicromapSubject& s, Level n, std::uint64_t k, const Run& run) {
         const auto [was, is] = at(n, k, run);
         return judges(s, was, is);
       },
       [](Level n, std::uint64_t k, const Run& run) {
         const Substituted s = substituted(n, k);
         return fmt::format("sample:{}:{}|{}@{}:{}", run.seed, 2 * s.map + 1, slow::code(s.now), s.depth,
                            s.node);
       },
       [](const MicromapSubject& s, Level n, const std::string& at) {
         const Groups parts =
             groups_of(at, "sample:([0-9]{1,19}):([0-9]{0,3}[13579])\\|([0-3])@([0-9]{1,2}):([0-9]{1,8})");
         if (!parts) throw BadCase("'" + at + "': write sample:1:3|2@5:17, with an odd sample");
         const auto number = [&](std::size_t k) { return std::stoull((*parts)[k]); };
         const Substituted what{number(2) / 2, static_cast<State>(number(3)), static_cast<Level>(number(4)),
                                number(5)};
         if (n > 12 || what.depth > n || what.node >= slow::micro_triangles(what.depth))
           throw BadCase("'" + at + "': no such node");
         const auto [was, is] = maps_of(n, number(1), what);
         return judges(s, was, is);
       },
       16});
}

}  // namespace

std::vector<Law> lossy_laws() {
  std::vector<Law> laws;
  add(laws, {"lossy.allowed",
             "a lossy codec turns any state into UT or UO at most, never into T or O",
             lossy_source,
             slow::allowed,
             {"lossy-merge", "lossy-conservative", "lossy-stable"},
             UT,
             T});
  add(laws, {"lossy.conservative",
             "a lossy codec turns T and O into UT or UO at most, and leaves UT and UO alone",
             design_source,
             slow::conservative,
             {"lossy-conservative", "lossy-stable"},
             T,
             O});
  add(laws, {"lossy.force2_stable",
             "a lossy codec turns T into UT and O into UO at most: force-2-state sees no difference",
             design_source,
             slow::force2_stable,
             {"lossy-stable"},
             UO,
             UT});
  laws.push_back(judge_law());
  laws.push_back(judge_samples_law());
  return laws;
}

}  // namespace mmverify::proofs::micromap
