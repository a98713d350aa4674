// Points times the side, as statements about the steps after the first speak of them.
#pragma once

#include "proofs/index/binary32/exact.hpp"
#include "proofs/index/induction/word_lemmas.hpp"

namespace mmverify::proofs::index::binary32 {

/// un and vn as whole parts in [0, N] and rests below 1, all in units of 2^-149.
struct Scaled {
  Term N, iu, iv, uf, vf, un, vn;
};
template <unsigned bits>
Scaled declare_scaled(proofs::induction::Script& script, std::uint64_t most) {
  using induction::at_most;
  using Wide = proofs::induction::Word<bits>;
  const Term N = script.declare("N", Wide::sort()), iu = script.declare("iu", Wide::sort()),
             iv = script.declare("iv", Wide::sort()), uf = script.declare("uf", Exact::sort()),
             vf = script.declare("vf", Exact::sort());
  script.require(at_most(N, Wide(most).term));
  for (const Term& word : {iu, iv}) script.require(at_most(word, N));
  for (const Term& part : {uf, vf})
    script.require(proofs::induction::apply("bvult", {part, Exact(1).term}, proofs::induction::boolean));
  return {N,
          iu,
          iv,
          uf,
          vf,
          script.define("un", (Exact(Wide(iu)) + Exact(uf)).term),
          script.define("vn", (Exact(Wide(iv)) + Exact(vf)).term)};
}

}  // namespace mmverify::proofs::index::binary32
