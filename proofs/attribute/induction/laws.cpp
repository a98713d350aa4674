// attribute.w_minor_all_levels, u_major_all_levels, bird_all_levels and faces_all_levels.
#include "proofs/attribute/laws.hpp"

#include "proofs/attribute/induction/lemmas.hpp"
#include "proofs/attribute/induction/provable.hpp"
#include "proofs/attribute/law_parts.hpp"
#include "proofs/engine/interrupt.hpp"

namespace mmverify::proofs::attribute::induction {
namespace {

constexpr char about[] = "attribute-spec";
/// Indices are compared with walks, and each way back is gone, on all elements of the levels up to here.
constexpr Level search = 8;

/// The laws, level by level, that say of numbers what the statements say of names.
std::vector<Law> level_by_level(const std::vector<std::string>& ids) {
  std::vector<Law> all;
  for (Law& law : order_laws())
    if (std::find(ids.begin(), ids.end(), law.id) != ids.end()) all.push_back(std::move(law));
  return all;
}

std::vector<Counterexample> counterexamples(const std::vector<Law>& beside, const Subject& subject,
                                            const Run& run) {
  Run quick = run;
  quick.progress = nullptr;
  for (Level n = 0; n <= search && !interrupted(); ++n)
    for (const Law& law : beside) {
      std::vector<Counterexample> found = law.judge(subject, n, quick).found();
      for (Counterexample& c : found) c.level = n;
      if (!found.empty()) return found;
    }
  return {};
}

Replayed replay(const std::vector<Law>& beside, const Subject& subject, Level n, const std::string& at) {
  Replayed last{true, "ok", "ok", {}};
  std::size_t unread = 0;
  for (const Law& law : beside) try {
      last = law.replay(subject, n, at);
      if (!last.holds) return last;
    } catch (const BadCase&) {
      if (++unread == beside.size()) throw;
    }
  return {true, "ok", "ok", {}};
}

struct Written {
  const char *id, *says, *domain;
  std::vector<Statement> (*statements)();
  std::vector<Mutant> (*mutants)();
  std::vector<std::string> beside;
};

Law for_all_levels(const Written& w) {
  const std::vector<Law> beside = level_by_level(w.beside);
  Law law = proofs::induction::on_statements(
      {.id = w.id,
       .says = w.says,
       .source = cam_2,
       .method = Method::induction,
       .subjects = {about},
       .tiers = {.seconds = 1},
       .at_once = "all levels",
       .domain = w.domain,
       .mutants = w.mutants()},
      {{about, w.statements}},
      [beside](const std::vector<Statement>& statements, const Subject& s, const Run& run) {
        return proofs::induction::discharge(statements,
                                            {[&] { return counterexamples(beside, s, run); },
                                             fmt::format("the vertices and faces of levels 0..{}", search)},
                                            run);
      });
  law.unfit = unless_of_topic<AttributeSubject>(law.unfit);
  law.replay = [beside](const Subject& s, Level n, const std::string& at) {
    return replay(beside, s, n, at);
  };
  return law;
}

}  // namespace

std::vector<Statement> shipped_w_minor() { return w_minor_statements(specified_parts<Counted>()); }
std::vector<Statement> shipped_u_major() { return u_major_statements(specified_parts<Counted>()); }
std::vector<Statement> shipped_bird() { return bird_statements(specified_parts<Counted>()); }
std::vector<Statement> shipped_faces() { return faces_statements(specified_parts<Counted>()); }

std::vector<Law> laws() {
  return {for_all_levels(
              {"attribute.w_minor_all_levels",
               "at every level n >= 0 W-minor is a bijection from the vertices to 0..V(n)-1 with its way "
               "back, each level begins with the rows of the level before, number by number, and of a vertex "
               "that two levels share the finer one's number is greater, the w-corner's 0 apart",
               "every vertex of every level n >= 0",
               shipped_w_minor,
               mutants_of_w_minor,
               {"attribute.order_is_walk", "attribute.order_inverse", "attribute.order_prefix_nested"}}),
          for_all_levels(
              {"attribute.u_major_all_levels",
               "at every level n >= 0 U-major is a bijection from the vertices to 0..V(n)-1 with its way "
               "back, is W-minor of the vertex turned, (j, N-i-j), counted from the end, and of a vertex "
               "that two levels share the finer one's number is greater, the w-corner's 0 apart",
               "every vertex of every level n >= 0",
               shipped_u_major,
               mutants_of_u_major,
               {"attribute.order_is_walk", "attribute.order_inverse", "attribute.umajor_is_reversed_rows"}}),
          for_all_levels({"attribute.bird_all_levels",
                          "at every level n >= 0 Bird is a bijection from the vertices to 0..V(n)-1 with its "
                          "way back, a vertex has one number on all levels that have it, and level n+1 adds "
                          "one triplet for each upright micro-triangle of level n, along the curve: the "
                          "middles of its edges, which are nobody else's",
                          "every vertex of every level n >= 0",
                          shipped_bird,
                          mutants_of_bird,
                          {"attribute.order_is_walk", "attribute.order_inverse", "attribute.bird_prefix"}}),
          for_all_levels(
              {"attribute.faces_all_levels",
               "at every level n >= 0 the faces' curve, rows and U-major are bijections to 0..4^n-1 with "
               "their ways back, U-major is the rows turned and counted from the end, and a face's three "
               "corners are vertices of the level that wind like the base triangle and tell the face",
               "every face of every level n >= 0",
               shipped_faces,
               mutants_of_faces,
               {"attribute.face_orders", "attribute.triangle_vertices"}})};
}

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
