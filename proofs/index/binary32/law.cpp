#include "proofs/index/binary32/law.hpp"

#include "proofs/index/binary32/lemmas.hpp"
#include "proofs/index/binary32/search.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/mutants.hpp"

namespace mmverify::proofs::index::binary32 {

namespace {

using Judge = Tally (*)(const IndexSubject&, Level, const Run&, std::uint64_t samples);

/// Settles the statements; a sample that the judge has is searched for a counterexample.
proofs::induction::Settle with_search_by(Judge judge) {
  return [judge](const std::vector<Statement>& statements, const Subject& s, const Run& run) {
    return proofs::induction::discharge(
        statements,
        {[&] { return counterexamples(judge, subject_as<IndexSubject>(s), run); }, where_searched()}, run);
  };
}

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

std::vector<proofs::induction::Statement> shipped() {
  return statements_of(scalar_steps<Implemented>(), lane_steps());
}

Law law() {
  return proofs::induction::on_statements(
      {.id = "index.floats",
       .says =
           "for every pair of binary32 numbers, at every level 0..16, the library's index, one value at a "
           "time and in vectors, is that of the exact reference; in 64-bit words at every level 0..30",
       .source = vulkan,
       .method = Method::bit_vectors,
       .subjects = {"impl"},
       .tiers = {.seconds = 8},
       .at_once = "levels 0..30",
       .domain = "every pair of binary32 bit patterns, levels 0..16 together, 64-bit words 0..30",
       .replay = replayed_by(replay_equals_reference),
       .mutants = mutants()},
      {{"impl", shipped}}, with_search_by(exact_on_floats));
}

std::vector<proofs::induction::Statement> shipped_rows() {
  return own_row_statements(scalar_steps<Implemented>(), lane_steps());
}

Law row_law() {
  const auto statements = [] { return row_statements_of(scalar_steps<Implemented>(), lane_steps()); };
  return proofs::induction::on_statements(
      {.id = "index.row_floats",
       .says = "for every pair of binary32 numbers, at every level 0..16, the library's index in row order, "
               "one value at a time and in vectors, is that of figure 4 in exact arithmetic",
       .source = attribute_4,
       .method = Method::bit_vectors,
       .subjects = {"impl"},
       .tiers = {.seconds = 2},
       .at_once = "levels 0..16",
       .domain = "every pair of binary32 bit patterns, clamped to [0,1] each, levels 0..16 together",
       .replay = replayed_by(replay_row_order),
       .mutants = {wrong_rows<LineInNextColumn>("N - 1 - floor(uN) in the place of floor((1-u)N)"),
                   wrong_rows<RowWithoutEnd>("the hypotenuse in a row of its own"),
                   wrong_rows<DeafBesideLines>("uf up to 2^-21 taken for 0")}},
      {{"impl", statements}}, with_search_by(row_exact_on_floats));
}

}  // namespace mmverify::proofs::index::binary32
