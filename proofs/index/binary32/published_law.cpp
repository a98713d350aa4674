// index.published_differs_where: on which pairs of binary32 numbers the published code has another index than exact
// arithmetic, and which.
#include "proofs/engine/interrupt.hpp"
#include "proofs/index/binary32/law.hpp"
#include "proofs/index/binary32/published_lemmas.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/mutants.hpp"
#include "proofs/index/picture.hpp"

namespace mmverify::proofs::index::binary32 {
namespace {

constexpr Level highest_level = 16;
constexpr std::uint64_t pairs_compared = 1 << 12;  // a level

/// The index that the law says a pair has in binary32, by exact numbers.
std::uint32_t predicted(const RationalPoint& p, Level n) {
  const std::uint32_t N = side(n);
  const auto scaled = [N](const Rational& q) { return times(N, spec::index::within_unit(q)); };
  const Rational un = scaled(p.u), vn = scaled(p.v);
  const std::uint32_t iu = whole(un), iv = whole(vn);
  const Rational sum = un - Rational(iu) + vn - Rational(iv);
  const Rational least(spec::Integer((1 << 25) - 1), spec::Integer(1 << 25));
  return spec::index::curve(spec::index::grid_square<std::uint32_t>(iu, iv, !(sum < least), N), N - 1);
}

std::vector<Counterexample> off_prediction(const IndexSubject& s, const Run& run) {
  Run quick = run;
  quick.progress = nullptr;
  for (Level n = 0; n <= highest_level && !interrupted(); ++n) {
    const Tally tally = sweep(quick, pairs_compared, 256, [&](Chunk chunk, Tally& part) {
      for (std::uint64_t k = chunk.begin; k < chunk.end; ++k) {
        FloatPair pair = stiff_floats(n, run.seed, k);
        std::uint32_t got = 0;
        s.functions.index_floats(n, FloatBatch{{&pair.u, 1}, {&pair.v, 1}}, {&got, 1});
        const RationalPoint p{rational(pair.u), rational(pair.v)};
        const std::uint32_t want = predicted(p, n);
        part.count(Kind::interior, 1);
        part.digest(k, got);
        if (got != want)
          part.mismatch(Kind::interior, simplicity(p), [&] {
            return Counterexample{simplicity(p),           n,
                                  case_text(p, n),         hex_text(p),
                                  fmt::format("{}", want), fmt::format("{}", got)};
          });
      }
    });
    if (!tally.found().empty()) return tally.found();
  }
  return {};
}

Replayed replay_published_set(const IndexSubject& s, Level n, const std::string& at) {
  const RationalPoint p = received_point(s, at);
  const std::uint32_t want = predicted(p, n), got = s.functions.index_at(n, p);
  return {want == got, fmt::format("{}", want), fmt::format("{}", got),
          picture(n, p, want, got, Order::curve)};
}

struct OnlyAboveOne : Printed {
  template <class Word, class Q>
  static spec::index::Quantised<Word> square(const Q& un, const Q& vn, const Word& N) {
    const Q one(1), uf = un - Q(whole(un)), vf = vn - Q(whole(vn));
    return spec::index::grid_square<Word>(whole(un), whole(vn), one < uf + vf, N);
  }
};

struct OthersFromOne : Printed {
  template <class Word, class Q>
  static spec::index::Quantised<Word> square(const Q& un, const Q& vn, const Word& N) {
    const Q one(1), uf = un - Q(whole(un)), vf = vn - Q(whole(vn));
    return spec::index::grid_square<Word>(whole(un), whole(vn), !(Q(0) < one - uf - vf), N);
  }
};

/// The comparison that is exact: never wrong, and so not where the law says.
struct NeverRounded : Printed {
  template <class Word, class Q>
  static spec::index::Quantised<Word> square(const Q& un, const Q& vn, const Word& N) {
    const Q one(1), uf = un - Q(whole(un)), vf = vn - Q(whole(vn));
    const bool u_less = uf < vf;
    return spec::index::grid_square<Word>(whole(un), whole(vn), u_less ? !(uf < one - vf) : !(vf < one - uf),
                                          N);
  }
};

template <class Code>
Mutant wrong_text(const char* name) {
  Functions functions = built_in("reference-f32")->functions;
  on_floats([](Level n, float u, float v, std::uint32_t) {
    const auto N = static_cast<float>(side(n));
    const std::uint32_t words = side(n);
    return spec::index::curve(Code::template square<std::uint32_t, float>(
                                  N * spec::index::within_unit(u), N * spec::index::within_unit(v), words),
                              words - 1);
  })(functions);
  return {name,
          std::make_shared<WithStatements>(name, std::move(functions), published_statements<Code>),
          {0, highest_level}};
}

}  // namespace

std::vector<Statement> shipped_published() { return published_statements<Printed>(); }

Law published_law() {
  return proofs::induction::on_statements(
      {.id = "index.published_differs_where",
       .says =
           "run in binary32 the published code gives another index than in exact arithmetic just where 1 - "
           "2^-25 <= uf+vf < 1 and floor(uN) + floor(vN) < N-1, and there that of the square's other half",
       .source = vulkan,
       .method = Method::bit_vectors,
       .subjects = {"reference-f32"},
       .tiers = {.seconds = 8},
       .at_once = "levels 0..16",
       .domain = "every pair of binary32 numbers, NaN aside, levels 0..16 together",
       .replay = replayed_by(replay_published_set),
       .mutants = {wrong_text<OnlyAboveOne>("uf+vf > 1 of the rounded sum"),
                   wrong_text<OthersFromOne>("1 - uf - vf <= 0 in binary32"),
                   wrong_text<NeverRounded>("the comparison that does not round")}},
      {{"reference-f32", shipped_published}},
      [](const std::vector<Statement>& statements, const Subject& s, const Run& run) {
        return proofs::induction::discharge(
            statements,
            {[&] { return off_prediction(subject_as<IndexSubject>(s), run); },
             fmt::format("{} stiff pairs of each level 0..{}", pairs_compared, highest_level)},
            run);
      });
}

}  // namespace mmverify::proofs::index::binary32
