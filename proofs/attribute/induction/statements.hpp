// Which lemmas each law follows from.
#pragma once

#include "proofs/attribute/induction/bird_lemmas.hpp"
#include "proofs/attribute/induction/lemmas.hpp"

namespace mmverify::proofs::attribute::induction {

template <class Formula>
std::vector<Statement> w_minor_statements() {
  std::vector<Statement> all;
  add_triangular(all);
  add_triangular_root<Formula>(all);
  add_w_minor<Formula>(all);
  return all;
}

template <class Formula>
std::vector<Statement> u_major_statements() {
  std::vector<Statement> all;
  add_triangular(all);
  add_triangular_root<Formula>(all);
  add_u_major<Formula>(all);
  return all;
}

template <class Formula>
std::vector<Statement> bird_statements() {
  std::vector<Statement> all;
  add_triangular(all);
  add_curve_words(all);
  add_curve_corners<Formula>(all);
  add_upright<Formula>(all);
  add_bird<Formula>(all);
  return all;
}

template <class Formula>
std::vector<Statement> faces_statements() {
  std::vector<Statement> all;
  add_square(all);
  add_square_root<Formula>(all);
  add_faces<Formula>(all);
  add_curve_words(all);
  add_curve_corners<Formula>(all);
  return all;
}

}  // namespace mmverify::proofs::attribute::induction
