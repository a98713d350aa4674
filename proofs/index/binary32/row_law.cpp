#include <fmt/format.h>

#include "proofs/index/binary32/law.hpp"
#include "proofs/index/binary32/row_lemmas.hpp"
#include "proofs/index/binary32/search.hpp"
#include "proofs/index/binary32/with_statements.hpp"
#include "proofs/index/judges/judges.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/mutants.hpp"

namespace mmverify::proofs::index::binary32 {
namespace {

/// floor((1-u)N) is N - 1 - floor(uN), but not on the grid's lines.
struct LineInNextColumn : Implemented {
  template <class Word>
  static impl::index::detail::RowPlace<Word> row_place(const Word& iu, const Word& iv, bool carry, bool,
                                                       const Word& N) {
    return Implemented::row_place<Word>(iu, iv, carry, true, N);
  }
};

/// Beyond the last row on the hypotenuse.
struct RowWithoutEnd : Implemented {
  template <class Word>
  static impl::index::detail::RowPlace<Word> row_place(const Word& iu, const Word& iv, bool carry,
                                                       bool beyond, const Word& N) {
    auto place = Implemented::row_place<Word>(iu, iv, carry, beyond, N);
    const Word diagonal = iu + iv + (carry ? Word{1} : Word{0});
    place.row = diagonal;
    return place;
  }
};

/// Deaf to small parts of u, so that a point a hair beside a line counts for the line.  Below 2^-23 that would be no
/// fault: before the first line dia is N-1 either way.
struct DeafBesideLines : Implemented {
  template <class F>
  static bool is_more_than_none(const F& uf) {
    return uf > F(0x1p-21f);
  }
};

/// The same in row order.
template <class Code>
std::uint32_t row_index_by(float u, float v, Level n) {
  using Whole = std::int32_t;
  const auto N = static_cast<float>(Whole{1} << n);
  const auto pu = Code::template cut<Whole, float>(Code::scaled(u, N)),
             pv = Code::template cut<Whole, float>(Code::scaled(v, N));
  const auto place = Code::template row_place<std::uint32_t>(
      static_cast<std::uint32_t>(pu.whole), static_cast<std::uint32_t>(pv.whole),
      Code::reach_one(pu.part, pv.part), Code::is_more_than_none(pu.part), std::uint32_t{1} << n);
  return place.row * place.row + place.col + (place.dia - ((std::uint32_t{1} << n) - 1 - place.row));
}

template <class Code>
Mutant wrong_rows(const char* name) {
  Functions functions = built_in("impl")->functions;
  on_floats([](Level n, float u, float v, std::uint32_t) { return row_index_by<Code>(u, v, n); })(functions);
  return {
      name,
      std::make_shared<WithStatements>(name, std::move(functions),
                                       [] { return row_statements_of(scalar_steps<Code>(), lane_steps()); }),
      {0, highest}};
}

}  // namespace

std::vector<proofs::induction::Statement> shipped_rows() {
  return own_row_statements(scalar_steps<Implemented>(), lane_steps());
}

Law row_law() {
  const auto statements = [] { return row_statements_of(scalar_steps<Implemented>(), lane_steps()); };
  return {.id = "index.row_floats",
          .says =
              "for every pair of binary32 numbers, at every level 0..16, the library's index in row order, "
              "one value at a time and in vectors, is that of figure 4 in exact arithmetic",
          .source = attribute_4,
          .method = Method::bit_vectors,
          .subjects = {"impl"},
          .tiers = {.seconds = 2},
          .at_once = "levels 0..16",
          .cases = [count = statements().size()](Level, const Run&) -> std::uint64_t { return count; },
          .domain =
              [](const Subject&, Level) {
                return "every pair of binary32 bit patterns, clamped to [0,1] each, levels 0..16 together";
              },
          .how = [](const Subject&, Level) { return "bit vectors, " + proofs::induction::prover_name(); },
          .unfit = [](const Subject& s, Level) -> std::optional<std::string> {
            if (dynamic_cast<const proofs::induction::Provable*>(&s) != nullptr || s.name() == "impl")
              return std::nullopt;
            return fmt::format("no statements about {}: there are some about impl", s.name());
          },
          .judge =
              [statements](const Subject& s, Level, const Run& run) {
                const auto* own = dynamic_cast<const proofs::induction::Provable*>(&s);
                return proofs::induction::discharge(
                    own != nullptr ? own->statements() : statements(),
                    {[&] { return counterexamples(row_exact_on_floats, subject_as<IndexSubject>(s), run); },
                     where_searched()},
                    run);
              },
          .replay = replayed_by(replay_row_order),
          .mutants = {wrong_rows<LineInNextColumn>("N - 1 - floor(uN) in the place of floor((1-u)N)"),
                      wrong_rows<RowWithoutEnd>("the hypotenuse in a row of its own"),
                      wrong_rows<DeafBesideLines>("uf up to 2^-21 taken for 0")}};
}

}  // namespace mmverify::proofs::index::binary32
