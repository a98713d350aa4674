#include "proofs/index/source/statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "proofs/index/binary32/exact.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::index::source {

using namespace proofs::induction;
using binary32::Exact;
using binary32::ExactIn;
using binary32::exactly;

namespace {

using W = Word<32>;
using Q = ExactIn<32>;

constexpr unsigned of_one = 127;  // the exponent field of 1

/// The last exponent field of the numbers that are taken together: below 2^-26 grid steps.
unsigned last_of_far(Level n) { return 100 - n; }

std::vector<Range> ranges_of(Level n) {
  std::vector<Range> all;
  for (unsigned field = of_one; field > last_of_far(n); --field) all.push_back({false, field, field});
  all.push_back({false, 0, last_of_far(n)});
  all.push_back({true, 0, 0});
  return all;
}

/// Whether some u and v of the ranges have u + v <= 1 + 2^-23: the least numbers of both.
bool meets_the_domain(const Range& u, const Range& v) {
  const auto least = [](const Range& r) {
    return r.first == 0 ? 0.0 : std::ldexp(1.0, static_cast<int>(r.first) - 127);
  };
  return least(u) + least(v) <= 1 + 0x1p-23;
}

/// Less is harder: floats are wrong where one coordinate reaches over grid lines and the other is as small as what
/// the first one's part misses of 1; then where both reach over lines; the rest is one half of the first square.
unsigned ease(Level n, const Pair& p) {
  const int grid = static_cast<int>(of_one - n);
  const int greater = static_cast<int>(std::max(p.u.last, p.v.last)),
            lesser = static_cast<int>(std::min(p.u.last, p.v.last));
  // The unit in the last place of the greater part.
  const int missed = greater - 24;
  if (greater >= grid - 1)
    return static_cast<unsigned>(std::abs(lesser - missed)) +
           static_cast<unsigned>(of_one - static_cast<unsigned>(greater)) / 4;
  return 64 + static_cast<unsigned>(of_one) - static_cast<unsigned>(greater);
}

Term constant(std::uint64_t k) { return W(k).term; }
Term at_most(const Term& a, const Term& b) { return apply("bvule", {a, b}, boolean); }
Term size_of(const Term& bits) { return (W(bits) & W(0x7fffffff)).term; }

std::string words_for(const char* name, const Range& r) {
  if (r.negative) return fmt::format("{} = -0", name);
  if (r.first != 0)
    return fmt::format("2^{} <= {} < 2^{}", static_cast<int>(r.first) - 127, name,
                       static_cast<int>(r.last) - 126);
  return fmt::format("0 <= {} < 2^{}", name, static_cast<int>(r.last) - 126);
}

Term declare_coordinate(Script& script, const char* name, const Range& range) {
  const std::string n = name;
  if (range.first == range.last && range.first != 0) {
    const Term fraction = script.declare(n + "_fraction", word_sort(23));
    const Term top(fmt::format("(_ bv{} 9)", range.first + (range.negative ? 256 : 0)), word_sort(9));
    return script.define(n, apply("concat", {top, fraction}, word_sort(32)));
  }
  const Term bits = script.declare(n, word_sort(32));
  const std::uint32_t sign = range.negative ? 0x80000000 : 0;
  script.require(at_most(constant(sign | range.first << 23), bits));
  script.require(at_most(bits, constant(sign | range.last << 23 | 0x7fffff)));
  return bits;
}

struct Coordinates {
  Term u, v;
};

/// u and v of the ranges and of the domain.
Coordinates declare_coordinates(Script& script, const Pair& pair) {
  binary32::define_binary32(script);
  const Coordinates c{declare_coordinate(script, "u", pair.u), declare_coordinate(script, "v", pair.v)};
  for (const auto& [bits, range] : {std::pair(c.u, pair.u), std::pair(c.v, pair.v)})
    script.require(range.negative ? equal(bits, constant(0x80000000)) : at_most(bits, constant(0x3f800000)));
  // An ulp is 2^-23.
  const Exact sum = Exact(exactly(size_of(c.u))) + Exact(exactly(size_of(c.v)));
  const Exact ulp(apply("bvshl",
                        {Word<Exact::bits>(1).term, Word<Exact::bits>(Exact::fraction_bits - 23).term},
                        Exact::sort()));
  script.require(at_most(sum.term, (Exact(1) + ulp).term));
  return c;
}

/// The grid square of a dialect, given by uN and vN.
spec::index::Quantised<W> square_of(Dialect dialect, const Q& un, const Q& vn, const W& N) {
  if (dialect == Dialect::exact) return spec::index::quantise_scaled<W>(un, vn, N);
  const W iu = whole(un), iv = whole(vn);
  const Exact hair(apply("bvshl",
                         {Word<Exact::bits>(1).term, Word<Exact::bits>(Exact::fraction_bits - 25).term},
                         Exact::sort()));
  const Q sum = un - Q(iu) + (vn - Q(iv)), least(Exact(1) - hair);
  return spec::index::grid_square<W>(iu, iv, !(sum < least), N);
}

Term index_of(Script& script, Level n, const Coordinates& c, Dialect dialect) {
  const auto scaled = [&](const char* name, const Term& bits) {
    const Q x(script.define(std::string("exact_") + name, exactly(size_of(bits))));
    const auto clamped = every_path([&] { return spec::index::within_unit(x); });
    const Q inside(
        script.define(std::string("inside_") + name, as_formula(clamped, [](const Q& q) { return q.term; })));
    return Q(script.define(std::string("scaled_") + name, times(spec::side(n), inside).term));
  };
  const Q un = scaled("u", c.u), vn = scaled("v", c.v);
  const W N(spec::side(n));
  using Square = spec::index::Quantised<W>;
  const auto squares = every_path([&] { return square_of(dialect, un, vn, N); });
  const Square square{W(script.define("iu", as_formula(squares, [](const Square& q) { return q.iu.term; }))),
                      W(script.define("iv", as_formula(squares, [](const Square& q) { return q.iv.term; }))),
                      W(script.define("iw", as_formula(squares, [](const Square& q) { return q.iw.term; })))};
  return script.define("reference", spec::index::curve(square, W(spec::side(n) - 1)).term);
}

}  // namespace

std::vector<Pair> pairs_of(Level n, const std::vector<unsigned>& fields) {
  std::vector<Pair> all;
  const std::vector<Range> ranges = ranges_of(n);
  for (const Range& u : ranges)
    for (const Range& v : ranges)
      if (meets_the_domain(u, v)) all.push_back({u, v});
  const auto named = [&](const Range& r) {
    return std::any_of(fields.begin(), fields.end(), [&](unsigned f) { return r.first <= f && f <= r.last; });
  };
  const auto key = [&](const Pair& p) { return std::pair(-named(p.u) - named(p.v), ease(n, p)); };
  std::stable_sort(all.begin(), all.end(), [&](const Pair& a, const Pair& b) { return key(a) < key(b); });
  return all;
}

std::uint64_t count_of_pairs(Level n) {
  // All but those of 1 and a number of 2^-22 or more, 1 included.
  const std::uint64_t ranges = std::uint64_t{n} + 29;
  return ranges * ranges - 45;
}

Statement statement_of(Level n, const Pair& pair, const Formula& formula, Dialect dialect,
                       const std::optional<Bits>& at) {
  Script script(
      fmt::format("level_{}_u_{}_{}_v_{}_{}", n, pair.u.negative ? "minus" : "from", pair.u.first,
                  pair.v.negative ? "minus" : "from", pair.v.first),
      Answer::unsat,
      fmt::format("Level {}, {}, {}: the function's index is defined and that of {}.", n,
                  words_for("u", pair.u), words_for("v", pair.v),
                  dialect == Dialect::exact ? "the exact reference" : "the published code in binary32"));
  const Coordinates c = declare_coordinates(script, pair);
  if (at) {
    script.require(equal(c.u, constant(at->u)));
    script.require(equal(c.v, constant(at->v)));
  }
  script.comment("The specification.");
  const Term wanted = index_of(script, n, c, dialect);
  script.comment("The function.");
  script.raw(formula.declarations);
  script.raw(fmt::format("(declare-const {} (_ BitVec 32))\n", claimed_index));
  std::string claim = fmt::format("(= {} {})", claimed_index, formula.index);
  const auto reveal = [&](const std::string& name, const std::string& condition) {
    script.raw(fmt::format("(declare-const {} (_ BitVec 1))\n", name));
    claim += fmt::format(" (= {} (ite {} #b1 #b0))", name, condition);
  };
  reveal(claimed_undefined, formula.undefined);
  for (std::size_t k = 0; k < formula.causes.size(); ++k)
    reveal(claimed_cause(k), formula.causes[k].condition);
  // Not `define-fun`: z3 takes ten times as long to read those.
  script.raw("(assert\n");
  for (const auto& [name, meaning] : formula.definitions)
    script.raw(fmt::format("(let (({} {}))\n", name, meaning));
  script.raw(fmt::format("(and {} (or {} (not (= {} {})))){}\n", claim, formula.undefined, wanted.head(),
                         formula.index, std::string(formula.definitions.size() + 1, ')')));
  return script.finish();
}

std::string claimed_cause(std::size_t k) { return fmt::format("code_cause_{}", k); }

Statement witness_of(Level n, const Pair& pair) {
  Script script(
      fmt::format("witness_level_{}", n), Answer::sat,
      fmt::format("Not vacuous: some numbers have {}, {}.", words_for("u", pair.u), words_for("v", pair.v)));
  declare_coordinates(script, pair);
  return script.finish();
}

}  // namespace mmverify::proofs::index::source
