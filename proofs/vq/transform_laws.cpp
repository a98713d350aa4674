// Laws of the transforms of vectors (4.1, table 1); the oracle is signed coordinates.

#include "proofs/vq/law_parts.hpp"
#include "proofs/vq/laws.hpp"
#include "proofs/vq/texts.hpp"

namespace mmverify::proofs::vq {
namespace {

using enum State;

/// The matrix of a row of table 1, for X, Y counted from the middle, y upwards: (a X + b Y, c X + d Y).
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

/// The row `then` after the row `first`; for a single row, `first` is the identity.
struct Pair {
  std::uint32_t then, first, side;
};

/// A vector of one state with one other region, which must move as the matrix says: for each place, and for each
/// state among each other.
template <std::size_t side>
Finding moves(const VqSubject& s, const char* what, Linear does, const auto& turned) {
  constexpr int last = side - 1;
  for (int k = 0; k < 6 * (last + 1) * (last + 1); ++k) {
    const int x = k / 6 % (last + 1), y = k / 6 / (last + 1), X = 2 * x - last, Y = 2 * y - last;
    const auto around = static_cast<State>(k % 3), odd = static_cast<State>((k + 1 + k / 3 % 2) % 3);
    Vector<side> v = spec::vq::uniform<side>(around), expected = v;
    v[static_cast<std::size_t>(x + (last + 1) * y)] = odd;
    const int to_x = (does.a * X + does.b * Y + last) / 2, to_y = (does.c * X + does.d * Y + last) / 2;
    expected[static_cast<std::size_t>(to_x + (last + 1) * to_y)] = odd;
    const Vector<side> got = turned(s.functions.vectors<side>(), v);
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
  const std::uint32_t got = s.functions.composed(then, first).number();
  if (got != row) return wrong(fmt::format("row {}", row), fmt::format("row {}", got));
  // The eight rows are closed under composition and finite in number; that each has an inverse is a case of its own.
  bool undone = false;
  for (std::uint32_t k = 0; k < 8; ++k)
    undone = undone || s.functions.composed(Transform::of(k), then).number() == 0;
  return undone ? Finding{got} : wrong("an inverse", "none");
}

}  // namespace

Law transforms_law() {
  Cases<Pair> cases;
  cases.count = 64;
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
    return [=](Functions& functions) {
      auto& applied = functions.vectors<side>().applied;
      applied = [=, real = applied](Transform t, const auto& v) {
        auto out = real(t, v);
        if (t.number() == row) wrongly(out);
        return out;
      };
    };
  };
  constexpr std::integral_constant<std::size_t, 2> two{};
  constexpr std::integral_constant<std::size_t, 4> four{};
  return on_cases(
      {.id = "vq.transforms",
       .says = "table 1's rows do what it says they result in, and are the symmetries of the square: closed, "
               "each with its inverse",
       .source = "Compressed Opacity Maps, 4.1, table 1",
       .subjects = {"vq-spec"},
       .tiers = {.fast = both_sides, .seconds = 0.1},
       .domain =
           [](Level n) {
             return fmt::format(
                 "all pairs of rows, on {} vectors of one state but for one region, each region, each two "
                 "states",
                 n == 1 ? "2x2" : "4x4");
           },
       .mutants = {mutant("Rotate 270 leaves two middle regions of 4x4 in each other's place", "vq-spec",
                          {2, 2}, turns(four, 7, [](auto& v) { std::swap(v[5], v[6]); })),
                   mutant("Reflect X=-Y is Reflect X=Y", "vq-spec", {1, 1},
                          turns(two, 3, [](auto& v) { std::swap(v[0], v[3]), std::swap(v[1], v[2]); })),
                   mutant("Rotate 90 after Reflect LR is another row", "vq-spec", {1, 2},
                          [](Functions& functions) {
                            functions.composed = [real = functions.composed](Transform then,
                                                                             Transform first) {
                              return then.number() == 1 && first.number() == 4 ? Transform::of(5)
                                                                               : real(then, first);
                            };
                          })}},
      lacks_vectors, cases);
}

}  // namespace mmverify::proofs::vq
