// Which vectors there are (2, 4, 5.1): the oracle is neighbourhoods of sets.

#include "proofs/vq/law_parts.hpp"
#include "proofs/vq/laws.hpp"
#include "proofs/vq/texts.hpp"

namespace mmverify::proofs::vq {
namespace {

using enum State;

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
      const bool got = s.functions.vectors<side>().valid(v);
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

}  // namespace

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
    return [=](Functions& functions) {
      constexpr std::size_t side = std::tuple_size_v<decltype(vector)> == 4 ? 2 : 4;
      auto& valid = functions.vectors<side>().valid;
      valid = [=, real = valid](const Vector<side>& v) { return v == vector ? answer : real(v); };
    };
  };
  return on_cases(
      {.id = "vq.vectors",
       .says = "31 of the 2x2 vectors and 231,713 of the 4x4 ones hold no O beside T, diagonals included",
       .source = "Compressed Opacity Maps, 4 and 5.1",
       .subjects = {"vq-spec"},
       .tiers = {.fast = both_sides, .seconds = 1},
       .domain =
           [](Level n) {
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

}  // namespace mmverify::proofs::vq
