// The lemmas about rows, columns, strips and corners, each written by running the specification's own templates on
// names.  No level occurs in them: N, the number of micro-triangles to a side, is a variable, and need be no power of
// two.
#pragma once

#include "proofs/attribute/induction/formula.hpp"
#include "proofs/attribute/induction/names.hpp"

namespace mmverify::proofs::attribute::induction {

/// r(r+1)/2 as the specification computes it, and that it grows.
void add_triangular(std::vector<Statement>& all);
/// The same of r^2.
void add_square(std::vector<Statement>& all);

/// Declares the names of a vertex with N micro-triangles to a side: i, j >= 0, i+j <= N.
VertexOf<Counted> declare_vertex(Script& script, const Counted& N);
/// i, j >= 0, i+j <= N.
Term is_vertex(const VertexOf<Counted>& at, const Counted& N);
Term same_vertex(const VertexOf<Counted>& a, const VertexOf<Counted>& b);
/// iu, iv >= 0, iu+iv < N, and if upper is 1 iu+iv < N-1.
Term is_face(const FaceOf<Counted>& t, const Counted& N);
Term same_face(const FaceOf<Counted>& a, const FaceOf<Counted>& b);
FaceOf<Counted> declare_face(Script& script, const Counted& N);
/// A vertex or a face that a program leaves, its members under names that begin so.
template <class Program>
VertexOf<Counted> vertex_outcome(Script& script, const std::string& prefix, Program program) {
  using At = VertexOf<Counted>;
  return {outcome(script, prefix + "_i", program, [](const At& at) { return at.i; }),
          outcome(script, prefix + "_j", program, [](const At& at) { return at.j; })};
}
template <class Program>
FaceOf<Counted> face_outcome(Script& script, const std::string& prefix, Program program) {
  using Face = FaceOf<Counted>;
  return {outcome(script, prefix + "_iu", program, [](const Face& t) { return t.iu; }),
          outcome(script, prefix + "_iv", program, [](const Face& t) { return t.iv; }),
          outcome(script, prefix + "_upper", program, [](const Face& t) { return t.upper; })};
}
/// An index, of which a program may take branches.
template <class Program>
Counted index_outcome(Script& script, const std::string& name, Program program) {
  return outcome(script, name, program, [](const Counted& x) { return x; });
}

/// A concrete digit as the names have it: `d` is 0, 1, 2 or 3.
inline Counted by_digit(const Counted& d, const std::array<Counted, 4>& of) {
  return Counted(choose(same(d, 0), of[0].term,
                        choose(same(d, 1), of[1].term, choose(same(d, 2), of[2].term, of[3].term))));
}

/// Whether `upper` is 1, decided on a path.
inline bool is_upper(const FaceOf<Counted>& t) { return t.upper == 1; }

/// The loops of triangular_root and of square_root.
void add_triangular_root(std::vector<Statement>& all, const Parts<Counted>& by);
void add_square_root(std::vector<Statement>& all, const Parts<Counted>& by);
/// Vertices in both orders, faces in rows and in strips; there and back.
void add_w_minor(std::vector<Statement>& all, const Parts<Counted>& by);
void add_u_major(std::vector<Statement>& all, const Parts<Counted>& by);
void add_faces(std::vector<Statement>& all, const Parts<Counted>& by);

/// Upright micro-triangles along the curve, counted and found.
void add_upright(std::vector<Statement>& all, const Parts<Counted>& by);
/// Bird's order: corners, halvings, the middles of edges, numbers.
void add_bird(std::vector<Statement>& all, const Parts<Counted>& by);

/// The curve numbers the micro-triangles of every level: a bijection, digit by digit.
void add_curve_words(std::vector<Statement>& all);
/// From a number on the curve back to its micro-triangle, by spec::index::corners.
void add_curve_corners(std::vector<Statement>& all, const Parts<Counted>& by);

std::vector<Statement> w_minor_statements(const Parts<Counted>& by);
std::vector<Statement> u_major_statements(const Parts<Counted>& by);
std::vector<Statement> bird_statements(const Parts<Counted>& by);
std::vector<Statement> faces_statements(const Parts<Counted>& by);

}  // namespace mmverify::proofs::attribute::induction
