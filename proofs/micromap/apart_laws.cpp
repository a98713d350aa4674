// Maps of one state but for one node of the curve.  What becomes of one is another such map, so that it is
// written down at once: no oracle goes through its states, and every level is asked.
#include "proofs/engine/spoils.hpp"
#include "proofs/micromap/law_parts.hpp"
#include "proofs/micromap/laws.hpp"
#include "proofs/micromap/maps.hpp"

namespace mmverify::proofs::micromap {
namespace {

namespace slow = mmverify::spec::micromap;
using slow::code;

using enum State;

constexpr Format two = Format::two_state, four = Format::four_state;

State common(const OneApart& a) { return static_cast<State>(a.common); }
State odd(const OneApart& a) { return static_cast<State>(a.odd); }

// The map with both of its states replaced.
OneApart with(OneApart apart, Format f, State now_common, State now_odd) {
  apart.format = f;
  apart.common = code(now_common);
  apart.odd = code(now_odd);
  return apart;
}

Bytes bytes(Level n, const OneApart& apart) { return map_of(n, apart).packed; }

OneApart forced(const OneApart& a) { return with(a, two, slow::force2(common(a)), slow::force2(odd(a))); }

// One level down a lone micro-triangle changes its parent: three of the common state and one odd one.
OneApart below(Level n, OneApart a) {
  if (a.depth < n || a.common == a.odd) return a;
  const bool opaque = slow::force2(common(a)) == O;  // three of four
  --a.depth;
  a.node /= 4;
  a.odd = code(a.format == two ? (opaque ? O : T) : (opaque ? UO : UT));
  return a;
}

Finding packs(const MicromapSubject& s, Level n, const OneApart& a) {
  const std::uint64_t count = slow::micro_triangles(n), run = slow::micro_triangles(n - a.depth);
  States states(static_cast<std::size_t>(count), common(a));
  std::fill_n(states.begin() + static_cast<std::ptrdiff_t>(a.node * run), run, odd(a));
  const Bytes map = bytes(n, a);
  const States got = s.functions.unpack(a.format, count, map);
  if (got != states) {
    const auto [expected, other] = std::mismatch(states.begin(), states.end(), got.begin(), got.end());
    if (expected == states.end())
      return wrong(fmt::format("{} states", count), fmt::format("{}", got.size()));
    return wrong(fmt::format("state {} {}", expected - states.begin(), code(*expected)),
                 other == got.end() ? "none" : fmt::format("{}", code(*other)));
  }
  return same("packed", map, s.functions.pack(a.format, states));
}

Finding forces(const MicromapSubject& s, Level n, const OneApart& a) {
  if (a.format == four) return same("force-2-state", bytes(n, forced(a)), s.functions.force2(n, bytes(n, a)));
  const Bytes wide = bytes(n, with(a, four, common(a), odd(a)));
  return all(same("4-state", wide, s.functions.widen(n, bytes(n, a))),
             same("and back", bytes(n, a), s.functions.force2(n, wide)));
}

Finding rises(const MicromapSubject& s, Level n, const OneApart& a) {
  return same("children's states", bytes(n + 1, a), s.functions.up(n, a.format, bytes(n, a)));
}

Finding falls(const MicromapSubject& s, Level n, const OneApart& a) {
  return same("parents' states", bytes(n - 1, below(n, a)), s.functions.down(n, a.format, bytes(n, a)));
}

// The rest is one of the unknown states: either.
Finding goes_through(const MicromapSubject& s, Level n, const OneApart& a, Mode mode) {
  const Bytes got = s.functions.through(n, mode, bytes(n, a));
  const std::string what = fmt::format("through mode {}", static_cast<int>(mode));
  if (mode == Mode::T_O)
    return same(what.c_str(), bytes(n, with(a, four, slow::force2(common(a)), slow::force2(odd(a)))), got);
  const State kept = mode == Mode::T_C ? T : O;
  const auto expected = [&](State unknown) {
    return bytes(n, with(a, four, common(a) == kept ? kept : unknown, odd(a) == kept ? kept : unknown));
  };
  const Finding found = same(what.c_str(), expected(UT), got);
  return found.holds ? found : same(what.c_str(), expected(UO), got);
}

Finding goes_through_modes(const MicromapSubject& s, Level n, const OneApart& a) {
  return all(goes_through(s, n, a, Mode::T_O), goes_through(s, n, a, Mode::T_C),
             goes_through(s, n, a, Mode::O_C));
}

// All that the subject has.  Levels go up to 12: nothing rises from there.
Finding judged(const MicromapSubject& s, Level n, const OneApart& a) {
  Finding found;
  const auto also = [&](bool asked, Finding (*check)(const MicromapSubject&, Level, const OneApart&)) {
    if (!asked || !found.holds) return;
    const std::uint64_t so_far = found.answer;
    found = check(s, n, a);
    found.answer += 31 * so_far;
  };
  also(bool{s.functions.pack}, packs);
  also(bool{s.functions.force2}, forces);
  also(s.functions.up && n < 12, rises);
  also(s.functions.down && n > 0, falls);
  also(s.functions.through && a.format == four, goes_through_modes);
  return found;
}

Cases cases(std::function<std::uint64_t(Level)> count, std::function<OneApart(Level, std::uint64_t)> number,
            std::uint64_t chunk) {
  return {std::move(count),
          [number](const MicromapSubject& s, Level n, std::uint64_t k, const Run&) {
            return judged(s, n, number(n, k));
          },
          [number](Level n, std::uint64_t k, const Run&) { return text_of(number(n, k)); },
          [](const MicromapSubject& s, Level n, const std::string& at) {
            const auto apart = apart_from_text(n, at);
            if (!apart) throw BadCase(fmt::format("'{:.60}': write 4-state:0+2@3:17", at));
            return judged(s, n, *apart);
          },
          chunk};
}

std::string parts_of(const Subject& s) { return asked_of(dynamic_cast<const MicromapSubject&>(s)); }

bool is(Level n, std::span<const std::uint8_t> in, Level level, const OneApart& apart) {
  if (n != level) return false;
  const Bytes expected = bytes(level, apart);
  return std::equal(in.begin(), in.end(), expected.begin(), expected.end());
}

void change(Bytes& out, std::size_t byte, std::uint8_t bits) {
  out[byte] = static_cast<std::uint8_t>(out[byte] ^ bits);
}

constexpr char says[] =
    "packing, force-2-state, one level up, one down and the modes, where all is of one state but for one "
    "node";

Law every_one() {
  return on_any_part(on_cases(
      {.id = "micromap.one_apart",
       .says = says,
       .source = packing_source,
       .subjects = {"micromap-spec", "micromap"},
       .tiers = {.fast = {2, 4}, .long_run = {2, 7}, .seconds = 1},
       .domain =
           [](const Subject& s, Level n) {
             return fmt::format("all maps of level {} of one state but for one node, and the uniform ones{}",
                                n, parts_of(s));
           },
       .mutants = {mutant("a uniform UT of level 3 is UO through O/C in one place", "micromap", {3, 3},
                          spoils(&Functions::through,
                                 [](Level n, Mode m, auto in, Bytes& out) {
                                   if (m == Mode::O_C && is(n, in, 3, {four, 2, 2, 0, 0})) change(out, 8, 1);
                                 }))}},
      {}, cases(one_apart_count, one_apart_number, 64)));
}

Law chosen_ones() {
  return on_any_part(
      on_cases({.id = "micromap.one_apart_on_samples",
                .says = says,
                .source = packing_source,
                .method = Method::sample,
                .subjects = {"micromap"},
                .tiers = {.fast = {5, 12}, .long_run = {5, 12}, .seconds = 4},
                .domain =
                    [](const Subject& s, Level n) {
                      return fmt::format(
                          "{} maps of level {} of one state but for one micro-triangle at a word's or the "
                          "map's end, or for none{}",
                          chosen_apart_count(n), n, parts_of(s));
                    },
                .how = "sample, against the closed form",
                .mutants = {mutant("the last UO among O of level 7 is O", "micromap", {7, 7},
                                   spoils(&Functions::unpack,
                                          [](Format, std::uint64_t, auto, States& s) {
                                            if (s.size() == 16384 && s.back() == UO && s.front() == O)
                                              s.back() = O;
                                          }))}},
               {}, cases(chosen_apart_count, chosen_apart, 1)));
}

}  // namespace

std::vector<Law> apart_laws() { return {every_one(), chosen_ones()}; }

}  // namespace mmverify::proofs::micromap
