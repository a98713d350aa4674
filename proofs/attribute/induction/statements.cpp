#include "proofs/attribute/induction/statements.hpp"

#include "proofs/attribute/induction/bird_lemmas.hpp"
#include "proofs/attribute/induction/curve_lemmas.hpp"
#include "proofs/attribute/induction/lemmas.hpp"

namespace mmverify::proofs::attribute::induction {

std::vector<Statement> w_minor_statements(const Parts<Counted>& by) {
  std::vector<Statement> all;
  add_triangular(all);
  add_triangular_root(all, by);
  add_w_minor(all, by);
  return all;
}

std::vector<Statement> u_major_statements(const Parts<Counted>& by) {
  std::vector<Statement> all;
  add_triangular(all);
  add_triangular_root(all, by);
  add_u_major(all, by);
  return all;
}

std::vector<Statement> bird_statements(const Parts<Counted>& by) {
  std::vector<Statement> all;
  add_triangular(all);
  add_curve_words(all);
  add_curve_corners(all, by);
  add_upright(all, by);
  add_bird(all, by);
  return all;
}

std::vector<Statement> faces_statements(const Parts<Counted>& by) {
  std::vector<Statement> all;
  add_square(all);
  add_square_root(all, by);
  add_faces(all, by);
  add_curve_words(all);
  add_curve_corners(all, by);
  return all;
}

}  // namespace mmverify::proofs::attribute::induction
