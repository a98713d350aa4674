// The orders' formulas in their parts, so that a mutant can have one of them wrong: as the specification has them, here;
// and the orders that come of them, on numbers.
#pragma once

#include <array>
#include <cstdint>

#include "proofs/attribute/subject.hpp"
#include "spec/attribute/order.hpp"

namespace mmverify::proofs::attribute::induction {

namespace specified = spec::attribute;
using specified::EdgeMiddle;
using specified::FaceOf;
using specified::UprightExcess;
using specified::VertexOf;

struct Specified {
  template <class Word>
  static Word triangular_root_turn(const Word& x, const Word& r, const Word& bit) {
    return specified::triangular_root_turn(x, r, bit);
  }
  template <class Word>
  static Word square_root_turn(const Word& x, const Word& r, const Word& bit) {
    return spec::index::square_root_turn(x, r, bit);
  }
  template <class Word>
  static Word w_minor(const Word& i, const Word& j) {
    return specified::w_minor_index(i, j);
  }
  template <class Word>
  static VertexOf<Word> w_minor_in_row(const Word& x, const Word& r) {
    return specified::w_minor_in_row(x, r);
  }
  template <class Word>
  static Word u_major(const Word& i, const Word& j, const Word& N) {
    return specified::u_major_of_side(i, j, N);
  }
  template <class Word>
  static VertexOf<Word> u_major_in_row(const Word& y, const Word& r, const Word& N) {
    return specified::u_major_in_row(y, r, N);
  }
  template <class Word>
  static Word rows(const Word& iu, const Word& iv, bool upper) {
    return specified::row_index(iu, iv, upper);
  }
  template <class Word>
  static FaceOf<Word> row_face(const Word& x, const Word& r) {
    return specified::row_face(x, r);
  }
  template <class Word>
  static Word u_major_face(const Word& iu, const Word& iv, bool upper, const Word& N) {
    return specified::u_major_face_of_side(iu, iv, upper, N);
  }
  template <class Word>
  static FaceOf<Word> u_major_face_in_strip(const Word& x, const Word& r, const Word& N) {
    return specified::u_major_face_in_strip(x, r, N);
  }
  template <class Word>
  static std::array<VertexOf<Word>, 3> corners(const Word& iu, const Word& iv, bool upper) {
    return specified::corners_of_square(iu, iv, upper);
  }
  template <class Word>
  static FaceOf<Word> face_of_corners(const VertexOf<Word>& first, const VertexOf<Word>& second) {
    return specified::face_of_corners(first, second);
  }
  template <class At>
  static std::array<At, 3> corners_turn(const std::array<At, 3>& P, std::uint32_t digit) {
    return spec::index::corners_turn(P, digit);
  }
  template <class Word>
  static UprightExcess<Word> upright_turn(const UprightExcess<Word>& at, std::uint64_t digit, const Word& S) {
    return specified::upright_turn(at, digit, S);
  }
  template <class Word>
  static std::uint64_t upright_child(Word& k, const Word& S, bool upright) {
    return specified::upright_child(k, S, upright);
  }
  template <class Word>
  static std::uint64_t bird_corner(const Word& i, const Word& j, const Word& N) {
    return specified::bird_corner(i, j, N);
  }
  template <class Word>
  static bool halved(VertexOf<Word>& at) {
    return specified::halved(at);
  }
  template <class Word>
  static EdgeMiddle<Word> edge_middle(const VertexOf<Word>& at) {
    return specified::edge_middle(at);
  }
  template <class Word>
  static VertexOf<Word> in_the_middle(const EdgeMiddle<Word>& m) {
    return specified::in_the_middle(m);
  }
  template <class Word>
  static Word bird_number(const Word& before, const Word& edge, const Word& M) {
    return specified::bird_number(before, edge, M);
  }
};

/// The parts as functions of one kind of number, or of names.  Signed is the kind of an excess, which may be below 0.
template <class Word, class Signed = Word>
struct Parts {
  Word (*triangular_root_turn)(const Word& x, const Word& r, const Word& bit);
  Word (*square_root_turn)(const Word& x, const Word& r, const Word& bit);
  Word (*w_minor)(const Word& i, const Word& j);
  VertexOf<Word> (*w_minor_in_row)(const Word& x, const Word& r);
  Word (*u_major)(const Word& i, const Word& j, const Word& N);
  VertexOf<Word> (*u_major_in_row)(const Word& y, const Word& r, const Word& N);
  Word (*rows)(const Word& iu, const Word& iv, bool upper);
  FaceOf<Word> (*row_face)(const Word& x, const Word& r);
  Word (*u_major_face)(const Word& iu, const Word& iv, bool upper, const Word& N);
  FaceOf<Word> (*u_major_face_in_strip)(const Word& x, const Word& r, const Word& N);
  std::array<VertexOf<Word>, 3> (*corners)(const Word& iu, const Word& iv, bool upper);
  FaceOf<Word> (*face_of_corners)(const VertexOf<Word>& first, const VertexOf<Word>& second);
  std::array<VertexOf<Word>, 3> (*corners_turn)(const std::array<VertexOf<Word>, 3>& P, std::uint32_t digit);
  UprightExcess<Signed> (*upright_turn)(const UprightExcess<Signed>& at, std::uint64_t digit,
                                        const Signed& S);
  std::uint64_t (*upright_child)(Word& k, const Word& S, bool upright);
  std::uint64_t (*bird_corner)(const Word& i, const Word& j, const Word& N);
  bool (*halved)(VertexOf<Word>& at);
  EdgeMiddle<Word> (*edge_middle)(const VertexOf<Word>& at);
  VertexOf<Word> (*in_the_middle)(const EdgeMiddle<Word>& m);
  Word (*bird_number)(const Word& before, const Word& edge, const Word& M);
};
template <class Formula, class Word, class Signed = Word>
Parts<Word, Signed> parts_of() {
  return {.triangular_root_turn = &Formula::template triangular_root_turn<Word>,
          .square_root_turn = &Formula::template square_root_turn<Word>,
          .w_minor = &Formula::template w_minor<Word>,
          .w_minor_in_row = &Formula::template w_minor_in_row<Word>,
          .u_major = &Formula::template u_major<Word>,
          .u_major_in_row = &Formula::template u_major_in_row<Word>,
          .rows = &Formula::template rows<Word>,
          .row_face = &Formula::template row_face<Word>,
          .u_major_face = &Formula::template u_major_face<Word>,
          .u_major_face_in_strip = &Formula::template u_major_face_in_strip<Word>,
          .corners = &Formula::template corners<Word>,
          .face_of_corners = &Formula::template face_of_corners<Word>,
          .corners_turn = &Formula::template corners_turn<VertexOf<Word>>,
          .upright_turn = &Formula::template upright_turn<Signed>,
          .upright_child = &Formula::template upright_child<Word>,
          .bird_corner = &Formula::template bird_corner<Word>,
          .halved = &Formula::template halved<Word>,
          .edge_middle = &Formula::template edge_middle<Word>,
          .in_the_middle = &Formula::template in_the_middle<Word>,
          .bird_number = &Formula::template bird_number<Word>};
}

/// The orders that iterate the parts as the specification iterates its own, as a subject has them.
using PartsOnNumbers = Parts<std::uint64_t, std::int64_t>;
Orders orders_by(const PartsOnNumbers& parts);

}  // namespace mmverify::proofs::attribute::induction
