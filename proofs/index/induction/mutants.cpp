#include "proofs/index/mutants.hpp"

#include "proofs/index/induction/lemmas.hpp"
#include "proofs/index/induction/provable.hpp"
#include "proofs/index/induction/word_lemmas.hpp"
#include "proofs/index/subjects/exact_subject.hpp"

namespace mmverify::proofs::index::induction {
namespace {

/// A subject with an altered formula, which answers by it and brings statements about it.
template <class Formula>
class Wrong : public IndexSubject, public Provable {
 public:
  using Statements = std::vector<Statement> (*)();
  Wrong(const std::string& name, Statements statements)
      : IndexSubject(name, "broken on purpose", exactly<Formula>()), statements_(statements) {}
  std::vector<Statement> statements() const override { return statements_(); }

 private:
  Statements statements_;
};

template <class Formula>
Mutant in_all_levels(const char* name, Level search) {
  return {name,
          std::make_shared<Wrong<ByFormula<Formula>>>(
              name, all_levels_statements<Formula, spec::index::Reading::printed>),
          {0, search}};
}
template <class Formula>
Mutant in_wide(const char* name, Level search) {
  return {name, std::make_shared<Wrong<ByFormula<Formula>>>(name, wide_statements<Formula>), {0, search}};
}

template <class Formula>
Mutant in_impl(const char* name, Level search) {
  return {name, std::make_shared<Wrong<ByImplFormula<Formula>>>(name, impl_statements<Formula>), {0, search}};
}

struct HypotenuseNotApart : Specified {
  template <class Word, class Q>
  static Quantised<Word> quantise(const Q& un, const Q& vn, const Word& N) {
    const auto s = whole(un) + whole(vn);
    Quantised<Word> q = Specified::quantise<Word>(un, vn, N);
    const Q uf = un - Q(whole(un)), vf = vn - Q(whole(vn));
    // The formula does not lower iw if s = N-1; this one does.
    if (!(s < N - 1) && s < N && !(uf + vf < Q(1))) q.iw = q.iw - 1;
    return q;
  }
};

struct LowersIwAboveOneOnly : Specified {
  template <class Word, class Q>
  static Quantised<Word> quantise(const Q& un, const Q& vn, const Word& N) {
    const Q uf = un - Q(whole(un)), vf = vn - Q(whole(vn));
    return spec::index::grid_square<Word>(whole(un), whole(vn), Q(1) < uf + vf, N);
  }
};

struct WithoutT : Specified {
  template <class Word, class PrefixXor>
  static CurveBits<Word> bits(const Quantised<Word>& q, const Word& low, PrefixXor prefix_xor) {
    const CurveBits<Word> right = spec::index::curve_bits(q, low, prefix_xor);
    return {right.b0, right.b1 & ~((q.iu ^ q.iv) & right.b0)};
  }
};

struct PrefixOfOneBit : Specified {
  template <class Word, class PrefixXor>
  static CurveBits<Word> bits(const Quantised<Word>& q, const Word& low, PrefixXor prefix_xor) {
    return spec::index::curve_bits(q, low, [&](const Word& t) {
      prefix_xor(t);  // called, as the statements take t from there, but without effect
      return t;
    });
  }
};

struct PrefixOverEightBits : Specified {
  template <class Word>
  static Word prefix_xor(const Word& t) {
    return spec::index::xor_from_above<8>(t);
  }
};

struct SpreadWithAWrongMask : Specified {
  template <class Word>
  static Word spread(const Word& x) {
    // The bit of place 3 is lost on its way to place 6.
    return spec::index::spread(x) & ~(Word{1} << 6);
  }
};

struct VNotKeptBelowN : Specified {
  template <class Word>
  static Quantised<Word> grid_square(const Word& iu, const Word& iv, bool upper_half, const Word& N) {
    Quantised<Word> q = spec::index::grid_square<Word>(iu, iv, upper_half, N);
    if (!(iv < N)) q.iv = N;
    return q;
  }
  template <class Word, class Q>
  static Quantised<Word> quantise(const Q& un, const Q& vn, const Word& N) {
    const Q uf = un - Q(whole(un)), vf = vn - Q(whole(vn));
    return grid_square<Word>(whole(un), whole(vn), !(uf + vf < Q(1)), N);
  }
};

struct NeverCarries : Implemented {
  template <class Word>
  static Square<Word> square(const Word& iu, const Word& iv, bool, const Word& N) {
    return Implemented::square<Word>(iu, iv, false, N);
  }
};

struct ExchangesUAndV : Implemented {
  template <class Word>
  static Square<Word> square(const Word& iu, const Word& iv, bool carry, const Word& N) {
    return Implemented::square<Word>(iv, iu, carry, N);
  }
};

struct LosesBit10 : Implemented {
  template <class Word>
  static Word curve(const Square<Word>& q) {
    return Implemented::curve<Word>(q) & ~(Word{1} << 10);
  }
};

}  // namespace

std::vector<Mutant> mutants_of_all_levels(Level search) {
  return {{"the middle triangle's coordinates in Appendix A's order",
           built_in("step-appendix-middle"),
           {0, search}},
          {"the R test's exception on u, as Appendix A's prose has it",
           built_in("step-appendix-ties"),
           {0, search}},
          {"Appendix A's coordinates under L, R and T", built_in("step-appendix-names"), {0, search}},
          in_all_levels<HypotenuseNotApart>("the hypotenuse is not handled apart", search),
          in_all_levels<LowersIwAboveOneOnly>("iw is lowered where uf+vf > 1, not at 1", search),
          in_all_levels<WithoutT>("b1 without t", search),
          in_all_levels<PrefixOfOneBit>("the prefix XOR is of a bit by itself", search)};
}

std::vector<Mutant> mutants_of_impl_wide(Level search) {
  return {in_impl<NeverCarries>("the upper half of a square is not told from the lower", search),
          in_impl<ExchangesUAndV>("u and v exchanged", search),
          in_impl<LosesBit10>("bit 10 of the index is lost", search)};
}

std::vector<Mutant> mutants_of_wide_is_vulkan(Level search) {
  return {in_wide<PrefixOverEightBits>("the prefix XOR reaches 8 bits only", search),
          in_wide<SpreadWithAWrongMask>("one bit of a mask of spread is missing", search),
          in_wide<VNotKeptBelowN>("iv is not kept below N", search)};
}

}  // namespace mmverify::proofs::index::induction
