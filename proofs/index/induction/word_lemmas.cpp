#include "proofs/index/induction/word_lemmas.hpp"

namespace mmverify::proofs::index::induction {

using namespace proofs::induction;

namespace {

const Term two_to_the_64{"18446744073709551616", integer};

/// A 64-bit word as the integer in [0, 2^64) that it is: every operator is that of integers, modulo 2^64.
class Modular {
 public:
  Modular(long long k) : term(whole_number(k)) {}
  explicit Modular(Term t) : term(std::move(t)) {}
  Term term;
  friend Modular operator+(const Modular& a, const Modular& b) {
    return of(Integer(a.term) + Integer(b.term));
  }
  friend Modular operator-(const Modular& a, const Modular& b) {
    return of(Integer(a.term) - Integer(b.term));
  }
  friend Modular operator~(const Modular& a) { return of(~Integer(a.term)); }
  friend bool operator<(const Modular& a, const Modular& b) { return Integer(a.term) < Integer(b.term); }

 private:
  static Modular of(const Integer& i) { return Modular(apply("mod", {i.term, two_to_the_64}, integer)); }
};

template <class W>
Quantised<W> define_square(Script& script, const std::string& prefix, const Term& iu, const Term& iv,
                           const Term& upper, const Term& N) {
  const auto paths =
      every_path([&] { return spec::index::grid_square<W>(W(iu), W(iv), decided(upper), W(N)); });
  const auto defined = [&](const char* field, auto project) {
    return W(script.define(prefix + field, as_formula(paths, project)));
  };
  return {defined("_iu", [](const Quantised<W>& q) { return q.iu.term; }),
          defined("_iv", [](const Quantised<W>& q) { return q.iv.term; }),
          defined("_iw", [](const Quantised<W>& q) { return q.iw.term; })};
}

}  // namespace

Term bv(const char* head, std::vector<Term> of, unsigned bits) {
  return apply(head, std::move(of), word_sort(bits));
}
Term at_most(const Term& word, const Term& bound) { return apply("bvule", {word, bound}, boolean); }

GridWords declare_grid_words(Script& script) {
  const Term N = script.declare("N", word_sort(32)), iu = script.declare("iu", word_sort(32)),
             iv = script.declare("iv", word_sort(32));
  script.require(at_most(Word<32>(1).term, N));
  script.require(at_most(N, Word<32>(std::uint64_t{1} << 16).term));
  script.require(equal((Word<32>(N) & (Word<32>(N) - 1)).term, Word<32>(0).term));
  script.require(at_most(iu, N));
  script.require(at_most(iv, N));
  return {N, iu, iv};
}

Statement grid_words_witness() {
  Script script("witness_agreement", Answer::sat,
                "Not vacuous: some words fulfil what the agreement supposes, at the highest level and "
                "strictly inside.");
  const GridWords g = declare_grid_words(script);
  script.require(equal(g.N, Word<32>(std::uint64_t{1} << 16).term));
  for (const Term& word : {g.iu, g.iv})
    script.require(both({at_most(Word<32>(1).term, word), no(at_most(g.N, word))}));
  return script.finish();
}

Statement unbounded_lemma() {
  Script script("unbounded", Answer::unsat,
                "For every N up to 2^31 and all iu, iv in [0, N]: spec::index::grid_square in 64-bit words, "
                "written as integers modulo 2^64, has the iu and iv of integers without bounds; its iw is "
                "2^64 more than theirs, which is negative.\nSo the low n bits, N = 2^n, are the same.");
  const Term N = script.declare("N", integer), iu = script.declare("iu", integer),
             iv = script.declare("iv", integer), upper = script.declare("upper_half", boolean);
  const auto at_most_integer = [](const Term& a, const Term& b) { return apply("<=", {a, b}, boolean); };
  script.require(both({at_most_integer(whole_number(1), N), at_most_integer(N, whole_number(1LL << 31))}));
  for (const Term& word : {iu, iv})
    script.require(both({at_most_integer(whole_number(0), word), at_most_integer(word, N)}));
  script.comment("Without bounds.");
  const auto free = define_square<Integer>(script, "free", iu, iv, upper, N);
  script.comment("Modulo 2^64.");
  const auto wide = define_square<Modular>(script, "wide", iu, iv, upper, N);
  script.comment("Denied: they are the same, as said.");
  return script.denying({equal(wide.iu.term, free.iu.term), equal(wide.iv.term, free.iv.term),
                         equal(wide.iw.term, (free.iw + Integer(two_to_the_64)).term)});
}

using namespace proofs::induction;

namespace {
using W = Word<64>;
const W largest_N(std::uint64_t{1} << impl::index::max_wide_level);
}  // namespace

GridWords declare_wide_grid_words(Script& script) {
  const Term N = script.declare("N", word_sort(64)), iu = script.declare("iu", word_sort(64)),
             iv = script.declare("iv", word_sort(64));
  script.require(at_most(W(1).term, N));
  script.require(at_most(N, largest_N.term));
  script.require(equal((W(N) & (W(N) - 1)).term, W(0).term));
  script.require(at_most(iu, N));
  script.require(at_most(iv, N));
  return {N, iu, iv};
}

Statement wide_square_witness() {
  Script script("witness_square", Answer::sat,
                "Not vacuous: some words fulfil what the statement about squares supposes, at the highest "
                "level and strictly inside.");
  const GridWords g = declare_wide_grid_words(script);
  script.require(equal(g.N, largest_N.term));
  for (const Term& word : {g.iu, g.iv})
    script.require(both({at_most(W(1).term, word), no(at_most(g.N, word))}));
  return script.finish();
}

}  // namespace mmverify::proofs::index::induction
