// Laws of vectors: which there are, how they turn, how they are written.  Each oracle is a statement of its
// own: neighbourhoods, signed coordinates, sets of code words.
#include <algorithm>
#include <array>
#include <cstdio>

#include "proofs/vq/law_groups.hpp"
#include "proofs/vq/law_parts.hpp"
#include "proofs/vq/texts.hpp"

namespace mmverify::proofs::vq {
namespace {

using enum State;

/// 1 and 2: vectors have 2^level regions along a side.
constexpr Levels both_sides{1, 2};

/// f(std::integral_constant<std::size_t, side>) of a level.  Throws BadCase at others.
template <class F>
auto at_side(Level n, F f) {
  if (n == 1) return f(std::integral_constant<std::size_t, 2>());
  if (n == 2) return f(std::integral_constant<std::size_t, 4>());
  throw BadCase(fmt::format("level {}: vectors have 2 or 4 regions along a side, levels 1 and 2", n));
}

std::optional<std::string> lacks_vectors(const VqSubject& s) {
  if (!s.parts.of2.valid || !s.parts.composed)
    return s.name() + " has no entry point of vectors: they are the specification's";
  return std::nullopt;
}

template <std::size_t side>
Vector<side> to_vector(std::span<const State> states) {
  Vector<side> v{};
  std::copy(states.begin(), states.end(), v.begin());
  return v;
}

// ---------------------------------------------------------------------------------------------------------------------
// Which vectors there are (2, 4, 5.1)
// ---------------------------------------------------------------------------------------------------------------------

/// A row of a vector: bit x of t and of o says that region x is T, or O.
struct Row {
  std::uint32_t t = 0, o = 0;
  /// The regions beside these, and these.
  static constexpr std::uint32_t around(std::uint32_t set) { return set | set << 1 | set >> 1; }
  constexpr bool clashes(Row other) const { return (around(t) & other.o) != 0 || (around(other.t) & o) != 0; }
};

constexpr std::uint64_t power_of_3(std::size_t e) { return e == 0 ? 1 : 3 * power_of_3(e - 1); }

/// The row whose states are a number's digits to base 3.
template <std::size_t side>
constexpr Row row_of(std::uint64_t number) {
  Row row;
  for (std::uint32_t x = 0; x < side; ++x, number /= 3) {
    row.t |= (number % 3 == 0 ? 1u : 0u) << x;
    row.o |= (number % 3 == 2 ? 1u : 0u) << x;
  }
  return row;
}

/// How many ways there are to go on from a row for so many rows without O beside T.
template <std::size_t side>
constexpr std::uint64_t continuations(Row row, std::size_t rows) {
  if (row.clashes(row)) return 0;
  if (rows == 0) return 1;
  std::uint64_t sum = 0;
  for (std::uint64_t k = 0; k < power_of_3(side); ++k)
    if (const Row next = row_of<side>(k); !row.clashes(next)) sum += continuations<side>(next, rows - 1);
  return sum;
}

template <std::size_t side>
std::uint64_t all_valid() {
  std::uint64_t sum = 0;
  for (std::uint64_t k = 0; k < power_of_3(side); ++k) sum += continuations<side>(row_of<side>(k), side - 1);
  return sum;
}

/// The states of a first row.
struct FirstRow {
  std::vector<State> states;
};

template <std::size_t side>
Finding counts_of_first_row(const VqSubject& s, const FirstRow& first) {
  constexpr std::uint64_t rows = power_of_3(side);
  static const std::uint64_t total = all_valid<side>();
  if (total != (side == 2 ? 31 : 231'713))
    return wrong(fmt::format("{} vectors", side == 2 ? 31 : 231'713), fmt::format("{}", total));
  std::array<Row, rows> sets;
  std::array<std::array<State, side>, rows> states;
  for (std::uint64_t k = 0; k < rows; ++k) {
    sets[k] = row_of<side>(k);
    for (std::uint64_t x = 0, left = k; x < side; ++x, left /= 3) states[k][x] = static_cast<State>(left % 3);
  }
  Vector<side> v{};
  std::copy(first.states.begin(), first.states.end(), v.begin());
  Row top;
  for (std::uint32_t x = 0; x < side; ++x) {
    top.t |= (v[x] == T ? 1u : 0u) << x;
    top.o |= (v[x] == O ? 1u : 0u) << x;
  }
  std::uint64_t found = 0;
  Finding finding;
  const auto from = [&](const auto& self, Row above, bool holds, std::size_t y) -> void {
    if (y == side) {
      const bool got = s.parts.vectors<side>().valid(v);
      found += got ? 1 : 0;
      if (got != holds && finding.holds)
        finding = wrong(fmt::format("{} {}", letters(v), holds ? "valid" : "not valid"),
                        got ? "valid" : "not valid");
      return;
    }
    for (std::uint64_t k = 0; k < rows; ++k) {
      std::copy(states[k].begin(), states[k].end(), v.begin() + static_cast<std::ptrdiff_t>(side * y));
      self(self, sets[k], holds && !above.clashes(sets[k]) && !sets[k].clashes(sets[k]), y + 1);
    }
  };
  from(from, top, !top.clashes(top), 1);
  if (!finding.holds) return finding;
  if (const std::uint64_t expected = continuations<side>(top, side - 1); found != expected)
    return wrong(fmt::format("{} vectors", expected), fmt::format("{}", found));
  finding.answer = found;
  return finding;
}

Law vectors_law() {
  Cases<FirstRow> cases;
  cases.count = [](Level n, const Run&) { return power_of_3(std::size_t{1} << n); };
  cases.number = [](Level n, std::uint64_t k, std::uint64_t) {
    FirstRow first;
    for (std::size_t x = 0; x < std::size_t{1} << n; ++x, k /= 3)
      first.states.push_back(static_cast<State>(k % 3));
    return first;
  };
  cases.text = [](const FirstRow& first) { return "row:" + letters(first.states); };
  cases.read = [](Level n, const std::string& at) {
    if (!at.starts_with("row:")) throw BadCase(fmt::format("'{:.60}': write row: and letters", at));
    return at_side(
        n, [&](auto side) { return FirstRow{states_from_letters(std::string_view(at).substr(4), side)}; });
  };
  cases.check = [](const VqSubject& s, const FirstRow& first) {
    return first.states.size() == 2 ? counts_of_first_row<2>(s, first) : counts_of_first_row<4>(s, first);
  };
  cases.chunk = 1;
  const auto says = [](auto vector, bool answer) {
    return [=](Parts& parts) {
      constexpr std::size_t side = std::tuple_size_v<decltype(vector)> == 4 ? 2 : 4;
      auto& valid = parts.vectors<side>().valid;
      valid = [=, real = valid](const Vector<side>& v) { return v == vector ? answer : real(v); };
    };
  };
  return over(
      {.id = "vq.vectors",
       .topic = "vq",
       .says = "31 of the 2x2 vectors and 231,713 of the 4x4 ones hold no O beside T, diagonals included",
       .source = "Compressed Opacity Maps, 4 and 5.1",
       .subjects = {"vq-spec"},
       .fast = both_sides,
       .fast_seconds = 1,
       .domain =
           [](const Subject&, Level n) {
             return fmt::format("all {} vectors of {} regions, by their first row", n == 1 ? "3^4" : "3^16",
                                n == 1 ? "2x2" : "4x4");
           },
       .mutants = {mutant("O beside T along a diagonal", "vq-spec", {1, 1},
                          says(Vector<2>{O, C, C, T}, true)),
                   mutant("one vector of the two middle rows", "vq-spec", {2, 2},
                          says(Vector<4>{C, C, C, C, C, O, C, C, C, C, T, C, C, C, C, C}, true)),
                   mutant("all C", "vq-spec", {1, 1}, says(spec::vq::uniform<2>(C), false))}},
      lacks_vectors, cases);
}

// ---------------------------------------------------------------------------------------------------------------------
// The eight transforms (4.1, table 1)
// ---------------------------------------------------------------------------------------------------------------------

/// What a result of table 1 does to X, Y counted from the middle, y upwards: (a X + b Y, c X + d Y).
struct Linear {
  int a, b, c, d;
  constexpr bool operator==(const Linear&) const = default;
  constexpr Linear after(Linear first) const {
    return {a * first.a + b * first.c, a * first.b + b * first.d, c * first.a + d * first.c,
            c * first.b + d * first.d};
  }
};

struct NamedRow {
  const char* name;
  Linear does;
};
constexpr std::array<NamedRow, 8> table_1{{{"Identity", {1, 0, 0, 1}},
                                           {"Rotate 90", {0, -1, 1, 0}},
                                           {"Reflect TB", {1, 0, 0, -1}},
                                           {"Reflect X=-Y", {0, -1, -1, 0}},
                                           {"Reflect LR", {-1, 0, 0, 1}},
                                           {"Reflect X=Y", {0, 1, 1, 0}},
                                           {"Rotate 180", {-1, 0, 0, -1}},
                                           {"Rotate 270", {0, 1, -1, 0}}}};

constexpr std::uint32_t row_that_does(Linear m) {
  for (std::uint32_t k = 0; k < 8; ++k)
    if (table_1[k].does == m) return k;
  return 8;
}

/// The row `then` after the row `first`; of a single row, `first` is the identity.
struct Pair {
  std::uint32_t then, first, side;
};

/// A vector whose one O must arrive where the matrix says, for each place of it.
template <std::size_t side>
Finding moves(const VqSubject& s, const char* what, Linear does, const auto& turned) {
  constexpr int last = side - 1;
  for (int y = 0; y <= last; ++y)
    for (int x = 0; x <= last; ++x) {
      const int X = 2 * x - last, Y = 2 * y - last;
      Vector<side> v = spec::vq::uniform<side>(T), expected = v;
      v[static_cast<std::size_t>(x + (last + 1) * y)] = O;
      const int to_x = (does.a * X + does.b * Y + last) / 2, to_y = (does.c * X + does.d * Y + last) / 2;
      expected[static_cast<std::size_t>(to_x + (last + 1) * to_y)] = O;
      const Vector<side> got = turned(s.parts.vectors<side>(), v);
      if (got != expected)
        return wrong(fmt::format("{} of {} {}", what, letters(v), letters(expected)), letters(got));
    }
  return {};
}

template <std::size_t side>
Finding composes(const VqSubject& s, const Pair& pair) {
  const Transform then = Transform::of(pair.then), first = Transform::of(pair.first);
  const Linear both = table_1[pair.then].does.after(table_1[pair.first].does);
  const std::uint32_t row = row_that_does(both);
  if (row == 8) return wrong("a row of table 1", "none");
  if (Finding one = moves<side>(s, table_1[pair.then].name, table_1[pair.then].does,
                                [&](const auto& of, const auto& v) { return of.applied(then, v); });
      !one.holds)
    return one;
  if (Finding two =
          moves<side>(s, table_1[row].name, both,
                      [&](const auto& of, const auto& v) { return of.applied(then, of.applied(first, v)); });
      !two.holds)
    return two;
  const std::uint32_t got = s.parts.composed(then, first).number();
  if (got != row) return wrong(fmt::format("row {}", row), fmt::format("row {}", got));
  // Closed under composition and finite; that each row has an inverse among the eight is a case of its own.
  bool undone = false;
  for (std::uint32_t k = 0; k < 8; ++k)
    undone = undone || s.parts.composed(Transform::of(k), then).number() == 0;
  return undone ? Finding{got} : wrong("an inverse", "none");
}

Law transforms_law() {
  Cases<Pair> cases;
  cases.count = [](Level, const Run&) { return std::uint64_t{64}; };
  cases.number = [](Level n, std::uint64_t k, std::uint64_t) {
    return Pair{static_cast<std::uint32_t>(k / 8), static_cast<std::uint32_t>(k % 8), 1u << n};
  };
  cases.text = [](const Pair& p) { return fmt::format("rows:{},{}", p.then, p.first); };
  cases.read = [](Level n, const std::string& at) {
    if (at.size() != 8 || !at.starts_with("rows:") || at[6] != ',' || at[5] < '0' || at[5] > '7' ||
        at[7] < '0' || at[7] > '7')
      throw BadCase(fmt::format("'{:.60}': write rows:THEN,FIRST, each 0..7", at));
    return at_side(n, [&](auto side) {
      return Pair{static_cast<std::uint32_t>(at[5] - '0'), static_cast<std::uint32_t>(at[7] - '0'), side};
    });
  };
  cases.check = [](const VqSubject& s, const Pair& p) {
    return p.side == 2 ? composes<2>(s, p) : composes<4>(s, p);
  };
  const auto turns = [](auto side, std::uint32_t row, auto wrongly) {
    return [=](Parts& parts) {
      auto& applied = parts.vectors<side>().applied;
      applied = [=, real = applied](Transform t, const auto& v) {
        auto out = real(t, v);
        if (t.number() == row) wrongly(out);
        return out;
      };
    };
  };
  constexpr std::integral_constant<std::size_t, 2> two{};
  constexpr std::integral_constant<std::size_t, 4> four{};
  return over(
      {.id = "vq.transforms",
       .topic = "vq",
       .says = "table 1's rows do what it says they result in, and are the symmetries of the square: closed, "
               "each with its inverse",
       .source = "Compressed Opacity Maps, 4.1, table 1",
       .subjects = {"vq-spec"},
       .fast = both_sides,
       .fast_seconds = 0.1,
       .domain =
           [](const Subject&, Level n) {
             return fmt::format("all pairs of rows, on every region of {} vectors", n == 1 ? "2x2" : "4x4");
           },
       .mutants = {mutant("Rotate 270 leaves two middle regions of 4x4 in each other's place", "vq-spec",
                          {2, 2}, turns(four, 7, [](auto& v) { std::swap(v[5], v[6]); })),
                   mutant("Reflect X=-Y is Reflect X=Y", "vq-spec", {1, 1},
                          turns(two, 3, [](auto& v) { std::swap(v[0], v[3]), std::swap(v[1], v[2]); })),
                   mutant("Rotate 90 after Reflect LR is another row", "vq-spec", {1, 2},
                          [](Parts& parts) {
                            parts.composed = [real = parts.composed](Transform then, Transform first) {
                              return then.number() == 1 && first.number() == 4 ? Transform::of(5)
                                                                               : real(then, first);
                            };
                          })}},
      lacks_vectors, cases);
}

// ---------------------------------------------------------------------------------------------------------------------
// Codes (figure 4, 5.1, table 2)
// ---------------------------------------------------------------------------------------------------------------------

/// A code word, or a vector of C but for one O and one T, which can be written just where they have palettes
/// of their own.
struct Word {
  std::uint32_t side;
  Code4 how;
  bool of_pair;
  std::uint32_t code;  ///< the word; of a pair, 16 times O's region plus T's
};

constexpr std::array<const char*, 5> kinds{"simple", "vertical", "horizontal", "generic", "mini"};
constexpr std::uint32_t code_bits(std::uint32_t side, Code4 how) {
  return side == 2 ? 5 : spec::vq::bits_of(how);
}

std::string text_of(const Word& w) {
  const char* kind = kinds[w.side == 2 ? 4 : static_cast<std::size_t>(w.how)];
  return w.of_pair ? fmt::format("{}-pair:{},{}", kind, w.code / 16, w.code % 16)
                   : fmt::format("{}:{:#x}", kind, w.code);
}

/// Whether O and T at two regions have a palette each.
bool apart(const Word& w) {
  const std::uint32_t o = w.code / 16, t = w.code % 16;
  if (w.side == 2 || w.how == Code4::simple) return false;
  const bool columns = o % 4 / 2 != t % 4 / 2, rows = o / 8 != t / 8;
  return w.how == Code4::vertical ? columns : w.how == Code4::horizontal ? rows : columns || rows;
}

template <std::size_t side>
Finding writes(const VqSubject& s, const Word& w) {
  const Vectors<side>& of = s.parts.vectors<side>();
  if (w.of_pair) {
    Vector<side> v = spec::vq::uniform<side>(C);
    v[w.code / 16] = O;
    v[w.code % 16] = T;
    const auto code = of.encode(w.how, v);
    if (code.has_value() != apart(w))
      return wrong(fmt::format("{} {}", letters(v), apart(w) ? "written" : "not written"),
                   code ? fmt::format("{:#x}", *code) : "none");
    if (code && of.decode(w.how, *code) != v) return wrong(letters(v), letters(of.decode(w.how, *code)));
    return {code.value_or(0)};
  }
  const Vector<side> v = of.decode(w.how, w.code);
  // By the definition: bit k is C; else the palette that holds there.
  for (std::uint32_t k = 0; k < side * side; ++k) {
    const std::uint32_t x = k % side, y = k / side, m = x / 2 + 2 * (y / 2);
    const bool generic = side == 4 && w.how == Code4::generic;
    const std::uint32_t own = generic ? 5 * m + x % 2 + 2 * (y % 2) : k,
                        palette = side == 2                    ? 4
                                  : generic                    ? 5 * m + 4
                                  : w.how == Code4::vertical   ? 16 + x / 2
                                  : w.how == Code4::horizontal ? 16 + y / 2
                                                               : 16;
    const State expected = (w.code >> own & 1) != 0 ? C : (w.code >> palette & 1) != 0 ? O : T;
    if (v[k] != expected)
      return wrong(fmt::format("region {} {}", k, letters({&expected, 1})), letters({&v[k], 1}));
  }
  const auto again = of.encode(w.how, v);
  if (!again) return wrong(fmt::format("a code of {}", letters(v)), "none");
  // As this is asked of every word, the least of those that mean the vector is below each of them.
  if (*again > w.code) return wrong(fmt::format("{:#x} or less", w.code), fmt::format("{:#x}", *again));
  if (const Vector<side> meant = of.decode(w.how, *again); meant != v)
    return wrong(letters(v), letters(meant));
  return {*again};
}

constexpr std::array<Code4, 4> ways{Code4::simple, Code4::vertical, Code4::horizontal, Code4::generic};

/// The words of each way, then its pairs.
Word word_number(Level n, std::uint64_t k) {
  if (n == 1) {
    if (k < 32) return {2, Code4::generic, false, static_cast<std::uint32_t>(k)};
    k -= 32;
    const auto o = static_cast<std::uint32_t>(k / 3), t = static_cast<std::uint32_t>(k % 3);
    return {2, Code4::generic, true, 16 * o + (t < o ? t : t + 1)};
  }
  for (const Code4 how : ways) {
    const std::uint64_t words = std::uint64_t{1} << code_bits(4, how);
    if (k < words) return {4, how, false, static_cast<std::uint32_t>(k)};
    k -= words;
    if (k < 240) {
      const auto o = static_cast<std::uint32_t>(k / 15), t = static_cast<std::uint32_t>(k % 15);
      return {4, how, true, 16 * o + (t < o ? t : t + 1)};
    }
    k -= 240;
  }
  throw std::logic_error("vq.codes: no such case");
}

Word word_from(Level n, const std::string& at) {
  const auto bad = [&] {
    return BadCase(
        fmt::format("'{:.60}': write simple, vertical, horizontal or generic, at level 1 mini, then "
                    ":0xWORD or -pair:O,T",
                    at));
  };
  const std::size_t colon = at.find(':');
  if (colon == std::string::npos) throw bad();
  std::string kind = at.substr(0, colon);
  const bool pair = kind.ends_with("-pair");
  if (pair) kind.resize(kind.size() - 5);
  return at_side(n, [&](auto side) {
    const auto found = std::find(kinds.begin(), kinds.end(), kind);
    const auto number = static_cast<std::size_t>(found - kinds.begin());
    if (found == kinds.end() || (number == 4) != (side == 2)) throw bad();
    const Code4 how = side == 2 ? Code4::generic : ways[number];
    const std::string rest = at.substr(colon + 1);
    unsigned long long first = 0, second = 0;
    int read = -1;
    if (pair) {
      if (std::sscanf(rest.c_str(), "%2llu,%2llu%n", &first, &second, &read) != 2 || first == second ||
          first >= side * side || second >= side * side)
        throw bad();
    } else if (std::sscanf(rest.c_str(), "0x%8llx%n", &first, &read) != 1 ||
               first >> code_bits(side, how) != 0) {
      throw bad();
    }
    if (static_cast<std::size_t>(read) != rest.size()) throw bad();
    return Word{side, how, pair, static_cast<std::uint32_t>(pair ? 16 * first + second : first)};
  });
}

Law codes_law() {
  Cases<Word> cases;
  cases.count = [](Level n, const Run&) -> std::uint64_t {
    return n == 1 ? 32 + 12 : (1u << 17) + 2 * (1u << 18) + (1u << 20) + 4 * 240;
  };
  cases.number = [](Level n, std::uint64_t k, std::uint64_t) { return word_number(n, k); };
  cases.text = text_of;
  cases.read = word_from;
  cases.check = [](const VqSubject& s, const Word& w) {
    return w.side == 2 ? writes<2>(s, w) : writes<4>(s, w);
  };
  cases.chunk = 4096;
  return over(
      {.id = "vq.codes",
       .topic = "vq",
       .says =
           "a code word decodes by figure 4 and table 2, and encoding that gives the least word that means "
           "it; O and T are written where each has its palette, and nowhere else",
       .source = "Compressed Opacity Maps, figure 4, 5.1 and table 2",
       .subjects = {"vq-spec"},
       .fast = both_sides,
       .fast_seconds = 1,
       .domain =
           [](const Subject&, Level n) {
             return std::string(n == 1
                                    ? "all words of 5 bits; O at one region, T at another, C elsewhere"
                                    : "all words of 17, 18, 18 and 20 bits; O at one region, T at another, "
                                      "C elsewhere, each of the four ways");
           },
       .mutants = {mutant("one word of 20 bits has T for C in its last region", "vq-spec", {2, 2},
                          [](Parts& parts) {
                            parts.of4.decode = [real = parts.of4.decode](Code4 how, std::uint32_t code) {
                              Vector<4> v = real(how, code);
                              if (how == Code4::generic && code == 0x7beef) v[15] = T;
                              return v;
                            };
                          }),
                   mutant("all C is written with the palette of O", "vq-spec", {1, 1},
                          [](Parts& parts) {
                            parts.of2.encode = [real = parts.of2.encode](Code4 how, const Vector<2>& v) {
                              auto code = real(how, v);
                              if (v == spec::vq::uniform<2>(C)) code = 31;
                              return code;
                            };
                          }),
                   mutant("a horizontal line takes O and T of one row", "vq-spec", {2, 2},
                          [](Parts& parts) {
                            parts.of4.encode = [real = parts.of4.encode](Code4 how, const Vector<4>& v) {
                              auto code = real(how, v);
                              if (how == Code4::horizontal && v[12] == O && v[15] == T && !code)
                                code = 0x36fff;
                              return code;
                            };
                          })}},
      lacks_vectors, cases);
}

}  // namespace

std::vector<Law> vector_laws() { return {vectors_law(), transforms_law(), codes_law()}; }

}  // namespace mmverify::proofs::vq
