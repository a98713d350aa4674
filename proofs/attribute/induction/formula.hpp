// The orders' formulas in their parts, so that a mutant can have one of them wrong: as the specification has them, here;
// and the orders that come of them, on numbers.
#pragma once

#include "proofs/attribute/subject.hpp"
#include "spec/attribute/order.hpp"

namespace mmverify::proofs::attribute::induction {

namespace specified = spec::attribute;
using specified::EdgeMiddle;
using specified::FaceOf;
using specified::UprightExcess;
using specified::VertexOf;

/// The parts as functions of one kind of number, or of names.  Signed is the kind of an excess, which may be below 0.
template <class Word, class Signed = Word>
struct Parts {
  Word (*triangular_root_turn)(const Word& x, const Word& r, const Word& bit);
  Word (*square_root_turn)(const Word& x, const Word& r, const Word& bit);
  Word (*w_minor)(Word i, Word j);
  VertexOf<Word> (*w_minor_in_row)(const Word& x, const Word& r);
  Word (*u_major)(const Word& i, const Word& j, const Word& N);
  VertexOf<Word> (*u_major_in_row)(const Word& y, const Word& r, const Word& N);
  Word (*rows)(Word iu, Word iv, bool upper);
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
/// The specification's.
template <class Word, class Signed = Word>
Parts<Word, Signed> specified_parts() {
  return {.triangular_root_turn = specified::triangular_root_turn<Word>,
          .square_root_turn = spec::index::square_root_turn<Word>,
          .w_minor = specified::w_minor_index<Word>,
          .w_minor_in_row = specified::w_minor_in_row<Word>,
          .u_major = specified::u_major_of_side<Word>,
          .u_major_in_row = specified::u_major_in_row<Word>,
          .rows = specified::row_index<Word>,
          .row_face = specified::row_face<Word>,
          .u_major_face = specified::u_major_face_of_side<Word>,
          .u_major_face_in_strip = specified::u_major_face_in_strip<Word>,
          .corners = specified::corners_of_square<Word>,
          .face_of_corners = specified::face_of_corners<Word>,
          .corners_turn = spec::index::corners_turn<VertexOf<Word>>,
          .upright_turn = specified::upright_turn<Signed>,
          .upright_child = specified::upright_child<Word>,
          .bird_corner = specified::bird_corner<Word>,
          .halved = specified::halved<Word>,
          .edge_middle = specified::edge_middle<Word>,
          .in_the_middle = specified::in_the_middle<Word>,
          .bird_number = specified::bird_number<Word>};
}

/// The orders that iterate the parts as the specification iterates its own, as a subject has them.
using PartsOnNumbers = Parts<std::uint64_t, std::int64_t>;
Orders orders_by(const PartsOnNumbers& parts);

}  // namespace mmverify::proofs::attribute::induction
