#include "proofs/index/mutants.hpp"

#include "proofs/index/binary32/law.hpp"
#include "proofs/index/binary32/lemmas.hpp"

namespace mmverify::proofs::index::binary32 {
namespace {

struct PlainSum : Implemented {
  template <class F>
  static bool reach_one(const F& uf, const F& vf) {
    return uf + vf >= F(1.0f);
  }
};

struct BothFromOne : Implemented {
  template <class F>
  static bool reach_one(const F& uf, const F& vf) {
    return F(1.0f) - uf - vf <= F(0.0f);
  }
};

struct LesserFromOne : Implemented {
  template <class F>
  static bool reach_one(const F& uf, const F& vf) {
    return std::max(uf, vf) >= F(1.0f) - std::min(uf, vf);
  }
};

/// A bias by 1 and back, which loses the bits for which x + 1 has no room.
struct BiasedByOne : Implemented {
  template <class F>
  static F scaled(const F& x, const F& N) {
    return Implemented::scaled(x, N) + F(1.0f) - F(1.0f);
  }
};

/// A bias upwards, against whole numbers that come out a hair too low.
struct BiasedUp : Implemented {
  template <class Signed, class F>
  static impl::index::detail::Cut<Signed, F> cut(const F& y) {
    const Signed whole = static_cast<Signed>(y + F(0x1p-25f));
    return {whole, y - static_cast<F>(whole)};
  }
};

/// A scale that flushes numbers below an ulp of 1 to 0.
struct DeafToSmall : Implemented {
  template <class F>
  static F scaled(const F& x, const F& N) {
    const F y = Implemented::scaled(x, N);
    return y < F(0x1p-23f) ? F(0.0f) : y;
  }
};

/// The index by a code's steps, one after the other.  Domain: n in 0..16.
template <class Code>
std::uint32_t index_by(float u, float v, Level n) {
  using Whole = std::int32_t;
  const auto N = static_cast<float>(Whole{1} << n);
  const auto pu = Code::template cut<Whole, float>(Code::scaled(u, N)),
             pv = Code::template cut<Whole, float>(Code::scaled(v, N));
  return impl::index::detail::curve(Code::template square<std::uint32_t>(
      static_cast<std::uint32_t>(pu.whole), static_cast<std::uint32_t>(pv.whole),
      Code::reach_one(pu.part, pv.part), std::uint32_t{1} << n));
}

template <class Code>
Mutant wrong(const char* name, WithStatements::Statements statements) {
  Functions functions = built_in("impl")->functions;
  on_floats([](Level n, float u, float v, std::uint32_t) { return index_by<Code>(u, v, n); })(functions);
  return {name, std::make_shared<WithStatements>(name, std::move(functions), statements), {0, 16}};
}

template <class Code>
Mutant wrong_scalar(const char* name) {
  return wrong<Code>(name, [] { return statements_of(scalar_steps<Code>(), lane_steps()); });
}

}  // namespace

std::vector<Mutant> mutants() {
  return {wrong_scalar<PlainSum>("uf+vf >= 1 of the rounded sum"),
          wrong_scalar<BothFromOne>("1-uf-vf <= 0, both rounded"),
          wrong_scalar<LesserFromOne>("greater >= 1 - lesser, which rounds"),
          wrong_scalar<BiasedByOne>("uN + 1 - 1"),
          wrong_scalar<BiasedUp>("whole parts of uN + 2^-25"),
          wrong_scalar<DeafToSmall>("uN below 2^-23 taken for 0"),
          wrong<PlainSum>("the rounded sum in vectors alone", [] {
            return statements_of(scalar_steps<Implemented>(), lane_steps_of_plain_sums());
          })};
}

}  // namespace mmverify::proofs::index::binary32
