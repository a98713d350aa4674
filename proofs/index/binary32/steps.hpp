// The steps from two floats to an index, as formulas: the result of a code's templates run on names.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "impl/index/wide.hpp"
#include "proofs/induction/floating.hpp"
#include "proofs/induction/symbolic.hpp"

namespace mmverify::proofs::index::binary32 {

using proofs::induction::Term;

/// A number's whole part, a word of 32 bits, and its rest, a binary32 number.
struct CutTerms {
  Term whole, part;
};
/// A grid square below the diagonal and its row, words of 32 bits.
struct SquareTerms {
  Term iu, iv, row;
};

/// A row, and the place in it by v and by u, words of 32 bits.
struct RowTerms {
  Term row, col, dia;
};

/// The steps of one code.  x, N, y, uf, vf are binary32 numbers; iu, iv and N of a square are words of 32 bits.
struct Steps {
  std::string name;               ///< the prefix of its statements' names
  std::vector<std::string> free;  ///< Booleans that its formulas leave open, with any value
  std::function<Term(const Term& x, const Term& N)> scaled;
  std::function<CutTerms(const Term& y)> cut;
  std::function<Term(const Term& uf, const Term& vf)> reach_one;  ///< the word 1 or 0
  std::function<Term(const Term& uf)> is_more_than_none;          ///< the word 1 or 0
  std::function<SquareTerms(const Term& iu, const Term& iv, const Term& carry, const Term& N)> square;
  std::function<Term(const SquareTerms&)> curve;
  /// The place in row order; carry and beyond are Booleans.
  std::function<RowTerms(const Term& iu, const Term& iv, const Term& carry, const Term& beyond,
                         const Term& N)>
      row_place;
};

/// impl's steps for one value, which a mutant can replace one by one.
struct Implemented {
  template <class F>
  static F scaled(const F& x, const F& N) {
    return impl::index::detail::scaled<F>(x, N);
  }
  template <class Signed, class F>
  static impl::index::detail::Cut<Signed, F> cut(const F& y) {
    return impl::index::detail::cut<Signed, F>(y);
  }
  template <class F>
  static bool reach_one(const F& uf, const F& vf) {
    return impl::index::detail::reach_one<F>(uf, vf);
  }
  template <class Word>
  static impl::index::detail::Square<Word> square(const Word& iu, const Word& iv, bool carry, const Word& N) {
    return impl::index::detail::square<Word>(iu, iv, carry, N);
  }
  template <class F>
  static bool is_more_than_none(const F& uf) {
    return impl::index::detail::is_more_than_none<F>(uf);
  }
  template <class Word>
  static impl::index::detail::RowPlace<Word> row_place(const Word& iu, const Word& iv, bool carry,
                                                       bool beyond, const Word& N) {
    return impl::index::detail::row_place<Word>(iu, iv, carry, beyond, N);
  }
};

/// A code's steps, one value at a time, run on names.
template <class Code>
Steps scalar_steps() {
  using namespace proofs::induction;
  using W = Word<32>;
  const W one(1), none(0);
  return {.name = "scalar",
          .free = {},
          .scaled =
              [](const Term& x, const Term& N) {
                return as_formula(every_path([&] { return Code::scaled(Binary32(x), Binary32(N)); }),
                                  [](const Binary32& y) { return y.term; });
              },
          .cut = [](const Term& y) -> CutTerms {
            const auto paths =
                every_path([&] { return Code::template cut<SignedWord, Binary32>(Binary32(y)); });
            return {as_formula(paths, [](const auto& c) { return c.whole.term; }),
                    as_formula(paths, [](const auto& c) { return c.part.term; })};
          },
          .reach_one =
              [=](const Term& uf, const Term& vf) {
                return as_formula(every_path([&] { return Code::reach_one(Binary32(uf), Binary32(vf)); }),
                                  [=](bool yes) { return (yes ? one : none).term; });
              },
          .is_more_than_none =
              [=](const Term& uf) {
                return as_formula(every_path([&] { return Code::is_more_than_none(Binary32(uf)); }),
                                  [=](bool yes) { return (yes ? one : none).term; });
              },
          .square = [](const Term& iu, const Term& iv, const Term& carry, const Term& N) -> SquareTerms {
            const auto paths =
                every_path([&] { return Code::template square<W>(W(iu), W(iv), decided(carry), W(N)); });
            return {as_formula(paths, [](const auto& q) { return q.iu.term; }),
                    as_formula(paths, [](const auto& q) { return q.iv.term; }),
                    as_formula(paths, [](const auto& q) { return q.row.term; })};
          },
          .curve =
              [](const SquareTerms& q) {
                return impl::index::detail::curve<Word<64>>(
                           impl::index::detail::Square<W>{W(q.iu), W(q.iv), W(q.row)})
                    .term;
              },
          .row_place = [](const Term& iu, const Term& iv, const Term& carry, const Term& beyond,
                          const Term& N) -> RowTerms {
            const auto paths = every_path([&] {
              return Code::template row_place<W>(W(iu), W(iv), decided(carry), decided(beyond), W(N));
            });
            return {as_formula(paths, [](const auto& p) { return p.row.term; }),
                    as_formula(paths, [](const auto& p) { return p.col.term; }),
                    as_formula(paths, [](const auto& p) { return p.dia.term; })};
          }};
}

/// The steps of one lane of impl's code for vectors.
Steps lane_steps();
/// The steps of a mutant of that code, which compares the rounded sum with 1.
Steps lane_steps_of_plain_sums();

}  // namespace mmverify::proofs::index::binary32
