#include "proofs/attribute/induction/lemmas.hpp"
#include "proofs/attribute/induction/provable.hpp"

namespace mmverify::proofs::attribute::induction {
namespace {

Functions functions_by(const PartsOnNumbers& parts) {
  Functions f;
  f.orders = orders_by(parts);
  return f;
}

/// The specification's parts with one altered, on numbers as on names.
template <class Alteration, class Word, class Signed = Word>
Parts<Word, Signed> altered() {
  auto by = specified_parts<Word, Signed>();
  Alteration::alter(by);
  return by;
}

/// An altered part, run on numbers and in the statements where it takes the right one's place.
class Wrong : public AttributeSubject, public Provable {
 public:
  using Statements = std::vector<Statement> (*)(const Parts<Counted>& by);
  Wrong(const std::string& name, Functions functions, const Parts<Counted>& by, Statements statements)
      : AttributeSubject(name, "broken on purpose", std::move(functions)), by_(by), statements_(statements) {}
  std::vector<Statement> statements() const override { return statements_(by_); }

 private:
  Parts<Counted> by_;
  Statements statements_;
};

template <class Alteration>
Mutant wrong(const char* name, Wrong::Statements statements, Level at) {
  return {name,
          std::make_shared<Wrong>(name, functions_by(altered<Alteration, std::uint64_t, std::int64_t>()),
                                  altered<Alteration, Counted>(), statements),
          {at, at}};
}

// ---- W-minor

struct SixteenRows {
  template <class Word, class Signed>
  static void alter(Parts<Word, Signed>& by) {
    by.w_minor = [](Word i, Word j) -> Word {
      using spec::attribute::triangular;
      const Word r = i + j < Word(16) ? i + j : Word(15);
      return triangular(r) + j;
    };
  }
};

struct RowsBeginOneLate {
  template <class Word, class Signed>
  static void alter(Parts<Word, Signed>& by) {
    by.triangular_root_turn = [](const Word& x, const Word& r, const Word& bit) -> Word {
      // The first index of a row goes to the row before.
      return specified::triangular_root_turn<Word>(x - 1, r, bit);
    };
  }
};

struct RowsFromTheOtherEnd {
  template <class Word, class Signed>
  static void alter(Parts<Word, Signed>& by) {
    by.w_minor_in_row = [](const Word& x, const Word& r) -> VertexOf<Word> {
      const VertexOf<Word> at = specified::w_minor_in_row(x, r);
      return {at.j, at.i};
    };
  }
};

// ---- U-major

struct ColumnsOfOneLength {
  template <class Word, class Signed>
  static void alter(Parts<Word, Signed>& by) {
    by.u_major = [](const Word& i, const Word& j, const Word& N) -> Word { return i * (N + 1) + j; };
  }
};

struct EightColumnsGetShorter {
  template <class Word, class Signed>
  static void alter(Parts<Word, Signed>& by) {
    by.u_major = [](const Word& i, const Word& j, const Word& N) -> Word {
      if (!(Word(9) < i)) return specified::u_major_of_side(i, j, N);
      return specified::u_major_of_side(Word(9), j, N) + (i - 9) * (N - 8);
    };
  }
};

struct ColumnsBackwards {
  template <class Word, class Signed>
  static void alter(Parts<Word, Signed>& by) {
    by.u_major_in_row = [](const Word& y, const Word& r, const Word& N) -> VertexOf<Word> {
      const VertexOf<Word> at = specified::u_major_in_row(y, r, N);
      return {at.i, r - at.j};
    };
  }
};

// ---- Faces

struct UpperOnesInTheRowBelow {
  template <class Word, class Signed>
  static void alter(Parts<Word, Signed>& by) {
    by.rows = [](Word iu, Word iv, bool upper) -> Word {
      const Word lower = specified::row_index(iu, iv, false);
      return upper ? lower + 1 : lower;
    };
  }
};

struct EightStripsGetShorter {
  template <class Word, class Signed>
  static void alter(Parts<Word, Signed>& by) {
    by.u_major_face = [](const Word& iu, const Word& iv, bool upper, const Word& N) -> Word {
      if (!(Word(8) < iu)) return specified::u_major_face_of_side(iu, iv, upper, N);
      return specified::u_major_face_of_side(Word(8), iv, upper, N) + (iu - 8) * (2 * N - 17);
    };
  }
};

struct UpperOnesWindTheOtherWay {
  template <class Word, class Signed>
  static void alter(Parts<Word, Signed>& by) {
    by.corners = [](const Word& iu, const Word& iv, bool upper) -> std::array<VertexOf<Word>, 3> {
      const auto c = specified::corners_of_square(iu, iv, upper);
      if (!upper) return c;
      return {c[0], c[2], c[1]};
    };
  }
};

struct ChildThreeIsNotTurned {
  template <class Word, class Signed>
  static void alter(Parts<Word, Signed>& by) {
    by.corners_turn = [](const std::array<VertexOf<Word>, 3>& P,
                         std::uint32_t digit) -> std::array<VertexOf<Word>, 3> {
      const auto right = spec::index::corners_turn(P, digit);
      if (digit != 3) return right;
      return {right[1], right[0], right[2]};
    };
  }
};

// ---- Bird

struct TripletsBeginWithUV {
  template <class Word, class Signed>
  static void alter(Parts<Word, Signed>& by) {
    by.edge_middle = [](const VertexOf<Word>& at) -> EdgeMiddle<Word> {
      const EdgeMiddle<Word> right = specified::edge_middle(at);
      return {right.iu, right.iv, (right.edge + 2) % 3};
    };
  }
};

struct MiddlesKeepTheSign {
  template <class Word, class Signed>
  static void alter(Parts<Word, Signed>& by) {
    by.upright_turn = [](const UprightExcess<Signed>& at, std::uint64_t digit,
                         const Signed& S) -> UprightExcess<Signed> {
      return {specified::upright_turn(at, digit, S).excess, at.upright};
    };
  }
};

struct ChildrenOfFourHoldTwo {
  template <class Word, class Signed>
  static void alter(Parts<Word, Signed>& by) {
    by.upright_turn = [](const UprightExcess<Signed>& at, std::uint64_t digit,
                         const Signed& S) -> UprightExcess<Signed> {
      return specified::upright_turn<Signed>(at, digit, S < Signed(4) ? S : Signed(2));
    };
  }
};

struct BeginsAtTheRowBefore {
  template <class Word, class Signed>
  static void alter(Parts<Word, Signed>& by) {
    by.bird_number = [](const Word& before, const Word& edge, const Word& M) -> Word {
      // Level m-1 has T(M+1) vertices; M more are left out.
      return specified::bird_number<Word>(before, edge, M - 1);
    };
  }
};

struct MiddleTakenForUpright {
  template <class Word, class Signed>
  static void alter(Parts<Word, Signed>& by) {
    by.upright_child = [](Word& k, const Word& S, bool upright) -> std::uint64_t {
      // Child 1 is taken for one that stands as its parent does.
      std::uint64_t digit = 0;
      for (; digit < 3; ++digit) {
        const Word inside = specified::upright_within(S, upright);
        if (k < inside) break;
        k = k - inside;
      }
      return digit;
    };
  }
};

}  // namespace

std::vector<Mutant> mutants_of_w_minor() {
  return {wrong<SixteenRows>("rows from number 16 on begin where row 15 does", w_minor_statements, 4),
          wrong<RowsBeginOneLate>("a row's first index is taken for the row before", w_minor_statements, 0),
          wrong<RowsFromTheOtherEnd>("the way back counts j from the edge w-v", w_minor_statements, 0)};
}

std::vector<Mutant> mutants_of_u_major() {
  return {wrong<ColumnsOfOneLength>("each column has N+1 vertices", u_major_statements, 1),
          wrong<EightColumnsGetShorter>("columns from number 9 on have one length", u_major_statements, 4),
          wrong<ColumnsBackwards>("the way back reads columns from their far end", u_major_statements, 0)};
}

std::vector<Mutant> mutants_of_faces() {
  return {wrong<UpperOnesInTheRowBelow>("an upper face has its square's row", faces_statements, 1),
          wrong<EightStripsGetShorter>("strips from number 8 on have one length", faces_statements, 4),
          wrong<UpperOnesWindTheOtherWay>("an upper face's corners wind the other way", faces_statements, 1),
          wrong<ChildThreeIsNotTurned>("on the way back child 3 does not change the first two corners",
                                       faces_statements, 2)};
}

std::vector<Mutant> mutants_of_bird() {
  return {wrong<TripletsBeginWithUV>("triplets begin with the edge u-v", bird_statements, 1),
          wrong<MiddlesKeepTheSign>("a middle child's children are counted as if it were not turned",
                                    bird_statements, 3),
          wrong<ChildrenOfFourHoldTwo>("children with 4 to a side or more are counted as with 2",
                                       bird_statements, 4),
          wrong<BeginsAtTheRowBefore>("a level's vertices begin at T(M), not at T(M+1)", bird_statements, 1),
          wrong<MiddleTakenForUpright>("the way back takes the middle child for an upright one",
                                       bird_statements, 2)};
}

AttributeSubjectPtr specified_by_parts() {
  return std::make_shared<AttributeSubject>("attribute-spec-by-parts", "the specification's parts",
                                            functions_by(specified_parts<std::uint64_t, std::int64_t>()));
}

}  // namespace mmverify::proofs::attribute::induction
