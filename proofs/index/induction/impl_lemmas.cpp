#include "proofs/index/induction/impl_lemmas.hpp"

namespace mmverify::proofs::index::induction {

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
