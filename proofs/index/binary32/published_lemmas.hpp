// The lemmas of index.published_differs_where: the reference's text run in binary32, on names.
#pragma once

#include <optional>
#include <stdexcept>

#include "proofs/index/binary32/exact.hpp"
#include "proofs/index/induction/word_lemmas.hpp"
#include "proofs/induction/floating.hpp"

namespace mmverify::proofs::index::binary32 {

using proofs::induction::Binary32;
using proofs::induction::Script;
using proofs::induction::Statement;

/// A binary32 number as a number of the specification's templates, with the operations that spec::Number has for
/// float.
class Rounded {
 public:
  explicit Rounded(std::uint32_t k) : number(static_cast<float>(k)) {}
  explicit Rounded(const proofs::induction::Word<32>& k)
      : number(
            proofs::induction::apply("(_ to_fp_unsigned 8 24) RNE", {k.term}, proofs::induction::binary32)) {}
  explicit Rounded(Binary32 x) : number(std::move(x)) {}
  Binary32 number;

  friend Rounded operator+(const Rounded& a, const Rounded& b) { return Rounded(a.number + b.number); }
  friend Rounded operator-(const Rounded& a, const Rounded& b) { return Rounded(a.number - b.number); }
  friend Rounded times(std::uint32_t k, const Rounded& a) { return Rounded(Rounded(k).number * a.number); }
  friend bool operator<(const Rounded& a, const Rounded& b) { return a.number < b.number; }
  friend bool operator==(const Rounded& a, const Rounded& b) {
    return proofs::induction::decided(
        proofs::induction::apply("fp.eq", {a.number.term, b.number.term}, proofs::induction::boolean));
  }
  friend proofs::induction::Word<32> whole(const Rounded& a) {
    return proofs::induction::Word<32>(
        proofs::induction::apply("(_ fp.to_ubv 32) RTZ", {a.number.term}, proofs::induction::word_sort(32)));
  }
};

/// A Rounded number whose scaled coordinates are pairs of names, a whole part and the rest.  The text that splits
/// coordinates has a lemma of its own.
class Parted {
 public:
  using Whole = proofs::induction::Word<32>;
  explicit Parted(std::uint32_t k) : value_(Rounded(k)) {}
  explicit Parted(Rounded x) : value_(std::move(x)) {}
  explicit Parted(Whole k) : whole_(std::move(k)) {}
  Parted(Whole k, Rounded rest) : whole_(std::move(k)), rest_(std::move(rest)) {}

  /// The rest of a coordinate less its own whole part; or the difference of two numbers.
  friend Parted operator-(const Parted& a, const Parted& b) {
    if (!a.rest_) return Parted(a.value() - b.value());
    if (b.rest_ || !b.whole_ || !(b.whole_->term == a.whole_->term))
      throw std::logic_error("a coordinate less something else than its whole part");
    return Parted(*a.rest_);
  }
  friend Parted operator+(const Parted& a, const Parted& b) { return Parted(a.value() + b.value()); }
  friend Parted times(std::uint32_t k, const Parted& a) { return Parted(times(k, a.value())); }
  friend bool operator<(const Parted& a, const Parted& b) { return a.value() < b.value(); }
  friend bool operator==(const Parted& a, const Parted& b) { return a.value() == b.value(); }
  friend Whole whole(const Parted& a) { return a.whole_.value(); }

 private:
  const Rounded& value() const { return value_.value(); }
  std::optional<Whole> whole_;
  std::optional<Rounded> rest_, value_;
};

/// The published code's grid square, which a mutant can replace.
struct Printed {
  template <class Word, class Q>
  static spec::index::Quantised<Word> square(const Q& un, const Q& vn, const Word& N) {
    return spec::index::quantise_scaled<Word>(un, vn, N);
  }
};

/// The lemmas of the code outside the square: clamping and scaling, whole parts and rests, and the results of the
/// square's two halves.
std::vector<Statement> statements_of_published_numbers();

/// N up to 2^16, whole parts up to N and the bits of rests in [-0, 1).
struct PublishedInput {
  proofs::induction::Term N, iu, iv, uf, vf;
};
PublishedInput declare_published_input(Script& script);
/// The condition that uf+vf >= 1 - 2^-25.
proofs::induction::Term reaches_published_one(const PublishedInput& in);

/// The lemma of a code's square in binary32.
template <class Code>
Statement published_square_lemma() {
  using namespace proofs::induction;
  using W = Word<32>;
  using Square = spec::index::Quantised<W>;
  Script script(
      "square", Answer::unsat,
      "For all whole parts iu and iv in [0, N], N <= 2^16, and rests uf and vf, binary32 numbers in [-0, 1): "
      "in binary32 the specification's square is that of iu, iv and uf + vf >= 1 - 2^-25 exactly.\n"
      "spec::index::quantise_scaled on binary32; grid_square.");
  const PublishedInput in = declare_published_input(script);
  const auto got = every_path([&] {
    return Code::template square<W>(Parted(W(in.iu), Rounded(Binary32::of_bits(in.uf))),
                                    Parted(W(in.iv), Rounded(Binary32::of_bits(in.vf))), W(in.N));
  });
  const Term upper = script.define("upper_half", reaches_published_one(in));
  const auto wanted =
      every_path([&] { return spec::index::grid_square<W>(W(in.iu), W(in.iv), decided(upper), W(in.N)); });
  std::vector<Term> claims;
  const auto claim = [&](auto project) {
    claims.push_back(equal(as_formula(got, project), as_formula(wanted, project)));
  };
  claim([](const Square& q) { return q.iu.term; });
  claim([](const Square& q) { return q.iv.term; });
  claim([](const Square& q) { return q.iw.term; });
  return script.denying(std::move(claims));
}

template <class Code>
std::vector<Statement> published_statements() {
  std::vector<Statement> all = statements_of_published_numbers();
  all.push_back(published_square_lemma<Code>());
  return all;
}

}  // namespace mmverify::proofs::index::binary32
