// Laws of packing any number of states, not only powers of four.
#include "proofs/engine/spoils.hpp"
#include "proofs/micromap/law_parts.hpp"
#include "proofs/micromap/laws.hpp"
#include "proofs/micromap/maps.hpp"

namespace mmverify::proofs::micromap {
namespace {

namespace slow = mmverify::spec::micromap;
using enum State;

constexpr Format two = Format::two_state, four = Format::four_state;

struct Sequence {
  Format format;
  States states;
};

std::string text(const Sequence& s) {
  std::string out = s.format == two ? "2-state:" : "4-state:";
  for (const State state : s.states) out += static_cast<char>('0' + slow::code(state));
  return out;
}

Sequence from_text(const std::string& text) {
  const auto [format, digits] = format_and_rest(text);
  Sequence s{format, {}};
  for (const char c : digits) {
    if (c < '0' || c > (format == two ? '1' : '3'))
      throw BadCase(fmt::format("'{:.60}': write 2-state: and digits 0 and 1, or 4-state: and 0 to 3", text));
    s.states.push_back(static_cast<State>(c - '0'));
  }
  constexpr std::size_t most = 1 << 15;
  if (s.states.empty() || s.states.size() > most)
    throw BadCase(fmt::format("'{:.60}': write 1 to {} states", text, most));
  return s;
}

Bytes codes(const States& states) {
  Bytes out;
  for (const State s : states) out.push_back(slow::code(s));
  return out;
}

// Unpacks with the padding zero, all ones, and alternating; and packs.
Finding packs(const MicromapSubject& s, const Sequence& sequence) {
  const auto& [format, states] = sequence;
  const Bytes map = slow::pack(states, format), expected = codes(states);
  const unsigned used = static_cast<unsigned>(states.size() * bits(format) % 8);
  Finding found = same("packed", map, s.functions.pack(format, states));
  for (const unsigned padding : {0x00u, 0xFFu, 0xAAu}) {
    if (!found.holds) break;
    if (used == 0 && padding != 0) break;
    Bytes given = map;
    if (used != 0) given.back() = static_cast<std::uint8_t>(given.back() | (padding << used & 0xFF));
    found = all(found, same("states", expected, codes(s.functions.unpack(format, states.size(), given))));
  }
  return found;
}

Cases cases(std::uint64_t count, std::function<Sequence(std::uint64_t k, const Run&)> sequence) {
  return {[count](Level) { return count; },
          [sequence](const MicromapSubject& s, Level, std::uint64_t k, const Run& run) {
            return packs(s, sequence(k, run));
          },
          [sequence](Level, std::uint64_t k, const Run& run) { return text(sequence(k, run)); },
          [](const MicromapSubject& s, Level, const std::string& at) { return packs(s, from_text(at)); }};
}

// All sequences of up to 12 states in 2-state, and of up to 6 in 4-state: 2^13 - 2 and (4^7 - 4) / 3.
constexpr std::uint64_t two_state_sequences = 8190, four_state_sequences = 5460;

Sequence sequence_number(std::uint64_t k) {
  const Format f = k < two_state_sequences ? two : four;
  if (f == four) k -= two_state_sequences;
  std::uint64_t count = 1, with = std::uint64_t{1} << bits(f);
  for (; k >= with; ++count, with <<= bits(f)) k -= with;
  Sequence s{f, {}};
  for (std::uint64_t i = 0; i < count; ++i)
    s.states.push_back(static_cast<State>(k >> i * bits(f) & ((1u << bits(f)) - 1)));
  return s;
}

// Sequences of 1 to 300 states, and of lengths beside 2^9 to 2^14: noise, noise of another seed, one state but for
// the last, and one state but for the first.
constexpr std::uint64_t each_to = 300, kinds = 4, first_power = 9, last_power = 14;
constexpr std::array beside{-3, -1, 1, 2, 3};
constexpr std::uint64_t lengths = each_to + (last_power - first_power + 1) * beside.size();

std::uint64_t length(std::uint64_t number) {
  if (number < each_to) return number + 1;
  number -= each_to;
  return (std::uint64_t{1} << (first_power + number / beside.size())) +
         static_cast<std::uint64_t>(beside[number % beside.size()]);
}

Sequence sample(std::uint64_t k, const Run& run) {
  Random random(run.seed, 91, k);
  const Format f = k % 2 == 0 ? two : four;
  const std::uint64_t kind = k / 2 % kinds, count = length(k / 2 / kinds),
                      limit = std::uint64_t{1} << bits(f);
  const auto any = [&] { return static_cast<State>(random.below(limit)); };
  Sequence s{f, States(static_cast<std::size_t>(count), any())};
  if (kind < 2) {
    for (State& state : s.states) state = any();
  } else {
    State& odd = kind == 2 ? s.states.back() : s.states.front();
    odd = static_cast<State>((slow::code(odd) + 1 + random.below(limit - 1)) % limit);
  }
  return s;
}

constexpr char says[] = "packing and unpacking any number of states, as those of a map";

}  // namespace

std::vector<Law> count_laws() {
  return {
      on_cases({.id = "micromap.packing_any_count",
                .says = says,
                .source = packing_source,
                .subjects = {"micromap-spec", "micromap"},
                .tiers = {.seconds = 0.3},
                .at_once = "all levels",
                .domain = "all sequences of 1 to 12 states in 2-state, and of 1 to 6 in 4-state",
                .mutants = {mutant("ones after eleven states", "micromap", {0, 0},
                                   spoils(&Functions::pack,
                                          [](Format f, const States& s, Bytes& out) {
                                            if (f == two && s == States(11, T)) out.back() |= 0x80;
                                          }))}},
               {entry::pack},
               cases(two_state_sequences + four_state_sequences,
                     [](std::uint64_t k, const Run&) { return sequence_number(k); })),
      on_cases({.id = "micromap.packing_any_count_on_samples",
                .says = says,
                .source = packing_source,
                .method = Method::sample,
                .subjects = {"micromap-spec", "micromap"},
                .tiers = {.seconds = 0.3},
                .at_once = "all levels",
                .domain = "four sequences of each number of states from 1 to 300, and of 30 beside 2^9 to "
                          "2^14, both formats",
                .mutants = {mutant("of 4098 states or more the first half's last is lost", "micromap", {0, 0},
                                   spoils(&Functions::pack,
                                          [](Format f, const States& s, Bytes& out) {
                                            if (f == two && s.size() >= 4098 && s.size() % 16 == 2)
                                              out[s.size() / 16] &= 0xFE;
                                          }))}},
               {entry::pack}, cases(2 * kinds * lengths, sample))};
}

}  // namespace mmverify::proofs::micromap
